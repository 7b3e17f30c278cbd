#include <foredraw/report/baseline.h>

#include <foredraw/report/private/json_places.h>
#include <foredraw/report/private/json_values.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

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
void add_report(Baseline::Files& files, const Json& report) {
  StoredFigures& figures = files[report.at("input").at("path").get<std::string>()];
  add_figures(figures, report.at("totals").at("metrics"), "");
  double seconds = 0;
  for (const Json& stage : report.at("stages")) seconds += stage.at("seconds").get<double>();
  figures["time"] = seconds;
}

/// Of an object with members like these, of which a library has as many as files, one at a time.
void add_file(Baseline::Files& files, const Json& file) {
  if (file.contains("outcome")) {
    if (file.at("outcome") != "lost") add_report(files, file.at("report"));
  } else if (!file.value("lost", false) && !file.at("branches").at(0).value("lost", false)) {
    add_report(files, file.at("branches").at(0).at("report"));
  }
}

std::string place_of(const std::string& file) { return std::filesystem::absolute(file).lexically_normal().string(); }

}  // namespace

Baseline::Baseline(Files files) : files_(std::move(files)) {
  for (const auto& file : files_) {
    by_place_.emplace(place_of(file.first), &file);
    const auto [at, is_new] = by_name_.emplace(std::filesystem::path(file.first).filename().string(), &file);
    if (!is_new) at->second = nullptr;
  }
}

const Baseline::Files::value_type* Baseline::find(const std::string& path) const {
  if (const auto found = by_place_.find(place_of(path)); found != by_place_.end()) return found->second;
  const auto found = by_name_.find(std::filesystem::path(path).filename().string());
  return found == by_name_.end() ? nullptr : found->second;
}

std::optional<Baseline> read_baseline(const std::string& text, const std::string& name, Diagnostics& diagnostics) {
  const auto refuse = [&](const std::string& why) {
    diagnostics.error({.file = name}, "bad-baseline", why, "give the JSON report of optimize, measure or compare");
    return std::nullopt;
  };
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos || text[begin] != '{' || !Json::accept(text)) return refuse("is not a JSON object");
  const auto members = members_in(text);
  const auto member = [&](std::string_view key) {
    const auto found = std::ranges::find(members, key, [](const auto& each) { return each.first; });
    return found == members.end() ? std::string_view() : found->second;
  };
  for (const std::string form : {"report", "batch", "comparison"}) {
    if (member(form).empty()) continue;
    const Json version = Json::parse(member(form));
    if (!version.is_number_integer()) break;
    if (version.get<std::int64_t>() > known_version) {
      return refuse(fmt::format("is a {} of version {}, but this program reads versions up to {}", form,
                                version.get<std::int64_t>(), known_version));
    }
    try {
      Baseline::Files files;
      if (form == "report") {
        add_report(files, Json::parse(text));
      } else if (!member("files").starts_with('[')) {
        return refuse(fmt::format("is an incomplete {}", form));
      } else {
        for (const std::string_view file : elements_in(member("files"))) add_file(files, Json::parse(file));
      }
      return Baseline(std::move(files));
    } catch (const Json::exception&) {
      return refuse(fmt::format("is an incomplete {}", form));
    }
  }
  return refuse("is not a report, a batch or a comparison");
}

}  // namespace foredraw
