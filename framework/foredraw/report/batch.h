#pragma once
// Many files, each worked on by itself: a line for every file, and their sum.

#include <foredraw/report/report.h>

namespace foredraw {

enum class Outcome {
  done,
  in_part,  ///< a stage failed somewhere, and left what it found
  lost,     ///< the file could not be read, planned for or written: the report's diagnostics say why
};

struct BatchFile {
  Report report;
  Outcome outcome = Outcome::done;
};

struct Batch {
  std::string command;
  std::vector<BatchFile> files;
  double seconds = 0;
};

/// The sum over the files that were not lost, before or after.
StateRecord totals(const Batch& batch, StateRecord Report::*state);

/// The JSON form: the totals, and each file's whole report.
std::string to_json(const Batch& batch);

/// A table with a row a file: of each evaluator its first ratio, and the bytes, before and after.
std::string to_text(const Batch& batch);

}  // namespace foredraw
