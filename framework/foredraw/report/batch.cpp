#include <foredraw/report/batch.h>

#include <foredraw/base/counted.h>
#include <foredraw/report/private/json_values.h>
#include <foredraw/report/table.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

struct Column {
  std::string evaluator, metric;
};

/// Of each evaluator the first metric that is a ratio of sums.
std::vector<Column> columns_of(const Metrics& metrics) {
  std::vector<Column> columns;
  for (const auto& [evaluator, by_metric] : metrics.all()) {
    const auto first = std::ranges::find_if(by_metric, [](const auto& entry) {
      return entry.second.denominator && !entry.second.worst_stands && entry.first.find('.') == std::string::npos;
    });
    if (first != by_metric.end()) columns.push_back({evaluator, first->first});
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

bool is_optimized(const Batch& batch) {
  return std::ranges::any_of(batch.files, [](const BatchFile& file) { return file.report.optimized; });
}

std::string_view word_of(Outcome outcome) {
  switch (outcome) {
    case Outcome::done: return "done";
    case Outcome::in_part: return "in-part";
    case Outcome::lost: return "lost";
  }
  return "";
}

std::string_view told(Outcome outcome) {
  return outcome == Outcome::in_part ? "in part: a stage failed"
         : outcome == Outcome::lost  ? "failed: see above"
                                     : "done";
}

}  // namespace

StateRecord totals(const Batch& batch, StateRecord Report::*state) {
  StateRecord sum;
  for (const BatchFile& file : batch.files) {
    if (file.outcome == Outcome::lost) continue;
    sum.add(file.report.*state);
  }
  return sum;
}

std::string to_json(const Batch& batch) {
  Report sum;
  sum.optimized = is_optimized(batch);
  sum.before = totals(batch, &Report::before);
  sum.after = totals(batch, &Report::after);
  Json json{{"batch", 1}, {"command", batch.command}, {"seconds", batch.seconds}};
  json["totals"] = Json::parse(to_json(sum))["totals"];
  json["files"] = Json::array();
  for (const BatchFile& file : batch.files) {
    json["files"].push_back({{"outcome", word_of(file.outcome)}, {"report", Json::parse(to_json(file.report))}});
  }
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string to_text(const Batch& batch) {
  const StateRecord before = totals(batch, &Report::before);
  const StateRecord after = totals(batch, &Report::after);
  const std::vector<Column> columns = columns_of(after.metrics);
  std::vector<std::string> heads{"file"};
  for (const Column& column : columns) heads.push_back(column.evaluator + ' ' + column.metric);
  heads.insert(heads.end(), {"bytes", "outcome"});
  Table table(heads);
  const auto add = [&](const std::string& name, const StateRecord& old, const StateRecord& now,
                       const std::string& bytes, std::string_view outcome) {
    std::vector<std::string> row{name};
    for (const Column& column : columns) {
      const std::string was = cell(old.metrics.find(column.evaluator, column.metric));
      row.push_back(change(is_optimized(batch) ? was : "", cell(now.metrics.find(column.evaluator, column.metric))));
    }
    row.push_back(bytes);
    row.emplace_back(outcome);
    table.add(row);
  };

  FileRecord read, written;
  bool are_alike = true;
  std::size_t lost = 0;
  for (const auto& [report, outcome] : batch.files) {
    if (outcome == Outcome::lost) {
      ++lost;
      std::vector<std::string> row(heads.size());
      row.front() = report.input.path;
      row.back() = told(outcome);
      table.add(row);
      continue;
    }
    const std::string bytes = bytes_text(report.input, report.output);
    add(report.input.path, report.before, report.after, bytes, told(outcome));
    are_alike = are_alike && !bytes.empty();
    read.bytes += report.input.bytes;
    written.bytes += report.output.bytes;
  }
  add("all", before, after, are_alike ? bytes_text(read, written) : "",
      lost == 0 ? "" : fmt::format("without {}", counted(lost, "failed file")));
  return fmt::format("{}\n{} in {:.2f} s\n", table.text(), counted(batch.files.size(), "file"), batch.seconds);
}

}  // namespace foredraw
