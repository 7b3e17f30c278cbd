#include <foredraw/report/baseline.h>

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
  Baseline::Files files;
  Json head;
  bool is_whole = true;
  const auto take = [&](const Json& file) {
    try {
      add_file(files, file);
    } catch (const Json::exception&) {
      is_whole = false;  // which matters where it is a report at all
    }
  };
  try {
    head = parse_files(text, take);
  } catch (const Json::parse_error&) {
  }
  if (!head.is_object()) return refuse("is not a JSON object");
  for (const std::string form : {"report", "batch", "comparison"}) {
    if (!head.contains(form)) continue;
    const Json& version = head[form];
    if (!version.is_number_integer()) break;
    if (version.get<std::int64_t>() > known_version) {
      return refuse(fmt::format("is a {} of version {}, but this program reads versions up to {}", form,
                                version.get<std::int64_t>(), known_version));
    }
    try {
      if (form == "report") {
        add_report(files, head);
      } else {
        is_whole = is_whole && head.contains("files") && head["files"].is_array();
      }
    } catch (const Json::exception&) {
      is_whole = false;
    }
    return is_whole ? std::optional(Baseline(std::move(files))) : refuse(fmt::format("is an incomplete {}", form));
  }
  return refuse("is not a report, a batch or a comparison");
}

}  // namespace foredraw
