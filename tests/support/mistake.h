#pragma once
// Mistakes of users, for tests that go through many.

#include <string>

namespace foredraw::testing {

struct Mistake {
  const char* what;       ///< the test's name
  std::string arguments;  ///< as a shell has them
  int code;               ///< that the program exits with
  std::string says;       ///< part of what it tells
};

/// Calls a test by its mistake.
inline constexpr auto by_what = [](const auto& info) { return std::string(info.param.what); };

}  // namespace foredraw::testing
