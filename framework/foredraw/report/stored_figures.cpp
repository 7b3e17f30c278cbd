// Figures out of the JSON forms: what a later run is held against.
#include <foredraw/report/bound.h>

#include <foredraw/report/private/json_values.h>

#include <fmt/format.h>

#include <functional>

namespace foredraw {

namespace {

constexpr int known_version = 1;  // of every form that is read here

/// Leaves are objects with a value; what is around them are evaluator and metric, dots in its name being levels.
void add_figures(StoredFigures& figures, const Json& metrics, const std::string& name) {
  if (!metrics.is_object()) return;
  if (const auto value = metrics.find("value"); value != metrics.end() && value->is_number()) {
    figures[name] = value->get<double>();
    return;
  }
  for (const auto& [key, held] : metrics.items()) add_figures(figures, held, name.empty() ? key : name + '.' + key);
}

/// Throws nlohmann's exceptions where it is no report.
void add_report(std::map<std::string, StoredFigures>& files, const Json& report) {
  StoredFigures& figures = files[report.at("input").at("path").get<std::string>()];
  add_figures(figures, report.at("totals").at("metrics"), "");
  double seconds = 0;
  for (const Json& stage : report.at("stages")) seconds += stage.at("seconds").get<double>();
  figures["time"] = seconds;
}

std::map<std::string, StoredFigures> figures_in(const Json& json, const std::string& form) {
  std::map<std::string, StoredFigures> files;
  if (form == "report") add_report(files, json);
  if (form == "batch") {
    for (const Json& file : json.at("files")) {
      if (file.at("outcome") != "lost") add_report(files, file.at("report"));
    }
  }
  if (form == "comparison") {
    for (const Json& file : json.at("files")) {
      if (file.value("lost", false) || file.at("branches").at(0).value("lost", false)) continue;
      add_report(files, file.at("branches").at(0).at("report"));
    }
  }
  return files;
}

}  // namespace

std::optional<std::map<std::string, StoredFigures>> read_stored_figures(const std::string& text,
                                                                        const std::string& name,
                                                                        Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why) {
    diagnostics.error({.file = name}, "bad-baseline", why, "give the JSON report of optimize, measure or compare");
    return std::nullopt;
  };
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object()) return refuse("is not a JSON object");
  for (const std::string form : {"report", "batch", "comparison"}) {
    if (!json.contains(form)) continue;
    const Json& version = json[form];
    if (!version.is_number_integer()) break;
    if (version.get<std::int64_t>() > known_version) {
      return refuse(fmt::format("is a {} of version {}, but this program reads versions up to {}", form,
                                version.get<std::int64_t>(), known_version));
    }
    try {
      return figures_in(json, form);
    } catch (const Json::exception&) {
      return refuse(fmt::format("is an incomplete {}", form));
    }
  }
  return refuse("is not a report, a batch or a comparison");
}

}  // namespace foredraw
