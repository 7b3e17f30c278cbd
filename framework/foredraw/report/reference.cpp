#include <foredraw/report/reference.h>

#include <foredraw/report/private/json_values.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw {

namespace {

std::string_view text_of(OptionType type) {
  switch (type) {
    case OptionType::boolean: return "true or false";
    case OptionType::integer: return "whole number";
    case OptionType::number: return "number";
    case OptionType::text: return "text";
    case OptionType::choice: return "choice";
    case OptionType::number_or_text:
    case OptionType::views: return "text or whole number";
    case OptionType::numbers: return "numbers, with commas between them";
    case OptionType::scene: return "path of a scene";
    case OptionType::image: return "path of an image";
  }
  return "text";
}

std::string allowed(const OptionSpec& option) {
  if (option.type == OptionType::choice) return fmt::format("{}", fmt::join(option.choices, ", "));
  const std::string range = range_text(option);
  return fmt::format("{}{}{}", text_of(option.type), range.empty() ? "" : ", ", range);
}

std::string names_text(const Traits& traits) { return fmt::format("{}", fmt::join(traits, ", ")); }

Json option_json(const OptionSpec& option) {
  Json json{{"name", option.name},
            {"type", text_of(option.type)},
            {"default", json_of(option.default_value)},
            {"doc", option.doc},
            {"unit", option.unit}};
  if (std::isfinite(option.least)) json["least"] = option.least;
  if (std::isfinite(option.most)) json["most"] = option.most;
  if (!option.choices.empty()) json["choices"] = option.choices;
  return json;
}

Json list_of(const Traits& traits) { return std::vector<std::string>(traits.begin(), traits.end()); }

}  // namespace

std::string reference_page(const Plugin& plugin, const ModuleFile* module) {
  const Card& card = plugin.card;
  std::string page =
      fmt::format("# {}\n\n{}: {}.\n\nSource: {}.\n", card.name, to_text(plugin.kind), card.summary, card.reference);
  const auto fact = [&](std::string_view what, const std::string& text) {
    if (!text.empty()) page += fmt::format("- {}: {}\n", what, text);
  };
  if (module != nullptr) page += fmt::format("Module: {}, version {}.\n", module->path, module->version);
  page += '\n';
  fact("acts on draws that are", names_text(card.acts_on));
  fact("needs draws to be", names_text(card.needs));
  fact("works best on draws that are", names_text(card.wants));
  fact("uses, where there is any, that draws are", names_text(card.uses));
  fact("makes them", names_text(card.provides));
  fact("undoes", names_text(card.breaks));
  fact("pays if", card.pays_if);
  fact("measured by", fmt::format("{}", fmt::join(card.measured_by, ", ")));
  if (card.uses_overdraw) page += "- needs measured overdraw\n";
  if (plugin.overdraw_service) page += "- can supply measured overdraw ([services])\n";
  if (plugin.options.empty()) {
    page += "\nIt has no options.\n";
  } else {
    page += "\n| option | default | may be | meaning |\n|---|---|---|---|\n";
    for (const OptionSpec& option : plugin.options) {
      page += fmt::format("| `{}` | {} | {} | {} |\n", option.name, to_text(option.default_value), allowed(option),
                          option.doc);
    }
  }
  if (!card.metrics.empty()) {
    page += "\n| metric | unit | meaning |\n|---|---|---|\n";
    for (const Metric& metric : card.metrics)
      page += fmt::format("| `{}` | {} | {} |\n", metric.name, metric.unit, metric.doc);
  }
  return page;
}

std::string reference_json(const Plugin& plugin, const ModuleFile* module) {
  const Card& card = plugin.card;
  Json json{{"name", card.name},
            {"kind", to_text(plugin.kind)},
            {"summary", card.summary},
            {"reference", card.reference},
            {"acts-on", list_of(card.acts_on)},
            {"needs", list_of(card.needs)},
            {"wants", list_of(card.wants)},
            {"uses", list_of(card.uses)},
            {"provides", list_of(card.provides)},
            {"breaks", list_of(card.breaks)},
            {"pays-if", card.pays_if},
            {"measured-by", card.measured_by}};
  json["options"] = Json::array();
  for (const OptionSpec& option : plugin.options) json["options"].push_back(option_json(option));
  json["metrics"] = Json::array();
  for (const Metric& metric : card.metrics) {
    json["metrics"].push_back({{"name", metric.name},
                               {"unit", metric.unit},
                               {"doc", metric.doc},
                               {"lower-is-better", metric.lower_is_better}});
  }
  if (module != nullptr)
    json["module"] = {{"path", module->path}, {"version", module->version}, {"hash", module->hash}};
  return json.dump(2) + '\n';
}

std::string list_text(const Registry& registry, std::optional<Kind> kind) {
  Table table({"kind", "name", "what it does"});
  for (Kind each : {Kind::orderer, Kind::clusterer, Kind::processor, Kind::evaluator}) {
    if (kind && *kind != each) continue;
    for (const Plugin* plugin : registry.all()) {
      if (plugin->kind != each) continue;
      std::string summary = plugin->card.summary;
      if (plugin->unavailable) {
        if (const auto why = plugin->unavailable()) summary += " (unavailable on this machine: " + *why + ")";
      }
      if (const ModuleFile* module = registry.module_of(plugin->card.name)) {
        summary += fmt::format(" ({} {})", module->path, module->version);
      }
      table.add({std::string(to_text(each)), plugin->card.name, summary});
    }
  }
  std::string text = table.text();
  if (kind) return text;
  for (const auto& [name, reason] : registry.left_out()) {
    text += fmt::format("\nThis build leaves out {}: {}.\n", name, reason);
  }
  return text;
}

std::string list_json(const Registry& registry, std::optional<Kind> kind) {
  Json json{{"list", 1}, {"plugins", Json::array()}};
  for (const Plugin* plugin : registry.all()) {
    if (!kind || plugin->kind == *kind)
      json["plugins"].push_back(Json::parse(reference_json(*plugin, registry.module_of(plugin->card.name))));
  }
  if (!kind) {
    for (const auto& [name, reason] : registry.left_out()) json["left-out"][name] = reason;
  }
  return json.dump(2) + '\n';
}

}  // namespace foredraw
