#pragma once
// Figures of an earlier run, file by file: what a later one is held against.

#include <foredraw/base/diagnostics.h>

#include <map>
#include <optional>
#include <string>
#include <unordered_map>

namespace foredraw {

/// The totals of one file: by EVALUATOR.METRIC, or "time", the seconds of all stages.
using StoredFigures = std::map<std::string, double>;

class Baseline {
 public:
  using Files = std::map<std::string, StoredFigures>;

  /// By the paths of the inputs.
  explicit Baseline(Files files);
  Baseline(const Baseline&) = delete;
  Baseline& operator=(const Baseline&) = delete;
  Baseline(Baseline&&) = default;
  Baseline& operator=(Baseline&&) = default;

  /// The file of that path, however it is written, else the only one of that name; null where there is none.
  const Files::value_type* find(const std::string& path) const;
  const Files& files() const { return files_; }

 private:
  Files files_;
  std::unordered_map<std::string, const Files::value_type*> by_place_;
  std::unordered_map<std::string, const Files::value_type*> by_name_;  ///< null: of several
};

/// The figures of a stored report, of every file of a batch, or of the first pipeline of a comparison, by the input's
/// path. Nothing where the text is none of these, or of a later version; a diagnostic says why. `name`: of its file.
std::optional<Baseline> read_baseline(const std::string& text, const std::string& name, Diagnostics& diagnostics);

}  // namespace foredraw
