#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>
#include <foredraw/report/private/json_values.h>

namespace foredraw {

namespace {

Json value_of(const Figure* figure) { return figure == nullptr ? Json(nullptr) : json_of(figure->value()); }

Json json_of(const Branch& branch) {
  Json json{{"name", branch.name}};
  json["seconds"] = branch.is_lost ? Json(nullptr) : Json(stages_seconds(branch.report));
  if (branch.is_lost) json["lost"] = true;
  json["report"] = Json::parse(to_json(branch.report));
  return json;
}

Json json_of(const FigureRow& row) {
  bool lower_is_better = true;
  Json values = Json::array();
  for (const Figure* figure : row.branches) {
    values.push_back(value_of(figure));
    if (figure != nullptr) lower_is_better = figure->lower_is_better;
  }
  return {{"evaluator", row.evaluator},
          {"metric", row.metric},
          {"lower-is-better", lower_is_better},
          {"input", value_of(row.input)},
          {"values", std::move(values)}};
}

Json json_of(const Comparison& comparison) {
  Json json{{"input", {{"path", comparison.input.path}, {"bytes", comparison.input.bytes}}}};
  if (comparison.is_lost()) json["lost"] = true;
  json["branches"] = Json::array();
  for (const Branch& branch : comparison.branches) json["branches"].push_back(json_of(branch));
  json["metrics"] = Json::array();
  for (const FigureRow& row : total_rows(comparison)) json["metrics"].push_back(json_of(row));
  json["fronts"] = Json::array();
  for (const Front& front : fronts_of(comparison)) {
    json["fronts"].push_back({{"x", front.x}, {"y", front.y}, {"branches", front.branches}});
  }
  return json;
}

}  // namespace

std::string to_json(std::span<const Comparison> comparisons, const std::string& since, const Comparison* all) {
  Json json{{"comparison", 1}, {"files", Json::array()}};
  for (const Comparison& comparison : comparisons) json["files"].push_back(json_of(comparison));
  const auto sum = all == nullptr ? sum_of(comparisons) : std::nullopt;
  if (sum) all = &*sum;
  if (all != nullptr) json["all"] = json_of(*all);
  if (!since.empty()) json["since"] = Json::parse(since);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace foredraw
