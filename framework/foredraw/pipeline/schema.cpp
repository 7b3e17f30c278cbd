#include <foredraw/pipeline/schema.h>

#include <foredraw/pipeline/output_words.h>
#include <foredraw/pipeline/private/words.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace foredraw {

namespace {

// Keys stay in the sequence in which they are told.
using Json = nlohmann::ordered_json;

/// 16 rather than 16.0.
Json number(double value) {
  const bool whole = std::floor(value) == value && std::abs(value) < 0x1p53;
  return whole ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

struct ToJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(double value) const { return number(value); }
  Json operator()(const auto& value) const { return value; }
};

Json type_of(OptionType type) {
  switch (type) {
    case OptionType::boolean: return "boolean";
    case OptionType::integer: return "integer";
    case OptionType::number: return "number";
    case OptionType::number_or_text:
    case OptionType::views: return {"integer", "string"};
    case OptionType::numbers: return {"number", "string"};
    case OptionType::scene:
    case OptionType::image:
    case OptionType::text:
    case OptionType::choice: break;
  }
  return "string";
}

Json schema_of(const OptionSpec& spec) {
  Json schema;
  schema["description"] = spec.unit.empty() ? spec.doc : fmt::format("{} ({})", spec.doc, spec.unit);
  schema["type"] = type_of(spec.type);
  if (spec.type == OptionType::choice) schema["enum"] = spec.choices;
  if (std::isfinite(spec.least)) schema["minimum"] = number(spec.least);
  if (std::isfinite(spec.most)) schema["maximum"] = number(spec.most);
  if (!std::holds_alternative<std::monostate>(spec.default_value)) {
    schema["default"] = std::visit(ToJson{}, spec.default_value);
  }
  return schema;
}

Json properties_of(const std::vector<OptionSpec>& rows) {
  Json properties = Json::object();
  for (const OptionSpec& row : rows) properties[row.name] = schema_of(row);
  return properties;
}

Json closed_table(Json properties) {
  return {{"type", "object"}, {"properties", std::move(properties)}, {"additionalProperties", false}};
}

Json reference(const std::string& name) { return {{"$ref", "#/$defs/" + name}}; }

Json stage_table(const Plugin& plugin) {
  Json properties = properties_of(stage_words().specs());
  properties["use"] = {{"const", plugin.card.name}, {"description", plugin.card.summary}};
  properties.update(properties_of(plugin.options));
  Json schema = closed_table(std::move(properties));
  schema["description"] = plugin.card.summary;
  schema["required"] = {"use"};
  return schema;
}

/// A stage of one of the plugins: its name, its one-line form, or its table.
Json any_stage_of(const std::vector<const Plugin*>& plugins) {
  std::vector<std::string> names;
  for (const Plugin* plugin : plugins) names.push_back(plugin->card.name);
  if (names.empty()) return false;
  Json forms = {{{"enum", names}},
                {{"type", "string"}, {"pattern", fmt::format("^\\s*({})\\s*(\\(.*\\)\\s*)?$", fmt::join(names, "|"))}}};
  for (const std::string& name : names) forms.push_back(reference(name));
  return {{"anyOf", forms}};
}

Json list_of(const std::string& what, const std::string& description) {
  return {{"type", "array"}, {"items", reference(what)}, {"description", description}};
}

}  // namespace

std::string pipeline_schema(const Registry& registry) {
  std::vector<const Plugin*> arranging, measuring, overdraw;
  Json definitions;
  for (const Plugin* plugin : registry.all()) {
    (plugin->kind == Kind::evaluator ? measuring : arranging).push_back(plugin);
    if (plugin->overdraw_service) overdraw.push_back(plugin);
    definitions[plugin->card.name] = stage_table(*plugin);
  }
  // No plugin is called with an underscore.
  definitions["any_stage"] = any_stage_of(arranging);
  definitions["any_measure"] = any_stage_of(measuring);
  definitions["any_overdraw_service"] = any_stage_of(overdraw);

  Json properties;
  properties["pipeline"] = {{"const", 1}, {"description", "The version of the format"}};
  properties.update(properties_of(pipeline_words().specs()));
  properties["stages"] = list_of("any_stage", "What to run, in this sequence");
  properties["measure"] = list_of("any_measure", "What to measure, before and after");
  properties["compare"] = {{"type", "object"},
                           {"description", "Several pipelines in one file: each runs the stages, then its own"},
                           {"minProperties", 1},
                           {"additionalProperties", list_of("any_stage", "What this pipeline runs after the stages")}};
  properties["modules"] = {
      {"type", "array"},
      {"items", {{"type", "string"}, {"pattern", "^\\s*[a-z0-9]+\\s*(>=\\s*[0-9]+(\\.[0-9]+)*\\s*)?$"}}},
      {"description", "Modules that have to be loaded: \"acme\", \"acme >= 1.2\". A pipeline loads none itself"}};
  properties["views"] = closed_table(properties_of(view_words().specs()));
  properties["views"]["description"] = "The views that orders are optimised for";
  properties["poses"] = closed_table(properties_of(pose_words().specs()));
  properties["poses"]["description"] = "The poses of animated characters that orders are optimised for";
  properties["subjects"] = closed_table(properties_of(subject_words().specs()));
  properties["subjects"]["description"] = "What stages and evaluators see as one";
  properties["frames"] = closed_table(properties_of(frame_words().specs()));
  properties["frames"]["description"] = "The frames that evaluators of frames walk through";
  properties["output"] = closed_table(properties_of(output_words().specs()));
  properties["output"]["description"] = "How the scene is written, unless the caller says otherwise";
  properties["services"] = closed_table({{"overdraw", reference("any_overdraw_service")}});
  properties["services"]["description"] = "Which evaluator supplies measured overdraw";

  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"title", "Foredraw pipeline"}};
  schema.update(closed_table(std::move(properties)));
  schema["required"] = {"pipeline"};
  schema["$defs"] = std::move(definitions);
  return schema.dump(2) + '\n';
}

}  // namespace foredraw
