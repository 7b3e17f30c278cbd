#include <foredraw/report/since.h>

#include <foredraw/base/counted.h>
#include <foredraw/report/figure_rows.h>
#include <foredraw/report/private/json_values.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

constexpr std::size_t most_rows = 20;  // of a table for people; the JSON form has all

/// The same figure as it was: of the same views, so that its error was about the same.
Figure figure_that_was(const Figure& now, double value) {
  Figure was = now;
  was.numerator = value;
  if (was.denominator) was.denominator = 1;
  return was;
}

/// By how much it is worse; nothing where that can not be said, or it is the same.
std::optional<double> worsening(const Figure& now, const Figure& was) {
  if (was.value() == 0 && now.value() != 0 && !now.is_neutral && std::isfinite(now.value())) {
    const bool is_worse = (now.value() > 0) == now.lower_is_better;
    return is_worse ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
  }
  const std::string text = difference_text(&now, &was);
  if (text.empty() || text == "~" || text == "same") return std::nullopt;
  const double change = difference(&now, &was)->change;
  return now.lower_is_better ? change : -change;
}

/// "1 figure of 1 file is worse", "none is better".
std::string told(const std::vector<Since::Change>& changes, bool worse) {
  std::set<std::string> files;
  std::size_t figures = 0;
  for (const Since::Change& change : changes) {
    if ((change.worse > 0) != worse) continue;
    files.insert(change.file);
    ++figures;
  }
  const char* word = worse ? "worse" : "better";
  if (figures == 0) return fmt::format("none is {}", word);
  return fmt::format("{} of {} {} {}", counted(figures, "figure"), counted(files.size(), "file"),
                     figures == 1 ? "is" : "are", word);
}

std::string files_text(const std::vector<std::string>& files, std::string_view what) {
  if (files.empty()) return "";
  std::string text = fmt::format("{} {}:\n", counted(files.size(), "file"), what);
  for (std::size_t i = 0; i < std::min(files.size(), most_rows); ++i) text += "  " + files[i] + '\n';
  if (files.size() > most_rows) text += fmt::format("  and {} more\n", counted(files.size() - most_rows));
  return text;
}

}  // namespace

void Since::add(const std::string& file, const Metrics& after) {
  const auto* was = baseline_.find(file);
  if (was == nullptr) return new_.push_back(file);
  seen_.insert(was->first);
  const std::size_t before = changes_.size();
  for (const auto& [evaluator, by_metric] : after.all()) {
    for (const auto& [metric, now] : by_metric) {
      const auto stored = was->second.find(evaluator + '.' + metric);
      if (metric.find('.') != std::string::npos || stored == was->second.end()) continue;
      const Figure old = figure_that_was(now, stored->second);
      const auto worse = worsening(now, old);
      if (!worse) continue;
      changes_.push_back({file, evaluator + ' ' + metric, foredraw::to_text(old), foredraw::to_text(now),
                          difference_text(&now, &old), *worse});
    }
  }
  same_ += changes_.size() == before ? 1 : 0;
}

void Since::add_lost(const std::string& file) {
  const auto* was = baseline_.find(file);
  if (was == nullptr) return;  // it was lost before, or is new: it is told of elsewhere
  seen_.insert(was->first);
  lost_.push_back(file);
}

void Since::add(const StoredReport& report, Outcome outcome) {
  outcome == Outcome::lost ? add_lost(report.input.path) : add(report.input.path, report.after.metrics);
}

std::vector<Since::Change> Since::changes() const {
  std::vector<Change> sorted = changes_;
  std::ranges::stable_sort(sorted, [](const Change& a, const Change& b) { return a.worse > b.worse; });
  return sorted;
}

std::vector<std::string> Since::gone() const {
  std::vector<std::string> gone;
  if (is_part_) return gone;  // it is in another part
  for (const auto& [file, figures] : baseline_.files()) {
    if (!seen_.contains(file)) gone.push_back(file);
  }
  return gone;
}

std::string Since::to_text() const {
  const std::vector<Change> sorted = changes();
  std::string text = fmt::format("since {}: {}, {}; {} the same\n", name_, told(sorted, true), told(sorted, false),
                                 same_ == 1 ? "1 file is" : counted(same_, "file") + " are");
  text += files_text(lost_, "failed that did not fail before") + files_text(new_, "new") + files_text(gone(), "gone");
  Table table({"worse", "figure", "was", "is", "change"});
  std::size_t worse = 0;
  for (const Change& change : sorted) {
    if (change.worse <= 0 || ++worse > most_rows) continue;
    table.add({change.file, change.figure, change.was, change.now, change.change});
  }
  if (worse == 0) return text;
  text += '\n' + table.text();
  if (worse > most_rows) text += fmt::format("and {} more, which the JSON form has\n", counted(worse - most_rows));
  return text;
}

std::string Since::to_json() const {
  Json changed = Json::array();
  for (const Change& change : changes()) {
    changed.push_back({{"file", change.file},
                       {"figure", change.figure},
                       {"was", change.was},
                       {"is", change.now},
                       {"change", change.change},
                       {"worse", change.worse > 0}});
  }
  const Json json{{"baseline", name_}, {"changed", changed}, {"same", same_},
                  {"failed", lost_},   {"new", new_},        {"gone", gone()}};
  return indented_text(json);
}

}  // namespace foredraw
