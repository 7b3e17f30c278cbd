#include <foredraw/base/printable.h>
#include <foredraw/report/figure_rows.h>

#include <fmt/format.h>

#include <cmath>

namespace foredraw {

namespace {

/// Quoted where it has to be.
std::string field(const std::string& name) {
  const std::string text = printable(name);
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + '"';
}

std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

/// The lines of one file, or of all as one.
class Lines {
 public:
  explicit Lines(const Comparison& comparison) : comparison_(comparison) {}

  void add_all() {
    add_figures(",", total_rows(comparison_));
    for (std::size_t draw = 0; draw < draw_count(comparison_); ++draw) {
      add_figures(fmt::format("{},{}", draw, field(draw_name(comparison_, draw))), draw_rows(comparison_, draw));
    }
    for (std::size_t i = 0; i < comparison_.branches.size(); ++i) {
      if (!comparison_.branches[i].is_lost) add_times(i);
    }
  }

  const std::string& text() const { return text_; }

 private:
  void add(const std::string& branch, const std::string& draw, const std::string& what, const std::string& value,
           const std::string& unit, const std::string& error) {
    text_ += fmt::format("{},{},{},{},{},{},{}\r\n", field(comparison_.input.path), branch, draw, what, value,
                         field(unit), error);
  }

  std::string named(std::size_t branch) const {
    return fmt::format("[{}],{}", branch + 1, field(comparison_.branches[branch].name));
  }

  void add_figures(const std::string& draw, const std::vector<FigureRow>& rows) {
    for (const FigureRow& row : rows) {
      const auto add_one = [&](const std::string& branch, const Figure* figure) {
        if (figure == nullptr) return;
        add(branch, draw, field(row.evaluator) + ',' + field(row.metric), number(figure->value()), figure->unit,
            number(figure->error));
      };
      add_one("input,", row.input);
      for (std::size_t i = 0; i < row.branches.size(); ++i) add_one(named(i), row.branches[i]);
    }
  }

  void add_times(std::size_t branch) {
    const Report& report = comparison_.branches[branch].report;
    add(named(branch), ",", "time,all stages", number(stages_seconds(report)), "s", "");
    for (const StageRecord& stage : report.stages) {
      add(named(branch), ",", "time," + field(stage.use), number(stage.seconds), "s", "");
      if (stage.memory)
        add(named(branch), ",", "memory," + field(stage.use), std::to_string(*stage.memory), "bytes", "");
    }
  }

  const Comparison& comparison_;
  std::string text_;
};

}  // namespace

std::string to_csv(const std::vector<Comparison>& comparisons) {
  std::string text = "file,branch,pipeline,draw,name,evaluator,metric,value,unit,error\r\n";
  const auto add = [&](const Comparison& comparison) {
    Lines lines(comparison);
    lines.add_all();
    text += lines.text();
  };
  for (const Comparison& comparison : comparisons) add(comparison);
  if (const auto sum = sum_of(comparisons)) add(*sum);
  return text;
}

}  // namespace foredraw
