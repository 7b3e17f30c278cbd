#include <foredraw/gpu/device.h>

#include "support/on_device.h"

#include <gtest/gtest.h>

#include <array>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace foredraw::gpu::device_test {
namespace {

using GpuDevice = testing::OnDevice;

TEST_F(GpuDevice, is_called_by_a_part_of_its_name) {
  const std::string name = Device(choice()).name();
  std::string part = name.substr(0, 6);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_FALSE(why_no_device({.device = part}));
  EXPECT_NE(Device({.device = part}).name().find(name.substr(0, 6)), std::string::npos);
  const auto reason = why_no_device({.device = "abacus"});
  ASSERT_TRUE(reason);
  EXPECT_NE(reason->find("'abacus'"), std::string::npos) << *reason;
  EXPECT_NE(reason->find(name), std::string::npos) << *reason;
  EXPECT_THROW(Device({.device = "abacus"}), std::runtime_error);
}

TEST_F(GpuDevice, has_memory_that_the_processor_sees_and_none_that_no_type_is_allowed) {
  const Device device(choice());
  EXPECT_NO_THROW(device.allocated({64, 1, ~0u}, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT));
  EXPECT_THROW(device.allocated({64, 1, 0}, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT), std::runtime_error);
}

TEST(GpuDrivers, where_there_is_none_the_reason_says_what_to_install) {
  const std::array variables = {"VK_DRIVER_FILES", "VK_ICD_FILENAMES"};
  std::vector<std::optional<std::string>> before;
  for (const char* variable : variables) {
    const char* value = std::getenv(variable);
    before.push_back(value != nullptr ? std::optional<std::string>(value) : std::nullopt);
    setenv(variable, "no-such-driver.json", 1);
  }
  EXPECT_EQ(why_no_device(), "no Vulkan device: install a driver, such as mesa-vulkan-drivers");
  for (std::size_t i = 0; i < variables.size(); ++i) {
    if (before[i]) {
      setenv(variables[i], before[i]->c_str(), 1);
    } else {
      unsetenv(variables[i]);
    }
  }
}

}  // namespace
}  // namespace foredraw::gpu::device_test
