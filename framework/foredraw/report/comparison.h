#pragma once
// Several pipelines on the same scene, side by side.

#include <foredraw/report/report.h>

namespace foredraw {

struct Branch {
  std::string name;  ///< the pipeline as it was named or written
  Report report;
};

/// All branches on one file, in the sequence in which they were given.
struct Comparison {
  FileRecord input;
  std::vector<Branch> branches;
};

/// Of all its stages, without measuring.
double stages_seconds(const Report& report);

/// The JSON form: for each file and branch the whole report, and a table of every total metric over the branches.
std::string to_json(const std::vector<Comparison>& comparisons);

/// A table for each file: a row a metric, a column a branch, the best of a row marked; below it the stages' times.
std::string to_text(const std::vector<Comparison>& comparisons);

}  // namespace foredraw
