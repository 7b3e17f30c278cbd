#include <foredraw/base/counted.h>
#include <foredraw/base/printable.h>
#include <foredraw/report/report.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

std::string change_text(const Figure* before, const Figure& after) {
  if (after.is_neutral || before == nullptr || before->value() == 0 || !std::isfinite(before->value()) ||
      !std::isfinite(after.value())) {
    return "";
  }
  const double change = 100 * (after.value() / before->value() - 1);
  const bool is_exact_count = !after.denominator && after.error == 0 && before->error == 0;
  if (is_exact_count && change != 0 && std::abs(change) < 0.05) {
    return fmt::format("{:+.0f}", after.value() - before->value());  // two are not the same that differ by one
  }
  return std::abs(change) < 0.05 ? "same" : fmt::format("{:+.1f} %", change);
}

std::string time_text(double seconds) {
  return seconds < 1 ? fmt::format("{:.1f} ms", seconds * 1000) : fmt::format("{:.2f} s", seconds);
}

std::string file_text(const FileRecord& file) {
  const std::string path = printable(file.path);
  return file.bytes == 0 ? path : fmt::format("{} ({} bytes)", path, counted(file.bytes));
}

std::string changed_count(std::string_view one, std::string_view several, std::uint64_t before, std::uint64_t after) {
  const std::string text = counted(after, one, several);
  return before == after ? text : fmt::format("{} (before: {})", text, counted(before));
}

/// A table with a row a metric; "models.…" are left to the JSON form.
std::string metrics_text(const Report& report) {
  Table table = report.optimized ? Table({"", "metric", "before", "after", "change", "unit"})
                                 : Table({"", "metric", "value", "unit"});
  for (const auto& [plugin, by_metric] : report.after.metrics.all()) {
    std::string shown = plugin;
    for (const auto& [metric, figure] : by_metric) {
      if (metric.find('.') != std::string::npos) continue;
      const Figure* before = report.before.metrics.find(plugin, metric);
      if (report.optimized) {
        table.add({shown, metric, before == nullptr ? "-" : to_text(*before), to_text(figure),
                   change_text(before, figure), figure.unit});
      } else {
        table.add({shown, metric, to_text(figure), figure.unit});
      }
      shown.clear();
    }
  }
  return table.empty() ? "" : '\n' + table.text();
}

/// A row for each coarser level of detail, of all draws that have it: what it draws, and figures without a dot.
std::string levels_text(const Report& report) {
  std::vector<StateRecord> levels;
  for (const DrawRecord& draw : report.draws) {
    levels.resize(std::max(levels.size(), draw.levels.size()));
    for (std::size_t i = 0; i < draw.levels.size(); ++i) levels[i].add(draw.levels[i].after);
  }
  std::string text;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    text += fmt::format("{}level {}: {}, {}", i == 0 ? "\n" : "", i + 1, counted(levels[i].triangles, "triangle"),
                        counted(levels[i].vertices, "vertex", "vertices"));
    for (const auto& [plugin, by_metric] : levels[i].metrics.all()) {
      for (const auto& [metric, figure] : by_metric) {
        if (metric.find('.') == std::string::npos) text += fmt::format(", {} {} {}", plugin, metric, to_text(figure));
      }
    }
    text += '\n';
  }
  return text;
}

/// Whether a figure is worse for whoever draws the scene. A ratio is of work to something: misses to vertices,
/// fragments to pixels. Where the work itself has become less, the ratio rises only because there is less of the other
/// (weld leaves fewer vertices to shade and fetch), and nothing was lost. That is not to be said of a ratio of which
/// the worst stands: before and after it may be of two different places.
bool is_loss(const Figure& before, const Figure& after) {
  const double sign = after.lower_is_better ? 1 : -1;
  const double loss = sign * (after.value() - before.value());
  const bool is_less_work = sign * (after.numerator - before.numerator) < 0 && !after.worst_stands;
  return loss > 0.0005 * std::abs(before.value()) && loss > after.error && !is_less_work;
}

/// One figure may be traded for another; who reads the table in a hurry shall not miss it.
std::string losses_text(const Report& report) {
  std::string losses;
  for (const auto& [plugin, by_metric] : report.after.metrics.all()) {
    for (const auto& [metric, figure] : by_metric) {
      const Figure* before = report.before.metrics.find(plugin, metric);
      if (before == nullptr || !figure.denominator || metric.find('.') != std::string::npos) continue;
      if (!is_loss(*before, figure)) continue;
      const std::string change = change_text(before, figure);
      if (change.empty()) continue;  // an error against what was there before is 0 before, and meant to grow
      losses += fmt::format("{}{} {} ({})", losses.empty() ? "" : ", ", plugin, metric, change);
    }
  }
  if (losses.empty()) return "";
  return fmt::format("\nworse than before: {}. To see which stage causes it, compare pipelines with fewer stages.\n",
                     losses);
}

std::string places_text(const std::vector<std::string>& places) {
  constexpr std::size_t shown = 4;
  std::string text;
  for (std::size_t i = 0; i < places.size() && i < shown; ++i) {
    if (i > 0) text += ", ";
    text += places[i].empty() ? "the scene" : printable(places[i]);
  }
  if (places.size() > shown) text += fmt::format(" and {} more", places.size() - shown);
  return text;
}

std::string skip_text(const StageRecord& stage, const SkipRecord& skip) {
  const std::string places = places_text(skip.about);
  return fmt::format("  {} left {} alone: {}\n", stage.use, places.empty() ? "all" : places, skip.reason);
}

/// Reasons with figures in them differ from draw to draw: of each kind the first few, and how many more there are.
std::string skips_text(const StageRecord& stage) {
  constexpr std::size_t shown = 3;
  std::map<std::string, std::size_t> of_code;
  std::string text;
  for (const SkipRecord& skip : stage.skipped) {
    if (++of_code[skip.code] <= shown) text += skip_text(stage, skip);
  }
  for (const auto& [code, count] : of_code) {
    if (count > shown)
      text +=
          fmt::format("  {} left {} more alone ({}); --json lists them all\n", stage.use, counted(count - shown), code);
  }
  return text;
}

/// Notes that say the same of several places are one line.
std::string notes_text(const StageRecord& stage) {
  struct Said {
    const NoteRecord* first;
    std::vector<std::string> about;
  };
  std::vector<Said> all;
  using Words = std::pair<std::string_view, std::string_view>;
  std::map<Words, std::size_t> numbers;
  for (const NoteRecord& note : stage.notes) {
    const auto [at, is_new] = numbers.emplace(Words(note.code, note.message), all.size());
    if (is_new) all.push_back({&note, {}});
    all[at->second].about.push_back(note.about);
  }
  std::string text;
  for (const auto& [note, about] : all) {
    const bool is_of_scene = about.size() == 1 && about.front().empty();
    text += fmt::format("  {}{}{}: {}\n", stage.use, is_of_scene ? "" : " on ", is_of_scene ? "" : places_text(about),
                        printable(note->message));
  }
  return text;
}

std::string stage_text(const StageRecord& stage) { return skips_text(stage) + notes_text(stage); }

std::string stages_text(const Report& report) {
  if (report.stages.empty()) return "";
  Table table({"stage", "changed", "time"});
  for (const StageRecord& stage : report.stages) {
    table.add({stage.text, changed_text(stage), time_text(stage.seconds)});
  }
  std::string text = '\n' + table.text();
  for (const StageRecord& stage : report.stages) text += stage_text(stage);
  return text;
}

/// What was odd about the input, summed over the draws.
std::string facts_text(const Report& report) {
  std::vector<std::pair<std::string_view, std::size_t>> sums = named_counts({});
  for (const DrawRecord& draw : report.draws) {
    const auto counts = named_counts(draw.facts);
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i].second += counts[i].second;
  }
  std::string text;
  for (const auto& [name, count] : sums) {
    if (count > 0)
      text += fmt::format("{}{} {}", text.empty() ? "\nunusual in the input, and kept: " : ", ", name, counted(count));
  }
  return text.empty() ? text : text + '\n';
}

}  // namespace

std::string changed_text(const StageRecord& stage) {
  if (stage.loops_over == "scene") return stage.changed > 0 ? "the scene" : "nothing";
  return fmt::format("{} of {} {}", stage.changed, stage.candidates, stage.loops_over);
}

std::string to_text(const Report& report) {
  std::string text = file_text(report.input);
  if (!report.output.path.empty()) text += " -> " + file_text(report.output);
  for (const FileRecord& file : report.named) text += "\nbeside " + file_text(file);
  text += '\n' + fmt::format("{}, {}, {}\n", counted(report.draws.size(), "draw"),
                             changed_count("triangle", "triangles",
                                           report.optimized ? report.before.triangles : report.after.triangles,
                                           report.after.triangles),
                             changed_count("vertex", "vertices",
                                           report.optimized ? report.before.vertices : report.after.vertices,
                                           report.after.vertices));
  text += metrics_text(report);
  text += levels_text(report);
  if (report.optimized) text += losses_text(report);
  text += stages_text(report);
  for (const StageRecord& measure : report.measures) text += stage_text(measure);
  text += facts_text(report);
  return text;
}

}  // namespace foredraw
