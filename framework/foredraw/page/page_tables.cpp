#include <foredraw/page/private/page_sections.h>

#include <foredraw/page/private/page_parts.h>

#include <foredraw/report/figure_rows.h>

#include <cmath>

namespace foredraw {

namespace {

/// More rows than that make a page slow; the JSON form has them all.
constexpr std::size_t most_draw_rows = 2000;

std::string branch_heads(const Comparison& comparison) {
  std::string heads = element("th", "input", "class=\"number\"");
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    heads += element("th", number_of(i), fmt::format("class=\"number\" data-branch=\"{}\"", i));
  }
  return heads;
}

std::string change_html(const Figure& figure, const Figure* baseline) {
  const std::string text = difference_text(&figure, baseline);
  if (text.empty()) return "";
  if (text == "~" || text == "same") return ' ' + element("span", text, "class=\"change none\"");
  const bool is_better = (figure.value() < baseline->value()) == figure.lower_is_better;
  return ' ' + element("span", text, is_better ? "class=\"change better\"" : "class=\"change worse\"");
}

std::string cell(const Figure* figure, double best, const Figure* baseline, const std::string& branch) {
  if (figure == nullptr || !std::isfinite(figure->value())) return element("td", "-", "class=\"number\"" + branch);
  const bool is_best = figure->value() == best;
  return element(
      "td", escaped(to_text(*figure)) + change_html(*figure, baseline),
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
  std::string cells =
      element("td", "time") + element("td", "all stages") + element("td", "ms") + element("td", "", "class=\"number\"");
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    const Branch& branch = comparison.branches[i];
    const double seconds = stages_seconds(branch.report);
    cells += branch.is_lost ? element("td", "-", "class=\"number\"")
                            : element("td", fmt::format("{:.1f}", 1000 * seconds),
                                      fmt::format("class=\"number\" data-value=\"{}\" data-branch=\"{}\"", seconds, i));
  }
  return element("tr", cells) + '\n';
}

}  // namespace

std::string figures_html(std::span<const Comparison> comparisons, const Comparison* all) {
  const std::string legend =
      element("p",
              comparisons.empty() || comparisons[0].branches.size() < 2
                  ? "Errors are one standard error."
                  : "Per cent: change against [1]. Same: by less than 0.05 %. ~: within the errors. The best of a row "
                    "is marked.",
              "class=\"legend\"");
  return legend + '\n' + articles_and_sum(comparisons, all, [](const Comparison& comparison) {
           if (comparison.is_lost()) return std::string();
           std::string rows;
           for (const FigureRow& row : total_rows(comparison)) {
             if (is_detail(row)) continue;
             rows += element("tr", element("td", escaped(row.evaluator)) + element("td", escaped(row.metric)) +
                                       element("td", escaped(unit_of(row))) + figure_cells(row)) +
                     '\n';
           }
           const std::string heads =
               element("th", "evaluator") + element("th", "metric") + element("th", "unit") + branch_heads(comparison);
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
        rows +=
            element("tr", element("td", escaped(draw_name(comparison, draw))) + element("td", escaped(row.evaluator)) +
                              element("td", escaped(row.metric)) + figure_cells(row)) +
            '\n';
      }
    }
    if (rows.empty()) return std::string();
    const std::string heads =
        element("th", "draw") + element("th", "evaluator") + element("th", "metric") + branch_heads(comparison);
    const std::string more =
        count <= most_draw_rows
            ? ""
            : element("p", fmt::format("{} more figures are in the JSON form.", count - most_draw_rows));
    return table(heads, rows, "draws") + more;
  });
}

}  // namespace foredraw
