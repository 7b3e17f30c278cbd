#pragma once
// Several pipelines on the same scene, side by side.

#include <foredraw/report/report.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

struct Branch {
  std::string name;  ///< the pipeline as it was named or written
  Report report;
  bool is_lost = false;  ///< it could not be planned for the scene: the report holds the reasons alone
};

/// All branches on one file, in the sequence in which they were given.
struct Comparison {
  FileRecord input;
  std::vector<Branch> branches;
  std::vector<std::pair<std::string, std::string>> fronts;  ///< asked for: two figures as value_of() names them
  std::vector<Diagnostic> diagnostics;                      ///< of reading the file

  /// It could not be read: there are no branches.
  bool is_lost() const { return branches.empty(); }
};

/// Of all its stages, without measuring.
double stages_seconds(const Report& report);

/// Seconds of all its stages in each round; the one time that there is where there were none.
std::vector<double> rounds_of(const Report& report);

/// Of the totals after the branch: EVALUATOR.METRIC, or "time", the seconds of all stages. Nothing where it is none, or
/// no finite number.
std::optional<double> value_of(const Branch& branch, const std::string& figure);

/// The same of the input; it took no time.
std::optional<double> input_value(const Comparison& comparison, const std::string& figure);

/// All files as one, by branch: figures and times are summed over the files that could be read. A branch that one of
/// them lost is lost. Nothing where the files are fewer than two.
std::optional<Comparison> sum_of(std::span<const Comparison> comparisons);

/// The JSON form: for each file and branch the whole report, and a table of every total metric over the branches; the
/// same of all files as one. `since`: Since::to_json() of the first branches, or empty. `all`: in place of sum_of().
std::string to_json(std::span<const Comparison> comparisons, const std::string& since = {},
                    const Comparison* all = nullptr);

/// A table for each file: a row a metric, a column a branch, the best of a row marked; below it the stages' times.
/// Where the branches are many, a row a branch.
std::string to_text(const std::vector<Comparison>& comparisons);

/// Comma-separated values (RFC 4180), a line for every figure: of the totals, of each draw, and of each stage.
std::string to_csv(const std::vector<Comparison>& comparisons);

}  // namespace foredraw
