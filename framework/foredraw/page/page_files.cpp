#include <foredraw/page/private/page_files.h>

#include <foredraw/page/private/page_parts.h>

#include <foredraw/report/figure_rows.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

/// Text, for a number would be written in all its digits.
std::string number_text(const Figure* figure) {
  return figure == nullptr || !std::isfinite(figure->value()) ? "null" : fmt::format("{:.6g}", figure->value());
}

using Name = std::pair<std::string, std::string>;  // evaluator and metric

/// Every figure that some file has, with one of them; those of groups are left out.
std::map<Name, const Figure*> figures_in(std::span<const Comparison> comparisons) {
  std::map<Name, const Figure*> figures;
  for (const Comparison& comparison : comparisons) {
    for (const FigureRow& row : total_rows(comparison)) {
      const auto known = std::ranges::find_if(row.branches, [](const Figure* figure) { return figure != nullptr; });
      const Figure* figure = known == row.branches.end() ? row.input : *known;
      if (figure != nullptr && !is_detail(row)) figures.emplace(Name{row.evaluator, row.metric}, figure);
    }
  }
  return figures;
}

std::string figure_head(const Name& name, const Figure& figure) {
  const Json head{{"evaluator", name.first},
                  {"metric", name.second},
                  {"unit", figure.unit},
                  {"lower-is-better", figure.lower_is_better},
                  {"is-count", !figure.denominator}};
  std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.pop_back();
  return text;
}

/// Of the state, in the file's totals: 0 is the input, the branch i is i + 1.
const Figure* figure_of(const Comparison& comparison, const Name& name, std::size_t state) {
  const auto at = [&](const Branch& branch) {
    const StateRecord& record = state == 0 ? branch.report.before : branch.report.after;
    return branch.is_lost ? nullptr : record.metrics.find(name.first, name.second);
  };
  if (state > 0) return state <= comparison.branches.size() ? at(comparison.branches[state - 1]) : nullptr;
  const auto whole = std::ranges::find(comparison.branches, false, &Branch::is_lost);
  return whole == comparison.branches.end() ? nullptr : at(*whole);
}

}  // namespace

std::string file_figures(std::span<const Comparison> comparisons) {
  Json files = Json::array(), states{"input"};
  for (const Comparison& comparison : comparisons) files.push_back(comparison.input.path);
  const auto whole = std::ranges::find(comparisons, false, &Comparison::is_lost);
  if (whole != comparisons.end()) {
    for (std::size_t i = 0; i < whole->branches.size(); ++i) {
      states.push_back(number_of(i) + ' ' + whole->branches[i].name);
    }
  }
  std::string figures;
  for (const auto& [name, figure] : figures_in(comparisons)) {
    figures += (figures.empty() ? "" : ",") + figure_head(name, *figure) + ",\"values\":[";
    for (std::size_t state = 0; state < states.size(); ++state) {
      figures += state == 0 ? "[" : ",[";
      for (std::size_t i = 0; i < comparisons.size(); ++i) {
        figures += (i == 0 ? "" : ",") + number_text(figure_of(comparisons[i], name, state));
      }
      figures += ']';
    }
    figures += "]}";
  }
  const auto text = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
  return "{\"files\":" + text(files) + ",\"states\":" + text(states) + ",\"figures\":[" + figures + "]}";
}

}  // namespace foredraw
