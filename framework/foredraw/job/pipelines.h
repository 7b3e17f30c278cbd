#pragma once
// The pipelines of a job: as they were read, with the changes that the caller makes to them.

#include <foredraw/pipeline/parse.h>
#include <foredraw/scene/lender.h>
#include <foredraw/technique/registry.h>

#include <optional>
#include <string>
#include <vector>

namespace foredraw {

struct PipelineChanges {
  std::string with = {};              ///< evaluators to measure with; empty: the pipelines' own, else the usual ones
  std::vector<std::string> set = {};  ///< "stage.option=value"
  Settings output = {};               ///< of output_words(), instead of the pipelines' [output]
};

/// Makes the changes. All pipelines then measure alike: with `with`, else as the first does, else with what shows the
/// gains of their stages. An option is set in each pipeline that has its stage; it is a mistake if none has. False,
/// with errors, if something is wrong.
bool change(std::vector<NamedPipeline>& pipelines, const PipelineChanges& changes, const Registry& registry,
            Diagnostics& diagnostics);

/// The only one of them, with the changes made; nullopt, with errors, if there are several (`name` is what they are
/// called) or something is wrong.
std::optional<Pipeline> changed(std::optional<std::vector<NamedPipeline>> pipelines, const std::string& name,
                                const PipelineChanges& changes, const Registry& registry, Diagnostics& diagnostics);

/// True if the pipeline has no mistake that it would have on every scene. `lender` as for plan().
bool is_sound(const Pipeline& pipeline, const Registry& registry, const Lender& lender, Diagnostics& diagnostics);

}  // namespace foredraw
