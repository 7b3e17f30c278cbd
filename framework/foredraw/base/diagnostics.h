#pragma once
// What a user is told: collected, never thrown, so that one look shows every mistake.

#include <string>
#include <string_view>
#include <vector>

namespace foredraw {

enum class Severity { note, warning, error };

/// A place in what the user gave: a file with line and column (1-based; 0: unknown), and the place inside it in the
/// file's own words, such as "accessors[3].count" or "stages[1]".
struct Where {
  std::string file;
  int line = 0;
  int column = 0;
  std::string inside;
};

struct Diagnostic {
  Severity severity = Severity::error;
  Where where;
  std::string code;        ///< stable, for programs: "unknown-option"
  std::string message;     ///< what was found and what was expected
  std::string hint;        ///< what to do about it; may be empty
  std::size_t places = 1;  ///< that are like this one, the first
};

class Diagnostics {
 public:
  void add(Diagnostic diagnostic);
  void error(Where where, std::string code, std::string message, std::string hint = {});
  void warning(Where where, std::string code, std::string message, std::string hint = {});
  void note(Where where, std::string code, std::string message, std::string hint = {});

  bool has_errors() const;
  bool empty() const { return all_.empty(); }
  const std::vector<Diagnostic>& all() const { return all_; }

 private:
  std::vector<Diagnostic> all_;
};

/// "file:5:23: error: stages[1]: message", the hint on a line of its own.
std::string to_text(const Diagnostic& diagnostic);
std::string to_text(const Diagnostics& diagnostics);
std::string_view to_text(Severity severity);

/// The candidate nearest to `word` by edit distance, or nothing where none is near enough to be what was meant.
std::string_view nearest(std::string_view word, const std::vector<std::string>& candidates);
std::string_view nearest(std::string_view word, const std::vector<std::string>&& candidates) = delete;  // would dangle

}  // namespace foredraw
