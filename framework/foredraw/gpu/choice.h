#pragma once
// Which device is wanted, in words that need no header of Vulkan.

#include <optional>
#include <string>
#include <vector>

namespace foredraw::gpu {

struct DeviceChoice {
  /// Part of the device's name, in any case; empty: the first of discrete, integrated, virtual, CPU.
  std::string device;
  /// Where the validation layer tells its own; none: without the layer.
  std::vector<std::string>* complaints = nullptr;
};

/// Why no device can be had, and what to do; nothing: one can. Starts the drivers, and ends them.
std::optional<std::string> why_no_device(const DeviceChoice& choice = {});

/// The device that is chosen, and the version of its driver; why there is none. Starts the drivers, and ends them.
std::string device_text(const DeviceChoice& choice = {});

/// Whether the validation layer is installed.
bool has_validation();

}  // namespace foredraw::gpu
