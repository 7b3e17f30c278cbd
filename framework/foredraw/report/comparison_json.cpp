#include <foredraw/report/figure_rows.h>
#include <foredraw/report/fronts.h>
#include <foredraw/report/private/report_json.h>

namespace foredraw {

namespace {

void write(JsonWriter& out, const Figure* figure) { figure == nullptr ? out.null() : out.value(figure->value()); }

void write(JsonWriter& out, const Branch& branch) {
  out.begin('{');
  out.key("name").value(branch.name);
  out.key("seconds");
  branch.is_lost ? out.null() : out.value(stages_seconds(branch.report));
  if (branch.is_lost) out.key("lost").value(true);
  write(out.key("report"), branch.report);
  out.end('}');
}

void write(JsonWriter& out, const FigureRow& row) {
  bool lower_is_better = true;
  for (const Figure* figure : row.branches) {
    if (figure != nullptr) lower_is_better = figure->lower_is_better;
  }
  out.begin('{');
  out.key("evaluator").value(row.evaluator);
  out.key("metric").value(row.metric);
  out.key("lower-is-better").value(lower_is_better);
  write(out.key("input"), row.input);
  out.key("values").begin('[');
  for (const Figure* figure : row.branches) write(out, figure);
  out.end(']');
  out.end('}');
}

void write(JsonWriter& out, const Front& front) {
  out.begin('{');
  out.key("x").value(front.x);
  out.key("y").value(front.y);
  out.key("branches").begin('[');
  for (const std::size_t branch : front.branches) out.value(branch);
  out.end(']');
  out.end('}');
}

void write(JsonWriter& out, const Comparison& comparison) {
  out.begin('{');
  out.key("input").begin('{');
  out.key("path").value(comparison.input.path);
  out.key("bytes").value(comparison.input.bytes);
  out.end('}');
  if (comparison.is_lost()) out.key("lost").value(true);
  out.key("branches").begin('[');
  for (const Branch& branch : comparison.branches) write(out, branch);
  out.end(']');
  out.key("metrics").begin('[');
  for (const FigureRow& row : total_rows(comparison)) write(out, row);
  out.end(']');
  out.key("fronts").begin('[');
  for (const Front& front : fronts_of(comparison)) write(out, front);
  out.end(']');
  out.end('}');
}

}  // namespace

std::string to_json(std::span<const Comparison> comparisons, const std::string& since, const Comparison* all) {
  const auto sum = all == nullptr ? sum_of(comparisons) : std::nullopt;
  if (sum) all = &*sum;
  return json_text([&](JsonWriter& out) {
    out.begin('{');
    out.key("comparison").value(1);
    out.key("files").begin('[');
    for (const Comparison& comparison : comparisons) write(out, comparison);
    out.end(']');
    if (all != nullptr) write(out.key("all"), *all);
    if (!since.empty()) out.key("since").json(since);
    out.end('}');
  });
}

}  // namespace foredraw
