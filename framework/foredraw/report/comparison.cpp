#include <foredraw/report/comparison.h>

#include <foredraw/report/pareto.h>
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

/// How much more than the baseline, in parts of it; nothing where there is nothing to tell: none of them, no
/// difference, or one that their errors may make up (two of the larger, for errors of the same views go together).
std::string difference(const Figure& figure, const Figure* baseline) {
  if (baseline == nullptr || !std::isfinite(baseline->value()) || baseline->value() == 0) return "";
  const double change = figure.value() - baseline->value();
  if (change == 0) return "";
  if (std::abs(change) < 2 * std::max(figure.error, baseline->error)) return " ~";
  return fmt::format(" {:+.1f} %", 100 * change / std::abs(baseline->value()));
}

std::string shown(const Figure* figure, double best, const Figure* baseline = nullptr) {
  if (figure == nullptr || !std::isfinite(figure->value())) return "-";
  return to_text(*figure) + difference(*figure, baseline) + (figure->value() == best ? " *" : "");
}

/// Seconds of all stages in each round; the one time that there is where there were none.
std::vector<double> rounds_of(const Report& report) {
  std::vector<double> sums;
  for (const StageRecord& stage : report.stages) {
    const std::vector<double> once{stage.seconds};
    const std::vector<double>& rounds = stage.rounds.empty() ? once : stage.rounds;
    sums.resize(rounds.size());
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += rounds[i];
  }
  return sums;
}

/// "40.9 to 43.0 ms, slower than [1] in 7 of 7 rounds"; nothing where there was one round.
std::string spread_text(const Report& report, const Report* baseline) {
  const std::vector<double> rounds = rounds_of(report);
  if (rounds.size() < 2) return "";
  const auto [least, most] = std::ranges::minmax(rounds);
  std::string text = fmt::format("{:.1f} to {:.1f} ms", 1000 * least, 1000 * most);
  if (baseline == nullptr) return text;
  const std::vector<double> others = rounds_of(*baseline);
  std::size_t faster = 0, slower = 0;
  for (std::size_t i = 0; i < std::min(rounds.size(), others.size()); ++i) {
    faster += rounds[i] < others[i] ? 1 : 0;
    slower += rounds[i] > others[i] ? 1 : 0;
  }
  return text + fmt::format(", {} than [1] in {} of {} rounds", faster > slower ? "faster" : "slower",
                            std::max(faster, slower), rounds.size());
}

/// What branches are judged by two of at a time.
struct Axis {
  std::string name;
  std::vector<double> values;  ///< [branch] the less the better
};

Axis axis_of(const Comparison& comparison, const MetricName& metric) {
  Axis axis{metric.first + " " + metric.second, {}};
  for (const Branch& branch : comparison.branches) {
    const Figure* figure = branch.report.after.metrics.find(metric.first, metric.second);
    const double value = figure == nullptr ? std::nan("") : figure->value();
    axis.values.push_back(figure != nullptr && !figure->lower_is_better ? -value : value);
  }
  return axis;
}

Axis axis_of_time(const Comparison& comparison) {
  Axis axis{"time", {}};
  for (const Branch& branch : comparison.branches) axis.values.push_back(stages_seconds(branch.report));
  return axis;
}

/// "not beaten in both A and B: [1] [3]"; nothing where nobody has both.
std::string front_text(const Axis& x, const Axis& y) {
  std::vector<std::pair<double, double>> points;
  for (std::size_t i = 0; i < x.values.size(); ++i) points.emplace_back(x.values[i], y.values[i]);
  std::vector<std::string> names;
  for (const std::size_t branch : pareto_front(points)) names.push_back(fmt::format("[{}]", branch + 1));
  if (names.empty()) return "";
  return fmt::format("not beaten in both {} and {}: {}\n", x.name, y.name, fmt::join(names, " "));
}

/// Of what most people weigh against each other.
std::string fronts_text(const Comparison& comparison) {
  if (comparison.branches.size() < 3) return "";
  const Axis overdraw = axis_of(comparison, {"overdraw-raster", "ratio"});
  return front_text(axis_of(comparison, {"vertex-cache", "acmr"}), overdraw) +
         front_text(axis_of_time(comparison), overdraw);
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
    std::vector<std::string> row{name.first == last_plugin ? "" : name.first, name.second, shown(input, best)};
    for (const Branch& branch : comparison.branches) {
      const Metrics& baseline = comparison.branches.front().report.after.metrics;
      row.push_back(shown(branch.report.after.metrics.find(name.first, name.second), best,
                          &branch == &comparison.branches.front() ? nullptr : baseline.find(name.first, name.second)));
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
    text += stages.empty() ? "no stages" : "";
    const Report& report = comparison.branches[i].report;
    const std::string spread = spread_text(report, i == 0 ? nullptr : &comparison.branches[0].report);
    text += (spread.empty() ? "" : "; " + spread) + '\n';
  }
  return text + fronts_text(comparison);
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

double stages_seconds(const Report& report) {
  double seconds = 0;
  for (const StageRecord& stage : report.stages) seconds += stage.seconds;
  return seconds;
}

std::string to_json(const std::vector<Comparison>& comparisons) {
  Json json{{"comparison", 1}, {"files", Json::array()}};
  for (const Comparison& comparison : comparisons) json["files"].push_back(json_of(comparison));
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string to_text(const std::vector<Comparison>& comparisons) {
  std::string text;
  for (const Comparison& comparison : comparisons) text += (text.empty() ? "" : "\n") + text_of(comparison);
  return text + "\n* the best of its row; in per cent: against [1]; ~: no more than the errors\n";
}

}  // namespace foredraw
