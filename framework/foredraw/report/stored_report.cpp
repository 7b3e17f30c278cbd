#include <foredraw/report/stored_report.h>

#include <foredraw/report/private/json_places.h>
#include <foredraw/report/private/json_values.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

/// A member of the report alone: most of its text are draws and stages, which nobody here asks for.
class Members {
 public:
  explicit Members(std::string_view report) : members_(members_in(report)) {}
  bool has(std::string_view key) const { return find(key) != members_.end(); }
  Json at(std::string_view key) const {
    const auto member = find(key);
    if (member == members_.end()) throw std::invalid_argument("is no report: '" + std::string(key) + "' is missing");
    return Json::parse(member->second);
  }

 private:
  using Each = std::vector<std::pair<std::string_view, std::string_view>>;
  Each::const_iterator find(std::string_view key) const {
    return std::ranges::find(members_, key, &Each::value_type::first);
  }

  Each members_;
};

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
    const Members report(json);
    StoredReport stored;
    stored.input = file_in(report.at("input"));
    if (report.has("output")) stored.output = file_in(report.at("output"));
    const Json totals = report.at("totals");
    stored.after = state_in(totals, registry);
    stored.optimized = totals.contains("before");
    if (stored.optimized) stored.before = state_in(totals["before"], registry);
    const Json diagnostics = report.at("diagnostics");
    for (const Json& diagnostic : diagnostics) stored.diagnostics.push_back(diagnostic_in(diagnostic));
    return stored;
  } catch (const Json::exception& mistake) {
    throw std::invalid_argument(mistake.what());
  }
}

}  // namespace foredraw
