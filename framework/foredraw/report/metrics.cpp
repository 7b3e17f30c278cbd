#include <foredraw/report/metrics.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw {

namespace {

/// With a comma before each three digits of a count, as counts in words have them.
std::string number_text(double value, bool is_ratio) {
  if (is_ratio) return fmt::format("{:.4f}", value);
  std::string digits = fmt::format("{:.0f}", value);
  const std::size_t first = digits.front() == '-' ? 1 : 0;
  for (std::size_t at = digits.size(); at > first + 3; digits.insert(at, ",")) at -= 3;
  return digits;
}

}  // namespace

std::string to_text(const Figure& figure) {
  if (!std::isfinite(figure.value())) return "-";
  const std::string text = number_text(figure.value(), figure.denominator.has_value());
  return figure.error > 0 ? text + " ±" + number_text(figure.error, figure.denominator.has_value()) : text;
}

void Metrics::add(const std::string& plugin, const std::string& metric, const Figure& figure) {
  const auto [at, is_new] = by_plugin_[plugin].emplace(metric, figure);
  if (is_new) return;
  Figure& sum = at->second;
  if (figure.worst_stands) {
    const bool is_worse = figure.lower_is_better ? figure.value() > sum.value() : figure.value() < sum.value();
    if (is_worse || !std::isfinite(sum.value())) sum = figure;
    return;
  }
  if (sum.denominator && figure.denominator) {
    const double whole = *sum.denominator + *figure.denominator;
    if (whole > 0) sum.error = (sum.error * *sum.denominator + figure.error * *figure.denominator) / whole;
    sum.denominator = whole;
  } else {
    sum.error += figure.error;
  }
  sum.numerator += figure.numerator;
}

void Metrics::add(const Metrics& others) {
  for (const auto& [plugin, by_metric] : others.all()) {
    for (const auto& [metric, figure] : by_metric) add(plugin, metric, figure);
  }
}

void Metrics::set(const std::string& plugin, const std::string& metric, const Figure& figure) {
  by_plugin_[plugin][metric] = figure;
}

const Figure* Metrics::find(const std::string& name) const {
  const std::size_t dot = name.find('.');
  return dot == std::string::npos ? nullptr : find(name.substr(0, dot), name.substr(dot + 1));
}

const Figure* Metrics::find(const std::string& plugin, const std::string& metric) const {
  const auto by_metric = by_plugin_.find(plugin);
  if (by_metric == by_plugin_.end()) return nullptr;
  const auto at = by_metric->second.find(metric);
  return at == by_metric->second.end() ? nullptr : &at->second;
}

Figure figure_of(const Measured& measured, const Card& card) {
  Figure figure{measured.numerator, measured.denominator, measured.error, {}, true};
  const std::string& name = measured.metric;
  const std::string last = name.substr(name.rfind('.') + 1);
  for (const Metric& metric : card.metrics) {
    if (metric.name != name && metric.name != last) continue;
    figure.unit = metric.unit;
    figure.lower_is_better = metric.lower_is_better;
    figure.worst_stands = metric.worst_stands;
    figure.is_neutral = metric.is_neutral;
    if (metric.name == name) break;
  }
  return figure;
}

}  // namespace foredraw
