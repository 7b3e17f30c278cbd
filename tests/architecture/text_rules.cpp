#include "text_rules.h"

#include <regex>
#include <sstream>

namespace foredraw::architecture {

namespace {

struct Forbidden {
  std::regex pattern;
  const char* reason;
};

/// The words are cut in two here, or this file would break its own rule.
const std::vector<Forbidden>& forbidden() {
  static const std::vector<Forbidden> rows = {
      {std::regex("\\b(TO"
                  "DO|FIX"
                  "ME|XX"
                  "X)\\b"),
       "a note of unfinished work; finish it or write it down elsewhere"},
      {std::regex("(^|[^A-Za-z0-9_.}*-])/(ho"
                  "me|wo"
                  "rk|tm"
                  "p|ro"
                  "ot|Use"
                  "rs)/"),
       "an absolute path of one machine"},
      {std::regex("\\.\\./sha"
                  "red"),
       "a path outside the project"},
  };
  return rows;
}

}  // namespace

Breaches text_breaches(const std::string& path, const std::string& text) {
  Breaches breaches;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    for (const Forbidden& row : forbidden()) {
      std::smatch match;
      if (std::regex_search(line, match, row.pattern)) {
        breaches.push_back(path + ':' + std::to_string(number) + ": '" + match.str() + "': " + row.reason);
      }
    }
  }
  return breaches;
}

}  // namespace foredraw::architecture
