#include <foredraw/report/figure_rows.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw {

namespace {

/// What one branch measured, before and after.
struct Measurements {
  const Metrics* before = nullptr;
  const Metrics* after = nullptr;
};

std::vector<FigureRow> rows_of(const std::vector<Measurements>& branches) {
  std::set<std::pair<std::string, std::string>> names;
  for (const Measurements& branch : branches) {
    if (branch.after == nullptr) continue;
    for (const auto& [evaluator, by_metric] : branch.after->all()) {
      for (const auto& [metric, figure] : by_metric) names.emplace(evaluator, metric);
    }
  }
  std::vector<FigureRow> rows;
  for (const auto& [evaluator, metric] : names) {
    FigureRow row{evaluator, metric, nullptr, {}};
    for (const Measurements& branch : branches) {
      if (row.input == nullptr && branch.before != nullptr) row.input = branch.before->find(evaluator, metric);
      row.branches.push_back(branch.after == nullptr ? nullptr : branch.after->find(evaluator, metric));
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

bool has_value(const Figure* figure) { return figure != nullptr && std::isfinite(figure->value()); }

}  // namespace

std::vector<FigureRow> total_rows(const Comparison& comparison) {
  std::vector<Measurements> branches;
  for (const Branch& branch : comparison.branches) {
    branches.push_back({&branch.report.before.metrics, &branch.report.after.metrics});
  }
  return rows_of(branches);
}

std::vector<FigureRow> draw_rows(const Comparison& comparison, std::size_t draw) {
  std::vector<Measurements> branches;
  for (const Branch& branch : comparison.branches) {
    const auto& draws = branch.report.draws;
    branches.push_back(draw < draws.size() ? Measurements{&draws[draw].before.metrics, &draws[draw].after.metrics}
                                           : Measurements{});
  }
  return rows_of(branches);
}

std::size_t draw_count(const Comparison& comparison) {
  std::size_t count = 0;
  for (const Branch& branch : comparison.branches) count = std::max(count, branch.report.draws.size());
  return count;
}

std::string draw_name(const Comparison& comparison, std::size_t draw) {
  for (const Branch& branch : comparison.branches) {
    if (draw < branch.report.draws.size()) return branch.report.draws[draw].name;
  }
  return "";
}

bool is_detail(const FigureRow& row) { return row.metric.find('.') != std::string::npos; }

double best_of(const FigureRow& row) {
  if (row.branches.size() < 2) return std::nan("");
  std::vector<double> values;
  bool lower_is_better = true;
  const auto consider = [&](const Figure* figure) {
    if (!has_value(figure) || figure->is_neutral) return;
    values.push_back(figure->value());
    lower_is_better = figure->lower_is_better;
  };
  consider(row.input);
  for (const Figure* figure : row.branches) consider(figure);
  if (values.empty()) return std::nan("");
  const auto [least, most] = std::ranges::minmax(values);
  if (least == most) return std::nan("");
  return lower_is_better ? least : most;
}

std::optional<Difference> difference(const Figure* figure, const Figure* baseline) {
  if (figure == baseline || !has_value(figure) || !has_value(baseline) || baseline->value() == 0) return std::nullopt;
  if (figure->is_neutral) return std::nullopt;
  const double change = figure->value() - baseline->value();
  return Difference{change / std::abs(baseline->value()),
                    change != 0 && std::abs(change) < 2 * std::max(figure->error, baseline->error)};
}

std::string difference_text(const Figure* figure, const Figure* baseline) {
  const auto found = difference(figure, baseline);
  if (!found) return "";
  if (found->is_within_errors) return "~";
  if (std::abs(found->change) >= 0.0005) return fmt::format("{:+.1f} %", 100 * found->change);
  const bool is_exact_count = !figure->denominator && figure->error == 0 && baseline->error == 0;
  return is_exact_count && found->change != 0 ? fmt::format("{:+.0f}", figure->value() - baseline->value()) : "same";
}

}  // namespace foredraw
