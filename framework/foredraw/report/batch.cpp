#include <foredraw/report/batch.h>

#include <foredraw/base/counted.h>
#include <foredraw/report/private/json_values.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::size_t at_once = std::size_t{1} << 16;

bool is_a_ratio(const std::string& metric, const Figure& figure) {
  return figure.denominator && !figure.worst_stands && metric.find('.') == std::string::npos;
}

/// Of each evaluator the first metric that is a ratio of sums.
std::vector<std::pair<std::string, std::string>> columns_of(const Metrics& metrics) {
  std::vector<std::pair<std::string, std::string>> columns;
  for (const auto& [evaluator, by_metric] : metrics.all()) {
    const auto first =
        std::ranges::find_if(by_metric, [](const auto& entry) { return is_a_ratio(entry.first, entry.second); });
    if (first != by_metric.end()) columns.emplace_back(evaluator, first->first);
  }
  return columns;
}

std::string change(const std::string& before, const std::string& after) {
  return before.empty() || before == "-" || before == after ? after : before + " -> " + after;
}

/// Of files of one kind alone: an image and the list of its frames are not to be compared.
std::string bytes_text(const FileRecord& read, const FileRecord& written) {
  const auto kind_of = [](const FileRecord& file) {
    const std::string kind = std::filesystem::path(file.path).extension().string();
    return kind == ".gltf" ? ".glb" : kind;
  };
  if (written.bytes == 0) return counted(read.bytes);
  return kind_of(read) == kind_of(written) ? change(counted(read.bytes), counted(written.bytes)) : "";
}

/// Without errors, for a table of many files.
std::string cell(const Figure* figure) {
  if (figure == nullptr) return "-";
  Figure exact = *figure;
  exact.error = 0;
  return to_text(exact);
}

std::string_view told(Outcome outcome) {
  return outcome == Outcome::in_part ? "in part: a stage failed"
         : outcome == Outcome::lost  ? "failed: see above"
                                     : "done";
}

}  // namespace

std::string_view to_text(Outcome outcome) {
  switch (outcome) {
    case Outcome::done: return "done";
    case Outcome::in_part: return "in-part";
    case Outcome::lost: return "lost";
  }
  return "";
}

std::optional<Outcome> outcome_called(std::string_view word) {
  for (const Outcome outcome : {Outcome::done, Outcome::in_part, Outcome::lost}) {
    if (word == to_text(outcome)) return outcome;
  }
  return std::nullopt;
}

Batch::Batch(std::string command, const Registry& registry, Spool& spool, Told told)
    : command_(std::move(command)), registry_(registry), spool_(spool), told_(std::move(told)) {}

void Batch::add(std::size_t number, std::string_view report, Outcome outcome, bool from_cache) {
  const Added added{spool_.put(report), outcome, from_cache};
  std::unique_lock lock(mutex_);
  waiting_.emplace(number, added);
  if (is_taking_) return;  // who is at it takes this one too
  is_taking_ = true;
  while (!waiting_.empty() && waiting_.begin()->first == next_) {
    const Added first = waiting_.extract(waiting_.begin()).mapped();
    lock.unlock();
    take(first);
    lock.lock();
    ++next_;
  }
  is_taking_ = false;
}

void Batch::take(const Added& added) {
  const StoredReport report = stored_report(spool_.get(added.place), registry_);
  if (added.outcome != Outcome::lost) {
    optimized_ = optimized_ || report.optimized;
    before_.add(report.before);
    after_.add(report.after);
  }
  from_cache_ += added.from_cache ? 1 : 0;
  rows_.push_back(row_of(report, added.outcome));
  added_.push_back(added);
  if (told_) told_(report, added.outcome);
}

bool Batch::is_done() const {
  return std::ranges::all_of(added_, [](const Added& file) { return file.outcome == Outcome::done; });
}

std::size_t Batch::column(const std::string& evaluator, const std::string& metric) {
  return columns_.emplace(std::pair(evaluator, metric), columns_.size()).first->second;
}

Batch::Row Batch::row_of(const StoredReport& report, Outcome outcome) {
  Row row{report.input.path, {}, "", report.input.bytes, report.output.bytes, outcome};
  if (outcome == Outcome::lost) return row;
  row.bytes = bytes_text(report.input, report.output);
  for (const auto& [evaluator, by_metric] : report.after.metrics.all()) {
    for (const auto& [metric, figure] : by_metric) {
      if (!is_a_ratio(metric, figure)) continue;
      const std::string was = report.optimized ? cell(report.before.metrics.find(evaluator, metric)) : "";
      row.cells.emplace_back(column(evaluator, metric), change(was, cell(&figure)));
    }
  }
  return row;
}

void Batch::write_json(double seconds, const std::optional<Shard>& shard,
                       const std::function<void(std::string_view)>& write, const std::string& since) const {
  std::string waiting;  // whoever writes may ask the system for each piece
  const auto put = [&](std::string_view text) {
    waiting += text;
    if (waiting.size() < at_once) return;
    write(waiting);
    waiting.clear();
  };
  Report sum;
  sum.optimized = optimized_;
  sum.before = before_;
  sum.after = after_;
  Json head{{"batch", 1}, {"command", command_}};
  if (shard) head["shard"] = {{"number", shard->number}, {"of", shard->of}};
  head["seconds"] = seconds;
  head["totals"] = Json::parse(to_json(sum))["totals"];
  if (!since.empty()) head["since"] = Json::parse(since);
  std::string text = indented_text(head);
  text.erase(text.rfind('\n'));
  put(text);
  put(rows_.empty() ? ",\n  \"files\": []" : ",\n  \"files\": [");
  for (std::size_t i = 0; i < added_.size(); ++i) {
    put(i == 0 ? "\n    {\n" : ",\n    {\n");
    put(fmt::format("      \"outcome\": \"{}\",\n", foredraw::to_text(added_[i].outcome)));
    if (added_[i].from_cache) put("      \"cached\": true,\n");
    put("      \"report\": ");
    put_indented(spool_.get(added_[i].place), "      ", put);
    put("\n    }");
  }
  put(rows_.empty() ? "\n}\n" : "\n  ]\n}\n");
  write(waiting);
}

std::string Batch::to_text(double seconds) const {
  const auto columns = columns_of(after_.metrics);
  std::vector<std::string> heads{"file"};
  for (const auto& [evaluator, metric] : columns) heads.push_back(evaluator + ' ' + metric);
  heads.insert(heads.end(), {"bytes", "outcome"});
  Table table(heads);
  std::uint64_t read = 0, written = 0;
  bool are_alike = true;
  std::size_t lost = 0;
  for (const Row& row : rows_) {
    std::vector<std::string> cells{row.path};
    if (row.outcome == Outcome::lost) {
      ++lost;
      cells.resize(heads.size());
      cells.back() = told(row.outcome);
      table.add(cells);
      continue;
    }
    for (const auto& column : columns) {
      const auto at = std::ranges::find(row.cells, columns_.at(column), [](const auto& one) { return one.first; });
      cells.push_back(at == row.cells.end() ? "-" : at->second);
    }
    cells.push_back(row.bytes);
    cells.emplace_back(told(row.outcome));
    table.add(cells);
    are_alike = are_alike && !row.bytes.empty();
    read += row.read;
    written += row.written;
  }
  std::vector<std::string> all{"all"};
  for (const auto& [evaluator, metric] : columns) {
    const std::string was = optimized_ ? cell(before_.metrics.find(evaluator, metric)) : "";
    all.push_back(change(was, cell(after_.metrics.find(evaluator, metric))));
  }
  all.push_back(!are_alike ? "" : written == 0 ? counted(read) : change(counted(read), counted(written)));
  all.push_back(lost == 0 ? "" : fmt::format("without {}", counted(lost, "failed file")));
  table.add(all);
  const std::string cached = from_cache_ == 0 ? "" : fmt::format(", {} of them from the cache", counted(from_cache_));
  return fmt::format("{}\n{} in {:.2f} s{}\n", table.text(), counted(rows_.size(), "file"), seconds, cached);
}

}  // namespace foredraw
