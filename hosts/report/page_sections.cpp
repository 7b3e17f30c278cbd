#include "page_sections.h"

#include "html.h"

#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// More rows than that make a page slow; the JSON form has them all.
constexpr std::size_t most_draw_rows = 2000;

std::string number_of(std::size_t branch) { return fmt::format("[{}]", branch + 1); }

/// `file`: its number, or "all".
std::string article(const Comparison& comparison, const std::string& file, const std::string& content) {
  return element("article", element("h3", escaped(comparison.input.path)) + '\n' + content,
                 fmt::format("class=\"file\" data-file=\"{}\"", file)) + '\n';
}

template <class Content>
std::string articles(std::span<const Comparison> comparisons, Content content) {
  std::string html;
  for (std::size_t i = 0; i < comparisons.size(); ++i) {
    const std::string inside = content(comparisons[i]);
    if (!inside.empty()) html += article(comparisons[i], std::to_string(i), inside);
  }
  return html;
}

/// The same, and all files as one before them.
template <class Content>
std::string articles_and_sum(std::span<const Comparison> comparisons, Content content) {
  const auto sum = sum_of({comparisons.begin(), comparisons.end()});
  return (sum ? article(*sum, "all", content(*sum)) : "") + articles(comparisons, content);
}

std::string table(const std::string& heads, const std::string& rows, const std::string& kind) {
  return element("div",
                 element("table", element("thead", element("tr", heads)) + '\n' + element("tbody", '\n' + rows),
                         fmt::format("class=\"sortable {}\"", kind)),
                 "class=\"scroll\"") + '\n';
}

std::string branch_heads(const Comparison& comparison) {
  std::string heads = element("th", "input", "class=\"number\"");
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    heads += element("th", number_of(i), fmt::format("class=\"number\" data-branch=\"{}\"", i));
  }
  return heads;
}

std::string change_html(const Figure& figure, const Figure* baseline) {
  const auto found = difference(&figure, baseline);
  if (!found) return "";
  if (found->is_within_errors) return ' ' + element("span", "~", "class=\"change none\"");
  const bool is_better = (found->change < 0) == figure.lower_is_better;
  return ' ' + element("span", fmt::format("{:+.1f} %", 100 * found->change),
                       is_better ? "class=\"change better\"" : "class=\"change worse\"");
}

std::string cell(const Figure* figure, double best, const Figure* baseline, const std::string& branch) {
  if (figure == nullptr || !std::isfinite(figure->value())) return element("td", "-", "class=\"number\"" + branch);
  const bool is_best = figure->value() == best;
  return element("td", escaped(to_text(*figure)) + change_html(*figure, baseline),
                 fmt::format("class=\"number{}\" data-value=\"{}\"{}", is_best ? " best" : "", figure->value(), branch));
}

std::string unit_of(const FigureRow& row) {
  for (const Figure* figure : row.branches) {
    if (figure != nullptr) return figure->unit;
  }
  return "";
}

std::string figure_cells(const FigureRow& row) {
  const double best = best_of(row);
  std::string cells = cell(row.input, best, nullptr, "");
  for (std::size_t i = 0; i < row.branches.size(); ++i) {
    cells += cell(row.branches[i], best, baseline_of(row), fmt::format(" data-branch=\"{}\"", i));
  }
  return cells;
}

std::string time_row(const Comparison& comparison) {
  std::string cells = element("td", "time") + element("td", "all stages") + element("td", "ms") +
                      element("td", "", "class=\"number\"");
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    const Branch& branch = comparison.branches[i];
    const double seconds = stages_seconds(branch.report);
    cells += branch.is_lost ? element("td", "-", "class=\"number\"")
                            : element("td", fmt::format("{:.1f}", 1000 * seconds),
                                      fmt::format("class=\"number\" data-value=\"{}\" data-branch=\"{}\"", seconds, i));
  }
  return element("tr", cells) + '\n';
}

// --- the summary

/// A figure in the words of who has never heard of it.
struct PlainWords {
  std::string_view metric;
  std::string_view less;  ///< what is done less often where the figure is lower
};
constexpr PlainWords plain_words[] = {{"ratio", "pixels are shaded"}, {"acmr", "vertices are transformed"}};

/// "pixels are shaded 4.0 % less often"; nothing where there is nothing to tell.
std::string plain_change(const FigureRow& row, std::size_t branch, std::string_view what) {
  const auto found = difference(row.branches[branch], row.input);
  if (row.branches[branch] == nullptr || row.input == nullptr) return "";
  if (!found || found->is_within_errors) return fmt::format("{} as often as before", what);
  return fmt::format("{} {:.1f} % {} often", what, std::abs(100 * found->change), found->change < 0 ? "less" : "more");
}

std::string finding(const Comparison& comparison, std::size_t index, const std::vector<FigureRow>& rows) {
  const Branch& branch = comparison.branches[index];
  if (branch.is_lost) return fmt::format("{} could not be planned for this file: see Diagnostics.", number_of(index));
  std::vector<std::string> parts;
  for (const PlainWords& words : plain_words) {
    const auto row = std::ranges::find(rows, words.metric, &FigureRow::metric);
    if (row == rows.end()) continue;
    const std::string part = plain_change(*row, index, words.less);
    if (!part.empty()) parts.push_back(part);
  }
  std::string text = number_of(index) + ": " + fmt::format("{}", fmt::join(parts, ", ")) + (parts.empty() ? "" : "; ") +
                     fmt::format("{:.0f} ms of work.", 1000 * stages_seconds(branch.report));
  const bool has_errors = std::ranges::any_of(branch.report.diagnostics,
                                              [](const Diagnostic& d) { return d.severity == Severity::error; });
  return has_errors ? text + " Something failed: see Diagnostics." : text;
}

std::string fronts_html(const Comparison& comparison) {
  std::string items;
  for (const Front& front : fronts_of(comparison)) {
    std::vector<std::string> names;
    for (const std::size_t branch : front.branches) names.push_back(number_of(branch));
    items += element("li", escaped(fmt::format("Not beaten in both {} and {}: {}.", front.x, front.y,
                                               fmt::join(names, " ")))) + '\n';
  }
  return items;
}

std::string summary_of(const Comparison& comparison) {
  const std::vector<FigureRow> rows = total_rows(comparison);
  std::string branches, findings;
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    branches += element("li", element("span", number_of(i), "class=\"branch\"") + ' ' +
                                  element("code", escaped(comparison.branches[i].name)),
                        fmt::format("data-branch=\"{}\"", i)) + '\n';
    findings += element("li", escaped(finding(comparison, i, rows))) + '\n';
  }
  return element("ol", '\n' + branches, "class=\"branches\"") + '\n' +
         element("ul", '\n' + findings + fronts_html(comparison), "class=\"findings\"");
}

// --- stages

std::string stage_row(const StageRecord& stage) {
  const auto [least, most] =
      stage.rounds.empty() ? std::ranges::minmax_result<double>{stage.seconds, stage.seconds} : std::ranges::minmax(stage.rounds);
  const std::string spread =
      stage.rounds.empty() ? element("td", "-", "class=\"number\"")
                           : element("td", fmt::format("{:.2f} to {:.2f} ms", 1000 * least, 1000 * most),
                                     fmt::format("class=\"number\" data-value=\"{}\"", most - least));
  const std::string memory = !stage.memory ? element("td", "-", "class=\"number\"")
                                           : element("td", fmt::format("{:.1f} MB", static_cast<double>(*stage.memory) / 1e6),
                                                     fmt::format("class=\"number\" data-value=\"{}\"", *stage.memory));
  return element("tr", element("td", escaped(stage.text)) +
                           element("td", escaped(fmt::format("{} of {} {}", stage.changed, stage.candidates, stage.places)),
                                   fmt::format("class=\"number\" data-value=\"{}\"", stage.changed)) +
                           element("td", fmt::format("{:.2f} ms", 1000 * stage.seconds),
                                   fmt::format("class=\"number\" data-value=\"{}\"", stage.seconds)) +
                           spread + memory) + '\n';
}

std::string skips_html(const std::vector<StageRecord>& stages) {
  std::string items;
  for (const StageRecord& stage : stages) {
    for (const SkipRecord& skip : stage.skipped) {
      const std::string places = skip.places.empty()      ? "everything"
                                 : skip.places.size() > 5 ? fmt::format("{} {}", skip.places.size(), stage.places)
                                                          : fmt::format("{}", fmt::join(skip.places, ", "));
      items += element("li", escaped(fmt::format("{} left {} alone: {}", stage.use, places, skip.reason))) + '\n';
    }
    for (const NoteRecord& note : stage.notes) {
      items += element("li", escaped(stage.use + (note.place.empty() ? "" : " on " + note.place) + ": " + note.message)) + '\n';
    }
  }
  return items.empty() ? "" : element("ul", '\n' + items, "class=\"skipped\"") + '\n';
}

std::string stages_of(const Comparison& comparison) {
  std::string html;
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    const Branch& branch = comparison.branches[i];
    if (branch.is_lost) continue;
    html += element("h4", number_of(i) + ' ' + element("code", escaped(branch.name))) + '\n';
    std::string rows;
    for (const StageRecord& stage : branch.report.stages) rows += stage_row(stage);
    const std::string heads = element("th", "stage") + element("th", "changed", "class=\"number\"") +
                              element("th", "time", "class=\"number\"") + element("th", "spread", "class=\"number\"") +
                              element("th", "memory", "class=\"number\"");
    html += rows.empty() ? element("p", "No stages.") : table(heads, rows, "stages");
    html += skips_html(branch.report.stages) + skips_html(branch.report.measures);
  }
  return html;
}

}  // namespace

std::string summary_html(std::span<const Comparison> comparisons) { return articles_and_sum(comparisons, summary_of); }

std::string figures_html(std::span<const Comparison> comparisons) {
  const std::string legend =
      element("p", comparisons.empty() || comparisons[0].branches.size() < 2
                       ? "Errors are one standard error."
                       : "In per cent: against [1]; ~: no more than the errors may make up. The best of a row is marked.",
              "class=\"legend\"");
  return legend + '\n' + articles_and_sum(comparisons, [](const Comparison& comparison) {
    std::string rows;
    for (const FigureRow& row : total_rows(comparison)) {
      if (is_detail(row)) continue;
      rows += element("tr", element("td", escaped(row.evaluator)) + element("td", escaped(row.metric)) +
                                element("td", escaped(unit_of(row))) + figure_cells(row)) + '\n';
    }
    const std::string heads = element("th", "evaluator") + element("th", "metric") + element("th", "unit") + branch_heads(comparison);
    return table(heads, rows + time_row(comparison), "figures");
  });
}

std::string draws_html(std::span<const Comparison> comparisons) {
  return articles(comparisons, [](const Comparison& comparison) {
    std::string rows;
    std::size_t count = 0;
    for (std::size_t draw = 0; draw < draw_count(comparison); ++draw) {
      for (const FigureRow& row : draw_rows(comparison, draw)) {
        if (is_detail(row) || ++count > most_draw_rows) continue;
        rows += element("tr", element("td", escaped(draw_name(comparison, draw))) +
                                  element("td", escaped(row.evaluator)) + element("td", escaped(row.metric)) + figure_cells(row)) + '\n';
      }
    }
    if (rows.empty()) return std::string();
    const std::string heads = element("th", "draw") + element("th", "evaluator") + element("th", "metric") + branch_heads(comparison);
    const std::string more = count <= most_draw_rows
                                 ? ""
                                 : element("p", fmt::format("{} more figures are in the JSON form.", count - most_draw_rows));
    return table(heads, rows, "draws") + more;
  });
}

std::string stages_html(std::span<const Comparison> comparisons) { return articles(comparisons, stages_of); }

std::string diagnostics_html(std::span<const Comparison> comparisons) {
  return articles(comparisons, [](const Comparison& comparison) {
    std::string items;
    for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
      for (const Diagnostic& diagnostic : comparison.branches[i].report.diagnostics) {
        items += element("li", escaped(number_of(i) + ' ' + to_text(diagnostic)),
                         fmt::format("class=\"{}\"", to_text(diagnostic.severity))) + '\n';
      }
    }
    return items.empty() ? items : element("ul", '\n' + items);
  });
}

std::string pipelines_html(std::span<const Comparison> comparisons) {
  std::string html;
  if (comparisons.empty()) return html;
  const std::vector<Branch>& branches = comparisons.front().branches;  // the same on every file
  for (std::size_t i = 0; i < branches.size(); ++i) {
    html += element("details", element("summary", number_of(i) + ' ' + escaped(branches[i].name)) +
                                   element("pre", escaped(branches[i].report.pipeline))) + '\n';
  }
  return html;
}

std::string run_html(std::span<const Comparison> comparisons, const std::string& program) {
  std::string rows;
  const auto add = [&](std::string_view name, const std::string& value) {
    if (!value.empty()) rows += element("dt", name) + element("dd", escaped(value)) + '\n';
  };
  add("Program", program);
  for (const Comparison& comparison : comparisons) {
    const auto branch = std::ranges::find(comparison.branches, false, &Branch::is_lost);
    if (branch == comparison.branches.end()) continue;
    const Report& report = branch->report;
    add("Machine", report.machine);
    add("Threads", std::to_string(report.threads));
    add("Seed", std::to_string(report.seed));
    break;
  }
  return element("dl", '\n' + rows);
}

}  // namespace foredraw
