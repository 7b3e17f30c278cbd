#pragma once
// A context of the library for C whose memory runs out when it is told to.

#include <foredraw/c/foredraw.h>

#include "counted_memory.h"

#include <gtest/gtest.h>

#include <functional>

namespace foredraw::testing {

/// On one thread: counting is not for several.
class WithoutMemory : public ::testing::Test {
 protected:
  WithoutMemory() {
    foredraw_settings settings{};
    settings.size = sizeof settings;
    settings.threads = 1;
    context_ = foredraw_context_new(&settings);
  }
  ~WithoutMemory() override { foredraw_context_free(context_); }

  /// Calls it with ever more allocations that succeed, until it is done: each of the first 500 fails once, as do later
  /// ones here and there up to `most`; and once with all.
  static void expect_survives(const std::function<int()>& call, long most = 500) {
    EXPECT_EQ(call(), FOREDRAW_DONE);  // what is kept for ever is made now
    int failed = 0;
    for (long allowed = 0; allowed < most; allowed += allowed < 500 ? 1 : allowed / 40) {
      const long before = held;
      left = allowed;
      const int status = call();
      left = -1;
      ASSERT_EQ(held, before) << allowed;
      if (status == FOREDRAW_DONE) break;
      ASSERT_TRUE(status == FOREDRAW_NO_MEMORY || status == FOREDRAW_FAILED) << status << " after " << allowed;
      ++failed;
    }
    EXPECT_GT(failed, 0);
    EXPECT_EQ(call(), FOREDRAW_DONE);
  }

  foredraw_context* context_ = nullptr;
};

}  // namespace foredraw::testing
