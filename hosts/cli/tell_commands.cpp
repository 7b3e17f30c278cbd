// The commands that only tell: what a scene holds, which plugins there are, what they take.

#include "session.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/pipeline/presets.h>
#include <foredraw/pipeline/schema.h>
#include <foredraw/report/inspection.h>
#include <foredraw/report/reference.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::cli {

Exit inspect(const InspectArguments& arguments, const Registry& registry) {
  const ProductRows rows = registry.products();
  Diagnostics diagnostics;
  const std::string& input = arguments.inputs[0];
  const auto file = with_memory(
      input, "read it", [&] { return read_scene(input, diagnostics, input_of(arguments, arguments, registry)); });
  if (!file) return refuse_file(diagnostics);
  tell(diagnostics);
  Analyses analyses;
  const Executor executor(arguments.threads);
  return print(with_memory(input, "inspect it", [&] {
    return arguments.json ? inspection_json(file->scene, rows, diagnostics, analyses, executor)
                          : inspection_text(file->scene, rows, analyses, executor);
  }));
}

Exit list(const ListArguments& arguments, const Registry& registry) {
  std::optional<Kind> kind;
  for (Kind each : {Kind::orderer, Kind::clusterer, Kind::processor, Kind::evaluator}) {
    if (arguments.kind == to_text(each)) kind = each;
  }
  if (!arguments.kind.empty() && !kind) {
    fmt::print(stderr, "foredraw: error: --kind is '{}', but must be orderer, clusterer, processor or evaluator\n",
               arguments.kind);
    return users_mistake;
  }
  return print(arguments.json ? list_json(registry, kind) : list_text(registry, kind));
}

Exit show(const ShowArguments& arguments, const Registry& registry) {
  std::vector<std::string> names = registry.names();
  for (const Preset& preset : presets()) {
    names.push_back(fmt::format("@{}", preset.name));
    if (arguments.name != names.back()) continue;
    return print(std::string(preset.text));
  }
  if (const Plugin* plugin = registry.find(arguments.name)) {
    const ModuleFile* module = registry.module_of(arguments.name);
    return print(arguments.json ? reference_json(*plugin, module) : reference_page(*plugin, module));
  }
  fmt::print(stderr, "foredraw: error: there is no plugin or preset '{}'\n    hint: {}\n", arguments.name,
             registry.hint_for(arguments.name, names));
  return users_mistake;
}

Exit schema(const SchemaArguments& arguments, const Registry& registry) {
  if (arguments.product.empty()) return print(pipeline_schema(registry));
  std::vector<std::string> names;
  for (const auto& row : registry.products()) {
    const ProductCard& card = row->card();
    names.push_back(card.name);
    if (card.name != arguments.product) continue;
    std::vector<std::string> texts;
    for (const auto& [file, text] : card.schemas) texts.push_back(fmt::format("\"{}\": {}", file, text));
    return print(fmt::format("{{{}}}\n", fmt::join(texts, ", ")));
  }
  const std::string_view near = nearest(arguments.product, names);
  fmt::print(
      stderr, "foredraw: error: there is no product '{}'\n    hint: {}\n", arguments.product,
      near.empty() ? fmt::format("there are {}", fmt::join(names, ", ")) : fmt::format("did you mean '{}'?", near));
  return users_mistake;
}

}  // namespace foredraw::cli
