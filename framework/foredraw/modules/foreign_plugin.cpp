#include <foredraw/modules/foreign_plugin.h>

#include <foredraw/modules/foreign_technique.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
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

Kind kind_of(std::uint32_t kind) {
  switch (kind) {
    case FOREDRAW_CLUSTERER: return Kind::clusterer;
    case FOREDRAW_EVALUATOR: return Kind::evaluator;
    case FOREDRAW_REMESHER: return Kind::processor;
    default: return Kind::orderer;
  }
}

void check_flags(const foredraw_plugin& plugin) {
  constexpr std::uint32_t known = FOREDRAW_LOSSLESS | FOREDRAW_USES_OVERDRAW;
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if ((plugin.flags & ~known) != 0 || plugin.reserved != 0) {
    refuse(fmt::format("flags are {} and reserved is {}; expected FOREDRAW_LOSSLESS, FOREDRAW_USES_OVERDRAW and 0",
                       plugin.flags, plugin.reserved));
  }
  if ((plugin.flags & FOREDRAW_LOSSLESS) != 0 && plugin.kind != FOREDRAW_REMESHER) {
    refuse("FOREDRAW_LOSSLESS is of remeshers alone: orders and clusters always are");
  }
  if ((plugin.flags & FOREDRAW_USES_OVERDRAW) != 0 && plugin.kind != FOREDRAW_TRIANGLE_ORDERER &&
      plugin.kind != FOREDRAW_EVALUATOR) {
    refuse("FOREDRAW_USES_OVERDRAW is of orderers of triangles and evaluators alone");
  }
}

/// Other triangles are in no order that one knows of, in no clusters, and of no sequence of collapses, and vertices may
/// be there twice, unless it says that it sees to that.
void add_what_remeshers_do(Card& card) {
  if (card.provides.has(traits::clustered)) {
    throw std::invalid_argument("a remesher can not provide 'clustered': its answer has no clusters");
  }
  for (const Trait lost : {traits::welded, traits::progressive, traits::clustered, traits::cache_ordered,
                           traits::overdraw_ordered, traits::fetch_ordered}) {
    if (!card.provides.has(lost)) card.breaks.add(lost);
  }
  if (!card.lossless) card.measured_by = {"surface-error", "attribute-error"};
}

}  // namespace

foredraw_plugin in_this_version(const foredraw_plugin& described) {
  constexpr std::size_t size_of_1_0 = offsetof(foredraw_plugin, acts_on);
  if (described.size < size_of_1_0) {
    throw std::invalid_argument(
        fmt::format("size is {}, but must be sizeof(foredraw_plugin), {}", described.size, sizeof described));
  }
  foredraw_plugin known{};
  std::memcpy(&known, &described, std::min<std::size_t>(described.size, sizeof known));
  return known;
}

Plugin foreign_plugin(const foredraw_plugin& described, std::shared_ptr<const ForeignRunner> runner) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  const foredraw_plugin given = in_this_version(described);
  if (given.name == nullptr) refuse("the plugin has no name");
  if (given.kind < FOREDRAW_TRIANGLE_ORDERER || given.kind > FOREDRAW_REMESHER) {
    refuse(fmt::format("kind is {}; expected FOREDRAW_TRIANGLE_ORDERER to FOREDRAW_REMESHER", given.kind));
  }
  check_flags(given);
  if (given.run == nullptr) refuse("run is NULL");
  constexpr std::uint32_t most_rows = 1000;
  if (given.option_count > most_rows || given.metric_count > most_rows)
    refuse("it has more than 1000 options or metrics");
  if ((given.options == nullptr && given.option_count > 0) || (given.metrics == nullptr && given.metric_count > 0)) {
    refuse("options or metrics are NULL");
  }
  Plugin plugin;
  plugin.kind = kind_of(given.kind);
  plugin.card = {.name = text_from_c(given.name),
                 .summary = text_from_c(given.summary),
                 .reference = text_from_c(given.reference),
                 .acts_on = traits_in(given.acts_on),
                 .needs = traits_in(given.needs),
                 .provides = traits_in(given.provides),
                 .breaks = traits_in(given.breaks),
                 .pays_if = text_from_c(given.pays_if),
                 .uses_overdraw = (given.flags & FOREDRAW_USES_OVERDRAW) != 0,
                 .lossless = (given.flags & FOREDRAW_LOSSLESS) != 0};
  if (given.kind != FOREDRAW_VERTEX_ORDERER) plugin.card.acts_on.add(traits::triangles);
  for (const foredraw_metric& metric : std::span(given.metrics, given.metric_count)) {
    plugin.card.metrics.push_back(
        {text_from_c(metric.name), text_from_c(metric.unit), text_from_c(metric.doc), metric.higher_is_better == 0});
  }
  for (const foredraw_option& option : std::span(given.options, given.option_count)) {
    plugin.options.push_back(spec_of(option));
  }
  if (given.kind == FOREDRAW_REMESHER) add_what_remeshers_do(plugin.card);
  ForeignKind kind{given.kind, plugin.options, plugin.card.metrics};
  plugin.create = [kind = std::move(kind), runner = std::move(runner)](const Settings& settings) {
    return foreign_technique(kind, settings, runner);
  };
  return plugin;
}

}  // namespace foredraw
