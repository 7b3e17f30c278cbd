#include <foredraw/base/printable.h>
#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/c/library/private/lent.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <cfenv>
#include <cmath>
#include <mutex>
#include <sstream>
#include <stdexcept>

namespace foredraw::c {

namespace {

std::string text_of(const char* text) { return text == nullptr ? std::string() : printable(text); }

/// What a technique is handed to ask and tell.
class Host {
 public:
  explicit Host(Run& run)
      : run_(run),
        table_{.size = sizeof table_,
               .seed = run.seed,
               .self = this,
               .cancelled = [](void* self) { return of(self).run_.cancelled() ? 1 : 0; },
               .keep = [](void* self, const char* reason) { of(self).run_.keep(text_of(reason)); },
               .fail = [](void* self, const char* message) { of(self).failure_ = text_of(message); },
               .note = [](void* self, const char* code,
                          const char* message) { of(self).run_.note(text_of(code), text_of(message)); },
               .count =
                   [](void* self, const char* metric, double number) {
                     if (of(self).are_numbers(metric, {number})) of(self).run_.count(text_of(metric), number);
                   },
               .measure =
                   [](void* self, const char* metric, double numerator, double denominator, double error) {
                     if (!of(self).are_numbers(metric, {numerator, denominator, error})) return;
                     of(self).run_.measure(text_of(metric), numerator, denominator, error);
                   }} {}

  const foredraw_host* table() const { return &table_; }
  const std::optional<std::string>& failure() const { return failure_; }

 private:
  static Host& of(void* self) { return *static_cast<Host*>(self); }

  bool are_numbers(const char* metric, std::initializer_list<double> numbers) {
    for (const double number : numbers) {
      if (std::isfinite(number)) continue;
      failure_ = fmt::format("its figure '{}' is not a finite number", text_of(metric));
      return false;
    }
    return true;
  }

  Run& run_;
  foredraw_host table_;
  std::optional<std::string> failure_;
};

/// The foreign functions, and the options that they are called with.
class Foreign {
 public:
  Foreign(const foredraw_plugin& plugin, const Settings& settings, std::mutex& one_at_a_time)
      : plugin_(plugin), one_at_a_time_(one_at_a_time) {
    texts_.reserve(plugin.option_count);
    for (const foredraw_option& option : std::span(plugin.options, plugin.option_count)) {
      foredraw_value& value = values_.emplace_back(option.initial);
      const auto found = settings.find(option.name);
      if (found == settings.end()) continue;
      if (const auto* flag = std::get_if<bool>(&found->second)) value.integer = *flag ? 1 : 0;
      if (const auto* whole = std::get_if<std::int64_t>(&found->second)) value.integer = *whole;
      if (const auto* real = std::get_if<double>(&found->second)) value.number = *real;
      if (const auto* text = std::get_if<std::string>(&found->second)) value.text = texts_.emplace_back(*text).c_str();
    }
  }

  Foreign(Foreign&&) = default;  // a copy's values would refer to the other one's texts

  /// The first `room` numbers of what it wrote, or as many as it says. Throws what it failed of.
  std::vector<std::uint32_t> run(const foredraw_draw& draw, std::size_t room, Run& run) const {
    std::vector<std::uint32_t> values(room, ~std::uint32_t{0});
    foredraw_answer answer{values.data(), room};
    Host host(run);
    const int status = called(draw, answer, host);
    if (status == FOREDRAW_CANCELLED) throw std::runtime_error("cancelled");
    if (host.failure() || status != FOREDRAW_DONE) {
      throw std::runtime_error(host.failure().value_or(fmt::format("it returned {}", status)));
    }
    if (answer.count > room) {
      throw std::runtime_error(fmt::format("its answer has {} numbers, but there is room for {}", answer.count, room));
    }
    values.resize(answer.count);
    return values;
  }

 private:
  /// Rounding and the like are again as they were, whatever it did to them: later stages' bytes hang on that.
  int called(const foredraw_draw& draw, foredraw_answer& answer, const Host& host) const {
    std::unique_lock lock(one_at_a_time_, std::defer_lock);
    if (plugin_.runs_on_many_threads == 0) lock.lock();
    std::fenv_t before;
    std::fegetenv(&before);
    const int status = plugin_.run(plugin_.user, &draw, values_.data(), &answer, host.table());
    std::fesetenv(&before);
    return status;
  }

  const foredraw_plugin& plugin_;
  std::mutex& one_at_a_time_;
  std::vector<foredraw_value> values_;
  std::vector<std::string> texts_;
};

/// A draw as it is handed over, with what it refers to.
struct HandedDraw {
  HandedDraw(const VertexStreams& vertices, std::span<const std::uint32_t> indices, const Clusters* clusters, Run& run)
      : positions(positions_of(run.analyses, vertices)),
        streams(streams_for_c(vertices)),
        draw(draw_for_c(vertices, indices, positions->values.empty() ? nullptr : &positions->values.front().x, streams,
                        clusters)) {}
  HandedDraw(const DrawView& view, Run& run)
      : HandedDraw(view.vertices(), view.indices(), view.stream().clusters ? &*view.stream().clusters : nullptr, run) {
    draw.name = view.draw().name.c_str();
  }

  std::shared_ptr<const Positions> positions;
  std::vector<foredraw_stream> streams;
  foredraw_draw draw;
};

struct ForeignOrderer final : DrawOrderer {
  explicit ForeignOrderer(Foreign what) : foreign(std::move(what)) {}
  IndexOrder order(const DrawView& view, Run& run) const override {
    return foreign.run(HandedDraw(view, run).draw, view.triangle_count(), run);
  }
  Foreign foreign;
};

struct ForeignVertexOrderer final : VertexOrderer {
  explicit ForeignVertexOrderer(Foreign what) : foreign(std::move(what)) {}
  VertexOrder order(const VertexUse& use, Run& run) const override {
    std::vector<std::uint32_t> indices;
    for (const auto& stream : use.index_streams) indices.insert(indices.end(), stream.begin(), stream.end());
    return foreign.run(HandedDraw(use.vertices, indices, nullptr, run).draw, use.vertices.count, run);
  }
  Foreign foreign;
};

struct ForeignClusterer final : Clusterer {
  explicit ForeignClusterer(Foreign what) : foreign(std::move(what)) {}
  Clusters cluster(const DrawView& view, Run& run) const override {
    return {foreign.run(HandedDraw(view, run).draw, view.triangle_count() + 1, run)};
  }
  Foreign foreign;
};

struct ForeignEvaluator final : DrawEvaluator {
  explicit ForeignEvaluator(Foreign what) : foreign(std::move(what)) {}
  void evaluate(const DrawView& view, Run& run) const override { foreign.run(HandedDraw(view, run).draw, 0, run); }
  Foreign foreign;
};

Technique technique_of(std::uint32_t kind, Foreign foreign) {
  switch (kind) {
    case FOREDRAW_TRIANGLE_ORDERER: return std::make_unique<ForeignOrderer>(std::move(foreign));
    case FOREDRAW_VERTEX_ORDERER: return std::make_unique<ForeignVertexOrderer>(std::move(foreign));
    case FOREDRAW_CLUSTERER: return std::make_unique<ForeignClusterer>(std::move(foreign));
    default: return std::make_unique<ForeignEvaluator>(std::move(foreign));
  }
}

Traits traits_in(const char* words) {
  Traits traits;
  std::istringstream text(text_of(words));
  for (std::string word; text >> word;) traits.add(Trait(word));
  return traits;
}

OptionSpec spec_of(const foredraw_option& option) {
  const std::string name = text_of(option.name);
  const auto refuse = [&](const char* why) { throw std::invalid_argument(fmt::format("option '{}': {}", name, why)); };
  OptionSpec spec{.name = name, .doc = text_of(option.doc), .unit = text_of(option.unit)};
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
      spec.default_value = text_of(option.initial.text);
      break;
    default: refuse("its type is not one of FOREDRAW_BOOLEAN to FOREDRAW_CHOICE");
  }
  if (option.type == FOREDRAW_INTEGER || option.type == FOREDRAW_NUMBER) {
    spec.least = option.least, spec.most = option.most;
  }
  if (option.type == FOREDRAW_CHOICE) {
    if (option.choices == nullptr || option.choice_count == 0) refuse("it has no choices");
    for (const char* choice : std::span(option.choices, option.choice_count)) spec.choices.push_back(text_of(choice));
  }
  return spec;
}

/// std::invalid_argument says what is wrong with it.
Plugin plugin_of(const foredraw_plugin& given) {
  const auto refuse = [](const std::string& why) { throw std::invalid_argument(why); };
  if (given.size != sizeof given) {
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
  plugin.card = {.name = text_of(given.name),
                 .summary = text_of(given.summary),
                 .reference = text_of(given.reference),
                 .needs = traits_in(given.needs),
                 .provides = traits_in(given.provides),
                 .breaks = traits_in(given.breaks)};
  if (given.kind != FOREDRAW_VERTEX_ORDERER) plugin.card.acts_on.add(traits::triangles);
  for (const foredraw_metric& metric : std::span(given.metrics, given.metric_count)) {
    plugin.card.metrics.push_back(
        {text_of(metric.name), text_of(metric.unit), text_of(metric.doc), metric.higher_is_better == 0});
  }
  for (const foredraw_option& option : std::span(given.options, given.option_count)) {
    plugin.options.push_back(spec_of(option));
  }
  plugin.create = [&given, one_at_a_time = std::make_shared<std::mutex>()](const Settings& settings) {
    return technique_of(given.kind, Foreign(given, settings, *one_at_a_time));
  };
  return plugin;
}

}  // namespace

}  // namespace foredraw::c

using namespace foredraw;
using namespace foredraw::c;

int foredraw_add_plugin(foredraw_context* context, const foredraw_plugin* plugin, foredraw_text* problems) {
  return at_border(problems, [&]() -> int {
    if (context == nullptr || plugin == nullptr) return FOREDRAW_NULL_POINTER;
    try {
      context->registry.add(plugin_of(*plugin));
      return FOREDRAW_DONE;
    } catch (const std::invalid_argument& wrong) {
      Diagnostics diagnostics;
      diagnostics.error({}, "bad-plugin", wrong.what());
      put(diagnostics, problems);
      return FOREDRAW_MISTAKE;
    }
  });
}
