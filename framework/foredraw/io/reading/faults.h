#pragma once
// What is wrong in a file and yet can be read in one way only, or is not used: it is kept or mended, with a warning.
// docs/reference/real-files.md holds this table.

#include <foredraw/base/diagnostics.h>

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace foredraw {

struct FaultKind {
  std::string_view code;   ///< of the warning: "buffer-length"
  std::string_view files;  ///< the kinds of files: "glTF", "PLY"
  std::string_view what;   ///< what is wrong, as the table says it
  std::string_view done;   ///< what becomes of it: the hint of the warning
  std::string_view why;    ///< why that is safe
};

/// Every kind, in the sequence of the table.
std::span<const FaultKind> fault_kinds();

/// The kind with this code; it must be in the table.
const FaultKind& fault_kind(std::string_view code);

/// The faults of one file as its reader finds them. Of a kind only the first is told, with the number of them.
class Faults {
 public:
  /// Strict: each kind is an error.
  Faults(Diagnostics& diagnostics, bool strict) : diagnostics_(diagnostics), strict_(strict) {}

  void found(std::string_view code, Where where, std::string message);

  /// Counts one more of a kind that was found before. False: it is the first, and found() has to say where.
  bool found_again(std::string_view code);

  /// Puts them among the diagnostics. False where the file is refused for them.
  bool tell();

 private:
  Diagnostics& diagnostics_;
  bool strict_;
  std::map<std::string_view, Diagnostic> first_;  ///< by code, with the number of its places
};

}  // namespace foredraw
