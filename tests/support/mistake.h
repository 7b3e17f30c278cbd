#pragma once
// Mistakes of users, for tests that go through many.

#include "support/program.h"

#include <gtest/gtest.h>

#include <string>

namespace foredraw::testing {

struct Mistake {
  const char* what;       ///< the test's name
  std::string arguments;  ///< as a shell has them
  int code;               ///< that the program exits with
  std::string says;       ///< part of what it tells
};

/// Told as an error, with nothing on standard output.
inline void expect_told(const Mistake& mistake, const Ended& ended) {
  EXPECT_EQ(ended.code, mistake.code) << ended.err;
  EXPECT_NE(ended.err.find(mistake.says), std::string::npos) << ended.err;
  EXPECT_TRUE(ended.out.empty()) << ended.out;
}

/// Calls a test by its mistake.
inline constexpr auto by_what = [](const auto& info) { return std::string(info.param.what); };

}  // namespace foredraw::testing
