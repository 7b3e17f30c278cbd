#include <foredraw/report/figure_rows.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw {

namespace {

/// Quoted where it has to be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

/// What of a file and a branch a line tells.
class Lines {
 public:
  explicit Lines(const Comparison& comparison) : comparison_(comparison) {}

  void add_figures(const std::string& draw, const std::vector<FigureRow>& rows) {
    for (const FigureRow& row : rows) {
      add("input", "", draw, row, row.input);
      for (std::size_t i = 0; i < row.branches.size(); ++i) {
        add(fmt::format("[{}]", i + 1), comparison_.branches[i].name, draw, row, row.branches[i]);
      }
    }
  }

  void add_stage(std::size_t branch, std::size_t stage) {
    const StageRecord& record = comparison_.branches[branch].report.stages[stage];
    const auto line = [&](const char* metric, const std::string& value, const char* unit) {
      text_ += fmt::format("{},[{}],{},{},stage,{},{},{},\r\n", field(comparison_.input.path), branch + 1,
                           field(comparison_.branches[branch].name), "", field(record.use + '.' + metric), value, unit);
    };
    line("seconds", number(record.seconds), "s");
    if (record.memory) line("memory", std::to_string(*record.memory), "bytes");
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& branch, const std::string& pipeline, const std::string& draw, const FigureRow& row,
           const Figure* figure) {
    if (figure == nullptr) return;
    text_ += fmt::format("{},{},{},{},{},{},{},{},{}\r\n", field(comparison_.input.path), branch, field(pipeline),
                         field(draw), field(row.evaluator), field(row.metric), number(figure->value()),
                         field(figure->unit), number(figure->error));
  }

  const Comparison& comparison_;
  std::string text_;
};

}  // namespace

std::string to_csv(const std::vector<Comparison>& comparisons) {
  std::string text = "file,branch,pipeline,draw,evaluator,metric,value,unit,error\r\n";
  for (const Comparison& comparison : comparisons) {
    Lines lines(comparison);
    lines.add_figures("", total_rows(comparison));
    for (std::size_t draw = 0; draw < draw_count(comparison); ++draw) {
      lines.add_figures(draw_name(comparison, draw), draw_rows(comparison, draw));
    }
    for (std::size_t i = 0; i < comparison.branches.size(); ++i) {
      for (std::size_t stage = 0; stage < comparison.branches[i].report.stages.size(); ++stage) {
        lines.add_stage(i, stage);
      }
    }
    text += lines.text();
  }
  return text;
}

}  // namespace foredraw
