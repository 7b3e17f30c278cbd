#pragma once
// What the program says when something is odd: lines for those who use it, and nothing of its insides.

#include "support/program.h"

#include <string>
#include <string_view>

namespace foredraw::testing {

inline void expect_plain_messages(const Ended& ended, const std::string& what) {
  for (const std::string_view inside :
       {"std::", "exception", "ssertion", "terminate", "bad_alloc", "vector", "basic_string", "segfault", "Sanitizer",
        "runtime error", "failed: stage", "internal"}) {
    EXPECT_EQ(ended.err.find(inside), std::string::npos) << what << " says " << inside << ":\n"
                                                         << ended.err.substr(0, 4000);
    EXPECT_EQ(ended.out.find(inside), std::string::npos) << what << " says " << inside << ":\n"
                                                         << ended.out.substr(0, 4000);
  }
}

}  // namespace foredraw::testing
