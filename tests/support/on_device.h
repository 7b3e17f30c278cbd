#pragma once
#include <foredraw/gpu/choice.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace foredraw::testing {

/// On whatever Vulkan device there is, under the eyes of the validation layer where that is installed: it must not
/// complain.
class OnDevice : public ::testing::Test {
 protected:
  /// `name`: part of the device's.
  explicit OnDevice(std::string name = "") : choice_{std::move(name), gpu::has_validation() ? &complaints_ : nullptr} {}

  void SetUp() override {
    if (const auto reason = gpu::why_no_device(choice_)) GTEST_SKIP() << *reason;
  }
  /// Devices have to be gone by then: what is not given back is complained of too.
  void TearDown() override {
    for (const std::string& complaint : complaints_) ADD_FAILURE() << complaint;
  }

  const gpu::DeviceChoice& choice() const { return choice_; }

 private:
  std::vector<std::string> complaints_;
  gpu::DeviceChoice choice_;
};

}  // namespace foredraw::testing
