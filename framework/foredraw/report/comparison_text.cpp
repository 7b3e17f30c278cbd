#include <foredraw/base/printable.h>
#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// With more branches than that a table is turned: a row a branch.
constexpr std::size_t most_columns = 6;

bool is_wide(const Comparison& comparison) { return comparison.branches.size() > most_columns; }

std::string cell(const Figure* figure, double best, const Figure* baseline) {
  if (figure == nullptr || !std::isfinite(figure->value())) return "-";
  const std::string change = difference_text(figure, baseline);
  return to_text(*figure) + (change.empty() ? "" : ' ' + change) + (figure->value() == best ? " *" : "");
}

std::string time_text(const Branch& branch) {
  return branch.is_lost ? "-" : fmt::format("{:.1f} ms", 1000 * stages_seconds(branch.report));
}

/// A column a branch.
std::string upright_table(const Comparison& comparison) {
  std::vector<std::string> heads{"", "metric", "input"};
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) heads.push_back(fmt::format("[{}]", i + 1));
  Table table(heads);
  std::string last_evaluator;
  for (const FigureRow& row : total_rows(comparison)) {
    if (is_detail(row)) continue;
    const double best = best_of(row);
    std::vector<std::string> cells{row.evaluator == last_evaluator ? "" : row.evaluator, row.metric,
                                   cell(row.input, best, nullptr)};
    for (const Figure* figure : row.branches) cells.push_back(cell(figure, best, baseline_of(row)));
    table.add(cells);
    last_evaluator = row.evaluator;
  }
  std::vector<std::string> times{"time", "all stages", ""};
  for (const Branch& branch : comparison.branches) times.push_back(time_text(branch));
  table.add(times);
  return table.text();
}

/// A row a branch, with the figures that are ratios: what counts add up to would make it too wide.
std::string turned_table(const Comparison& comparison) {
  std::vector<std::string> heads{""};
  std::vector<FigureRow> rows = total_rows(comparison);
  std::erase_if(rows, [](const FigureRow& row) {
    return is_detail(row) ||
           std::ranges::none_of(row.branches, [](const Figure* f) { return f != nullptr && f->denominator; });
  });
  for (const FigureRow& row : rows) heads.push_back(row.evaluator + ' ' + row.metric);
  heads.push_back("time");
  Table table(heads);
  std::vector<std::string> input{"input"};
  for (const FigureRow& row : rows) input.push_back(cell(row.input, best_of(row), nullptr));
  table.add(input);
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    std::vector<std::string> cells{fmt::format("[{}]", i + 1)};
    for (const FigureRow& row : rows) cells.push_back(cell(row.branches[i], best_of(row), baseline_of(row)));
    cells.push_back(time_text(comparison.branches[i]));
    table.add(cells);
  }
  return table.text();
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

std::string stage_text(const StageRecord& stage) {
  std::string text = fmt::format("{} {:.1f} ms", stage.use, 1000 * stage.seconds);
  if (stage.memory) text += fmt::format(" {:.1f} MB", static_cast<double>(*stage.memory) / 1e6);
  return text;
}

std::string stages_text(const Comparison& comparison, std::size_t branch) {
  const Branch& own = comparison.branches[branch];
  if (own.is_lost) return "could not be planned";
  std::string text;
  for (const StageRecord& stage : own.report.stages) text += (text.empty() ? "" : ", ") + stage_text(stage);
  if (text.empty()) text = "no stages";
  const Branch& baseline = comparison.branches.front();
  const std::string spread = spread_text(own.report, branch == 0 || baseline.is_lost ? nullptr : &baseline.report);
  return text + (spread.empty() ? "" : "; " + spread);
}

/// A single pipeline is the best of nothing.
bool has_rivals(const Comparison& comparison) { return comparison.branches.size() > 1; }

std::string spaced(std::string figure) {
  std::ranges::replace(figure, '.', ' ');
  return figure;
}

std::string text_of(const Comparison& comparison) {
  std::string text = printable(comparison.input.path) + '\n';
  if (comparison.is_lost()) return text + "  could not be read\n";
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    text += fmt::format("  [{}] {}\n", i + 1, printable(comparison.branches[i].name));
  }
  text += '\n' + (is_wide(comparison) ? turned_table(comparison) : upright_table(comparison));
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    text += fmt::format("  [{}] {}\n", i + 1, stages_text(comparison, i));
  }
  if (!has_rivals(comparison)) return text;
  for (const Front& front : fronts_of(comparison)) {
    std::vector<std::string> names;
    for (const std::size_t branch : front.branches) names.push_back(fmt::format("[{}]", branch + 1));
    text += fmt::format("best trade-offs of {} and {}: {}\n", spaced(front.x), spaced(front.y), fmt::join(names, " "));
  }
  return text;
}

}  // namespace

std::string to_text(const std::vector<Comparison>& comparisons) {
  std::string text;
  for (const Comparison& comparison : comparisons) text += (text.empty() ? "" : "\n") + text_of(comparison);
  if (const auto sum = sum_of(comparisons)) text += '\n' + text_of(*sum);
  if (std::ranges::none_of(comparisons, has_rivals)) return text;
  const bool is_turned = std::ranges::any_of(comparisons, is_wide);
  return text +
         fmt::format(
             "\n* best of its {}; per cent: change against [1]; same: by less than 0.05 %; ~: within the errors\n",
             is_turned ? "column" : "row");
}

}  // namespace foredraw
