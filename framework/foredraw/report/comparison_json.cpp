#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>
#include <foredraw/report/private/report_json.h>

namespace foredraw {

namespace {

using foredraw::json_of;

Json json_of(const Figure* figure) { return figure == nullptr ? Json(nullptr) : json_of(figure->value()); }

Json json_of(const Branch& branch) {
  Json json = JsonObject{{"name", branch.name},
                         {"seconds", branch.is_lost ? Json(nullptr) : json_of(stages_seconds(branch.report))}};
  if (branch.is_lost) json["lost"] = true;
  json["report"] = json_of(branch.report);
  return json;
}

Json json_of(const FigureRow& row) {
  bool lower_is_better = true;
  Json values = Json::array();
  for (const Figure* figure : row.branches) {
    if (figure != nullptr) lower_is_better = figure->lower_is_better;
    values.push_back(json_of(figure));
  }
  return JsonObject{{"evaluator", row.evaluator},
                    {"metric", row.metric},
                    {"lower-is-better", lower_is_better},
                    {"input", json_of(row.input)},
                    {"values", std::move(values)}};
}

Json json_of(const Comparison& comparison) {
  Json json = JsonObject{{"input", JsonObject{{"path", comparison.input.path}, {"bytes", comparison.input.bytes}}}};
  if (comparison.is_lost()) json["lost"] = true;
  for (const char* list : {"branches", "metrics", "fronts"}) json[list] = Json::array();
  for (const Branch& branch : comparison.branches) json["branches"].push_back(json_of(branch));
  for (const FigureRow& row : total_rows(comparison)) json["metrics"].push_back(json_of(row));
  for (const Front& front : fronts_of(comparison)) {
    json["fronts"].push_back(JsonObject{{"x", front.x}, {"y", front.y}, {"branches", front.branches}});
  }
  return json;
}

}  // namespace

std::string to_json(std::span<const Comparison> comparisons, const std::string& since, const Comparison* all) {
  const auto sum = all == nullptr ? sum_of(comparisons) : std::nullopt;
  if (sum) all = &*sum;
  std::string text = "{\n  \"comparison\": 1,\n  \"files\": [";
  const auto put = [&](std::string_view piece) { text += piece; };
  for (const Comparison& comparison : comparisons) {  // one at a time: of many files no tree stands in memory
    put(&comparison == comparisons.data() ? "\n    " : ",\n    ");
    put_indented(indented_text(json_of(comparison)), "    ", put);
  }
  put(comparisons.empty() ? "]" : "\n  ]");
  if (all != nullptr) {
    put(",\n  \"all\": ");
    put_indented(indented_text(json_of(*all)), "  ", put);
  }
  if (!since.empty()) {
    put(",\n  \"since\": ");
    put_indented(since, "  ", put);
  }
  return text + "\n}\n";
}

}  // namespace foredraw
