#include <foredraw/report/stored_report.h>

#include <foredraw/report/private/json_values.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

/// The report without draws and stages, which are most of its text and which nobody here asks for.
Json summary_in(std::string_view report) {
  return Json::parse(report, [](int depth, Json::parse_event_t event, const Json& value) {
    const bool is_member = depth == 1 && event == Json::parse_event_t::key;
    return !is_member || (value != "draws" && value != "stages" && value != "measures");
  });
}

/// What is not finite was written as null.
double number_in(const Json& json) {
  return json.is_null() ? std::numeric_limits<double>::quiet_NaN() : json.get<double>();
}

const Card* card_of(const std::string& label, const Registry& registry) {
  const Plugin* plugin = registry.find(label.substr(0, label.find('#')));  // a second use is "tipsify#2"
  return plugin == nullptr ? nullptr : &plugin->card;
}

Figure figure_in(const Json& json, const std::string& metric, const Card* card) {
  Measured measured{metric, number_in(json.at("value")), std::nullopt, number_in(json.at("error")), {}};
  if (json.contains("denominator")) {
    measured.numerator = number_in(json.at("numerator"));
    measured.denominator = number_in(json.at("denominator"));
  }
  const Card none;
  Figure figure = figure_of(measured, card == nullptr ? none : *card);
  figure.unit = json.at("unit").get<std::string>();
  return figure;
}

/// Groups are objects in objects; a figure may stand in one with others below it.
void add_figures(Metrics& metrics, const std::string& plugin, const std::string& name, const Json& json,
                 const Card* card) {
  if (json.contains("value") && json.contains("unit") && !json["value"].is_object()) {
    metrics.set(plugin, name, figure_in(json, name, card));
  }
  for (const auto& [key, held] : json.items()) {
    if (held.is_object()) add_figures(metrics, plugin, name.empty() ? key : name + '.' + key, held, card);
  }
}

StateRecord state_in(const Json& json, const Registry& registry) {
  StateRecord state{json.at("triangles").get<std::uint64_t>(), json.at("vertices").get<std::uint64_t>(), {}};
  for (const auto& [plugin, figures] : json.at("metrics").items()) {
    add_figures(state.metrics, plugin, "", figures, card_of(plugin, registry));
  }
  return state;
}

FileRecord file_in(const Json& json) {
  return {json.at("path").get<std::string>(), json.at("bytes").get<std::uint64_t>(), json.value("hash", "")};
}

Severity severity_in(const std::string& word) {
  for (const Severity severity : {Severity::note, Severity::warning, Severity::error}) {
    if (word == to_text(severity)) return severity;
  }
  throw std::invalid_argument("there is no severity '" + word + "'");
}

Diagnostic diagnostic_in(const Json& json) {
  return {severity_in(json.at("severity").get<std::string>()),
          {json.at("file").get<std::string>(), json.at("line").get<int>(), json.at("column").get<int>(),
           json.at("inside").get<std::string>()},
          json.at("code").get<std::string>(),
          json.at("message").get<std::string>(),
          json.at("hint").get<std::string>(),
          json.at("places").get<std::size_t>()};
}

}  // namespace

StoredReport stored_report(std::string_view json, const Registry& registry) {
  try {
    const Json report = summary_in(json);
    StoredReport stored;
    stored.input = file_in(report.at("input"));
    if (report.contains("output")) stored.output = file_in(report.at("output"));
    const Json& totals = report.at("totals");
    stored.after = state_in(totals, registry);
    stored.optimized = totals.contains("before");
    if (stored.optimized) stored.before = state_in(totals["before"], registry);
    for (const Json& diagnostic : report.at("diagnostics")) stored.diagnostics.push_back(diagnostic_in(diagnostic));
    return stored;
  } catch (const Json::exception& mistake) {
    throw std::invalid_argument(mistake.what());
  }
}

}  // namespace foredraw
