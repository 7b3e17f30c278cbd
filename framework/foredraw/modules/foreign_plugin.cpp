#include <foredraw/modules/foreign_plugin.h>

#include <foredraw/modules/foreign_technique.h>

#include <fmt/format.h>

#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

Traits traits_in(const char* words) {
  Traits traits;
  std::istringstream text(text_from_c(words));
  for (std::string word; text >> word;) traits.add(Trait(word));
  return traits;
}

OptionSpec spec_of(const foredraw_option& option) {
  const std::string name = text_from_c(option.name);
  const auto refuse = [&](const char* why) { throw std::invalid_argument(fmt::format("option '{}': {}", name, why)); };
  OptionSpec spec{.name = name, .doc = text_from_c(option.doc), .unit = text_from_c(option.unit)};
  switch (option.type) {
    case FOREDRAW_BOOLEAN:
      spec.type = OptionType::boolean;
      spec.default_value = option.initial.integer != 0;
      break;
    case FOREDRAW_INTEGER:
      spec.type = OptionType::integer;
      spec.default_value = option.initial.integer;
      break;
    case FOREDRAW_NUMBER:
      spec.type = OptionType::number;
      spec.default_value = option.initial.number;
      break;
    case FOREDRAW_TEXT:
    case FOREDRAW_CHOICE:
      if (option.initial.text == nullptr) refuse("its initial text is NULL");
      spec.type = option.type == FOREDRAW_TEXT ? OptionType::text : OptionType::choice;
      spec.default_value = text_from_c(option.initial.text);
      break;
    default: refuse("its type is not one of FOREDRAW_BOOLEAN to FOREDRAW_CHOICE");
  }
  if (option.type == FOREDRAW_INTEGER || option.type == FOREDRAW_NUMBER) {
    spec.least = option.least, spec.most = option.most;
  }
  if (option.type == FOREDRAW_CHOICE) {
    if (option.choices == nullptr || option.choice_count == 0) refuse("it has no choices");
    for (const char* choice : std::span(option.choices, option.choice_count))
      spec.choices.push_back(text_from_c(choice));
  }
  return spec;
}

}  // namespace

Plugin foreign_plugin(const foredraw_plugin& given, std::shared_ptr<const ForeignRunner> runner) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (given.size < sizeof given) {
    refuse(fmt::format("size is {}, but must be sizeof(foredraw_plugin), {}", given.size, sizeof given));
  }
  if (given.name == nullptr) refuse("the plugin has no name");
  if (given.kind < FOREDRAW_TRIANGLE_ORDERER || given.kind > FOREDRAW_EVALUATOR) {
    refuse(fmt::format("kind is {}; expected FOREDRAW_TRIANGLE_ORDERER to FOREDRAW_EVALUATOR", given.kind));
  }
  if (given.run == nullptr) refuse("run is NULL");
  constexpr std::uint32_t most_rows = 1000;
  if (given.option_count > most_rows || given.metric_count > most_rows)
    refuse("it has more than 1000 options or metrics");
  if ((given.options == nullptr && given.option_count > 0) || (given.metrics == nullptr && given.metric_count > 0)) {
    refuse("options or metrics are NULL");
  }
  Plugin plugin;
  plugin.kind = given.kind == FOREDRAW_EVALUATOR   ? Kind::evaluator
                : given.kind == FOREDRAW_CLUSTERER ? Kind::clusterer
                                                   : Kind::orderer;
  plugin.card = {.name = text_from_c(given.name),
                 .summary = text_from_c(given.summary),
                 .reference = text_from_c(given.reference),
                 .needs = traits_in(given.needs),
                 .provides = traits_in(given.provides),
                 .breaks = traits_in(given.breaks)};
  if (given.kind != FOREDRAW_VERTEX_ORDERER) plugin.card.acts_on.add(traits::triangles);
  for (const foredraw_metric& metric : std::span(given.metrics, given.metric_count)) {
    plugin.card.metrics.push_back(
        {text_from_c(metric.name), text_from_c(metric.unit), text_from_c(metric.doc), metric.higher_is_better == 0});
  }
  for (const foredraw_option& option : std::span(given.options, given.option_count)) {
    plugin.options.push_back(spec_of(option));
  }
  ForeignKind kind{given.kind, plugin.options, plugin.card.metrics};
  plugin.create = [kind = std::move(kind), runner = std::move(runner)](const Settings& settings) {
    return foreign_technique(kind, settings, runner);
  };
  return plugin;
}

}  // namespace foredraw
