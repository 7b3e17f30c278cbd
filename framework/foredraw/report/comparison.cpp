#include <foredraw/report/comparison.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;
using MetricName = std::pair<std::string, std::string>;  // plugin, metric

std::set<MetricName> metrics_of(const Comparison& comparison) {
  std::set<MetricName> names;
  for (const Branch& branch : comparison.branches) {
    for (const auto& [plugin, by_metric] : branch.report.after.metrics.all()) {
      for (const auto& [metric, figure] : by_metric) names.emplace(plugin, metric);
    }
  }
  return names;
}

const Figure* before(const Comparison& comparison, const MetricName& name) {
  for (const Branch& branch : comparison.branches) {
    if (const Figure* figure = branch.report.before.metrics.find(name.first, name.second)) return figure;
  }
  return nullptr;
}

/// The best value of a metric over the input and the branches; not a number where all are equal or nobody measured it.
double best_of(const Comparison& comparison, const MetricName& name) {
  std::vector<double> values;
  bool lower_is_better = true;
  const auto consider = [&](const Figure* figure) {
    if (figure == nullptr || !std::isfinite(figure->value())) return;
    values.push_back(figure->value());
    lower_is_better = figure->lower_is_better;
  };
  consider(before(comparison, name));
  for (const Branch& branch : comparison.branches) consider(branch.report.after.metrics.find(name.first, name.second));
  if (values.empty()) return std::nan("");
  const auto [least, most] = std::ranges::minmax(values);
  if (least == most) return std::nan("");
  return lower_is_better ? least : most;
}

double stages_seconds(const Report& report) {
  double seconds = 0;
  for (const StageRecord& stage : report.stages) seconds += stage.seconds;
  return seconds;
}

std::string shown(const Figure* figure, double best) {
  if (figure == nullptr || !std::isfinite(figure->value())) return "-";
  return to_text(*figure) + (figure->value() == best ? " *" : "");
}

std::string text_of(const Comparison& comparison) {
  std::vector<std::string> heads{"", "metric", "input"};
  std::string text = comparison.input.path + '\n';
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    heads.push_back(fmt::format("[{}]", i + 1));
    text += fmt::format("  [{}] {}\n", i + 1, comparison.branches[i].name);
  }
  Table table(heads);
  std::string last_plugin;
  for (const MetricName& name : metrics_of(comparison)) {
    if (name.second.find('.') != std::string::npos) continue;
    const double best = best_of(comparison, name);
    const Figure* input = before(comparison, name);
    std::vector<std::string> row{name.first == last_plugin ? "" : name.first, name.second,
                                 shown(input, best)};
    for (const Branch& branch : comparison.branches) {
      const Figure* figure = branch.report.after.metrics.find(name.first, name.second);
      row.push_back(shown(figure, best));
    }
    table.add(row);
    last_plugin = name.first;
  }
  std::vector<std::string> times{"time", "all stages", ""};
  for (const Branch& branch : comparison.branches) {
    times.push_back(fmt::format("{:.1f} ms", 1000 * stages_seconds(branch.report)));
  }
  table.add(times);
  text += '\n' + table.text();
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    text += fmt::format("  [{}] ", i + 1);
    const auto& stages = comparison.branches[i].report.stages;
    for (const StageRecord& stage : stages) {
      text += fmt::format("{}{} {:.1f} ms", &stage == &stages.front() ? "" : ", ", stage.use, 1000 * stage.seconds);
    }
    text += stages.empty() ? "no stages\n" : "\n";
  }
  return text;
}

Json json_of(const Comparison& comparison) {
  Json json{{"input", {{"path", comparison.input.path}, {"bytes", comparison.input.bytes}}}};
  json["branches"] = Json::array();
  for (const Branch& branch : comparison.branches) {
    json["branches"].push_back({{"name", branch.name},
                                {"seconds", stages_seconds(branch.report)},
                                {"report", Json::parse(to_json(branch.report))}});
  }
  json["metrics"] = Json::array();
  const auto value = [](const Figure* figure) {
    return figure == nullptr || !std::isfinite(figure->value()) ? Json(nullptr) : Json(figure->value());
  };
  for (const MetricName& name : metrics_of(comparison)) {
    Json row{{"evaluator", name.first}, {"metric", name.second}, {"input", value(before(comparison, name))}};
    for (const Branch& branch : comparison.branches) {
      row["values"].push_back(value(branch.report.after.metrics.find(name.first, name.second)));
    }
    json["metrics"].push_back(std::move(row));
  }
  return json;
}

}  // namespace

std::string to_json(const std::vector<Comparison>& comparisons) {
  Json json{{"comparison", 1}, {"files", Json::array()}};
  for (const Comparison& comparison : comparisons) json["files"].push_back(json_of(comparison));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string to_text(const std::vector<Comparison>& comparisons) {
  std::string text;
  for (const Comparison& comparison : comparisons) text += (text.empty() ? "" : "\n") + text_of(comparison);
  return text + "\n* the best of its row\n";
}

}  // namespace foredraw
