#include <foredraw/page/private/page_sections.h>

#include <foredraw/page/private/page_parts.h>

#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

/// A figure in the words of who has never heard of it.
struct PlainWords {
  std::string_view metric;
  std::string_view work;  ///< what is counted
  std::string_view per;   ///< for each of what; told where their number has changed too
};
constexpr PlainWords plain_words[] = {{"acmr", "vertices shaded", "triangle"},
                                      {"ratio", "pixels shaded", "visible pixel"}};

bool is_alike(double before, double after) { return std::abs(after - before) < 0.0005 * std::abs(before); }

/// "4.0 % fewer pixels shaded"; nothing where there is nothing to tell.
std::string plain_change(const Figure* after, const Figure* before, const PlainWords& words) {
  if (after == nullptr || before == nullptr) return "";
  const auto found = difference(after, before);
  if (!found || found->is_within_errors || std::abs(found->change) < 0.0005) {
    return fmt::format("as many {} as before", words.work);
  }
  const bool has_as_many = is_alike(before->denominator.value_or(1), after->denominator.value_or(1));
  return fmt::format("{:.1f} % {} {}{}", std::abs(100 * found->change), found->change < 0 ? "fewer" : "more",
                     words.work, has_as_many ? "" : fmt::format(" per {}", words.per));
}

/// "830 ms", "1.2 s".
std::string plain_time(double seconds) {
  return seconds < 1 ? fmt::format("{:.0f} ms", 1000 * seconds) : fmt::format("{:.1f} s", seconds);
}

std::string finding(const Comparison& comparison, std::size_t index, const std::vector<FigureRow>& rows) {
  const Branch& branch = comparison.branches[index];
  if (branch.is_lost) return fmt::format("{} could not be planned for this file: see Diagnostics.", number_of(index));
  std::vector<std::string> parts;
  for (const PlainWords& words : plain_words) {
    const auto row = std::ranges::find(rows, words.metric, &FigureRow::metric);
    if (row == rows.end()) continue;
    const std::string part = plain_change(row->branches[index], row->input, words);
    if (!part.empty()) parts.push_back(part);
  }
  std::string text = number_of(index) + ": " + fmt::format("{}", fmt::join(parts, ", ")) + (parts.empty() ? "" : "; ") +
                     fmt::format("the stages took {}.", plain_time(stages_seconds(branch.report)));
  const bool has_errors =
      std::ranges::any_of(branch.report.diagnostics, [](const Diagnostic& d) { return d.severity == Severity::error; });
  return has_errors ? text + " Something failed: see Diagnostics." : text;
}

std::string fronts_html(const Comparison& comparison) {
  std::string items;
  if (comparison.branches.size() < 2) return items;  // a single one has no rivals
  for (const Front& front : fronts_of(comparison)) {
    std::vector<std::string> names;
    for (const std::size_t branch : front.branches) names.push_back(number_of(branch));
    items += element("li", escaped(fmt::format("No other pipeline is better in both {} and {}: {}.", front.x, front.y,
                                               fmt::join(names, " ")))) +
             '\n';
  }
  return items;
}

std::string summary_of(const Comparison& comparison) {
  if (comparison.is_lost()) return element("p", "Could not be read: see Diagnostics.");
  const std::vector<FigureRow> rows = total_rows(comparison);
  std::string branches, findings;
  for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
    branches += element("li",
                        element("span", number_of(i), "class=\"branch\"") + ' ' +
                            element("code", escaped(comparison.branches[i].name)),
                        fmt::format("data-branch=\"{}\"", i)) +
                '\n';
    findings += element("li", escaped(finding(comparison, i, rows))) + '\n';
  }
  return element("ol", '\n' + branches, "class=\"branches\"") + '\n' +
         element("ul", '\n' + findings + fronts_html(comparison), "class=\"findings\"");
}

}  // namespace

std::string summary_html(std::span<const Comparison> comparisons, const Comparison* all) {
  return articles_and_sum(comparisons, all, summary_of);
}

}  // namespace foredraw
