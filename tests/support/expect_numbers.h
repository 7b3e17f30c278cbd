#pragma once
// What a run of the program shows.

#include "support/program.h"

#include <regex>
#include <string>

namespace foredraw::testing {

/// Ended well, and shows no figure that is no number.
inline void expect_numbers(const Ended& ended, const std::string& command) {
  static const std::regex none(R"((^|[^a-z-])-?(nan|inf)($|[^a-z-]))");
  EXPECT_EQ(ended.code, 0) << command << '\n' << ended.err;
  for (const std::string* text : {&ended.out, &ended.err}) {
    std::smatch found;
    if (!std::regex_search(*text, found, none)) continue;
    const auto at = static_cast<std::size_t>(found.position());
    ADD_FAILURE() << command << ": " << text->substr(at > 200 ? at - 200 : 0, 240);
  }
}

}  // namespace foredraw::testing
