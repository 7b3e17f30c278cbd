#pragma once
// Text to pipelines and back. Two forms with one result: a TOML file, or the list of stages on one line. Reading is
// about form alone; whether the names and options exist is for the planner.

#include <foredraw/pipeline/pipeline.h>

#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

/// A pipeline, and what it is called where several stand side by side.
struct NamedPipeline {
  std::string name;
  Pipeline pipeline;
};

/// A TOML file's text; `name` is what diagnostics call it. nullopt where there was any mistake; all are reported.
std::optional<Pipeline> parse_file(std::string_view text, const std::string& name, Diagnostics& diagnostics);

/// The same of a file that may hold several: each row of its [compare] table goes on from the file's stages with its
/// own, and is called "NAME: ROW". In the sequence of the file; without such a table there is one, of the name itself.
std::optional<std::vector<NamedPipeline>> parse_branches(std::string_view text, const std::string& name,
                                                         Diagnostics& diagnostics);

/// What is called `name` and has to be one pipeline alone; several are a mistake (code "has-branches").
std::optional<Pipeline> only_one(std::optional<std::vector<NamedPipeline>> branches, const std::string& name,
                                 Diagnostics& diagnostics);

/// "weld, tipsify(cache-size=16), dot-rule(only=\"Rock_*\")". An empty line is a pipeline without stages.
std::optional<Pipeline> parse_line(std::string_view text, Diagnostics& diagnostics);

/// A list of stages on one line, as for `measure --with`; `name` is what diagnostics call it.
std::optional<std::vector<Stage>> parse_stages(std::string_view text, const std::string& name,
                                               Diagnostics& diagnostics);

std::string print_file(const Pipeline& pipeline);

/// The one-line form; nullopt where the pipeline holds more than stages.
std::optional<std::string> print_line(const Pipeline& pipeline);
std::string print_stage(const Stage& stage);

/// "tipsify.cache-size=24": sets the option (or reserved word) of every stage of that name, among the measures and
/// services too; "views.count=162" and "seed=7" set the pipeline's own. False, with a diagnostic, where there is no
/// such stage (code "no-such-stage") or the text has another form.
bool set_option(Pipeline& pipeline, std::string_view assignment, Diagnostics& diagnostics);

/// What a --pipeline argument names: "@preset", a file, or a line of stages.
std::optional<Pipeline> load_pipeline(const std::string& argument, Diagnostics& diagnostics);
/// The same where a file may hold several.
std::optional<std::vector<NamedPipeline>> load_branches(const std::string& argument, Diagnostics& diagnostics);

}  // namespace foredraw
