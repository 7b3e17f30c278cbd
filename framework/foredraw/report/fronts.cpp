#include <foredraw/report/fronts.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// [branch] the less the better.
std::vector<double> costs_of(const Comparison& comparison, const std::string& name) {
  std::vector<double> costs;
  for (const Branch& branch : comparison.branches) {
    const Figure* figure = branch.report.after.metrics.find(name);
    const double sign = figure != nullptr && !figure->lower_is_better ? -1 : 1;
    costs.push_back(sign * value_of(branch, name).value_or(std::nan("")));
  }
  return costs;
}

}  // namespace

std::vector<std::size_t> pareto_front(std::span<const std::pair<double, double>> points) {
  std::vector<std::size_t> front;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].first, y = points[i].second;
    if (!std::isfinite(x) || !std::isfinite(y)) continue;
    const bool is_beaten = std::ranges::any_of(points, [&](const std::pair<double, double>& other) {
      return other.first <= x && other.second <= y && (other.first < x || other.second < y);
    });
    if (!is_beaten) front.push_back(i);
  }
  return front;
}

std::vector<Front> fronts_of(const Comparison& comparison) {
  auto axes = comparison.fronts;
  if (axes.empty() && comparison.branches.size() >= 3) {
    axes = {{"vertex-cache.acmr", "overdraw-raster.ratio"}, {"time", "overdraw-raster.ratio"}};
  }
  std::vector<Front> fronts;
  for (const auto& [x, y] : axes) {
    const std::vector<double> across = costs_of(comparison, x);
    const std::vector<double> up = costs_of(comparison, y);
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < across.size(); ++i) points.emplace_back(across[i], up[i]);
    Front front{x, y, pareto_front(points)};
    if (!front.branches.empty()) fronts.push_back(std::move(front));
  }
  return fronts;
}

std::vector<std::string> unknown_figures(const Comparison& comparison) {
  std::vector<std::string> unknown;
  for (const auto& [x, y] : comparison.fronts) {
    for (const std::string& figure : {x, y}) {
      const bool is_known = std::ranges::any_of(
          comparison.branches, [&](const Branch& branch) { return value_of(branch, figure).has_value(); });
      if (!is_known) unknown.push_back(figure);
    }
  }
  return unknown;
}

std::optional<std::pair<std::string, std::string>> parse_front(const std::string& text, Diagnostics& diagnostics) {
  const auto is_figure = [](const std::string& name) { return name == "time" || name.find('.') != std::string::npos; };
  const std::size_t comma = std::min(text.find(','), text.size());
  const std::size_t second = std::min(text.find_first_not_of(", ", comma), text.size());
  const std::string x = text.substr(0, comma);
  const std::string y = text.substr(second);
  if (is_figure(x) && is_figure(y)) return std::pair(x, y);
  diagnostics.error({.file = "--front"}, "syntax", fmt::format("expected two figures, found '{}'", text),
                    "such as time,overdraw-raster.ratio");
  return std::nullopt;
}

}  // namespace foredraw
