#pragma once
// The words of a pipeline, each in one table: reading, printing, --set and the schema go by these rows.

#include <foredraw/pipeline/pipeline.h>

namespace foredraw {

/// Of a whole pipeline, beside its lists and tables.
OptionTable<Pipeline> pipeline_words();
OptionTable<ViewSet> view_words();
OptionTable<PoseSet> pose_words();
OptionTable<SubjectChoice> subject_words();
OptionTable<FrameSet> frame_words();
/// The reserved words of a stage. Every other word is an option of its plugin.
OptionTable<Stage> stage_words();

/// A stage as words with values, the reserved ones among them.
struct StageWords {
  Settings values;
  std::map<std::string, Where> where;  ///< of each value
};

/// `use`, the other reserved words where they differ from their defaults, and the options.
StageWords words_of(const Stage& stage);

/// The stage at `where` that the words spell. nullopt where `use` is missing or a reserved word has a wrong value.
std::optional<Stage> stage_of(const StageWords& words, const Where& where, Diagnostics& diagnostics);

}  // namespace foredraw
