#include <foredraw/gpu/candidate.h>

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <vector>

namespace foredraw::gpu {

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A small number is better.
int rank(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return 4;
    default: return 3;
  }
}

struct GraphicsQueue {
  std::uint32_t family;
  std::uint32_t timestamp_bits;
};

std::optional<GraphicsQueue> graphics_queue(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device, &count, families.data());
  for (std::uint32_t i = 0; i < count; ++i) {
    if ((families[i].queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0) return GraphicsQueue{i, families[i].timestampValidBits};
  }
  return std::nullopt;
}

VkFormat depth_format(VkPhysicalDevice device) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT, &properties);
  const bool has_float = (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
  return has_float ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_X8_D24_UNORM_PACK32;  // one of the two is always there
}

/// What the device can not do that is needed; empty: nothing.
std::string lack_of(VkPhysicalDevice device, std::uint32_t api_version) {
  VkPhysicalDeviceFeatures features;
  vkGetPhysicalDeviceFeatures(device, &features);
  if (api_version < VK_API_VERSION_1_1) return "Vulkan 1.1";
  if (!graphics_queue(device)) return "a queue for graphics";
  if (!features.occlusionQueryPrecise) return "precise occlusion queries";
  if (!features.fragmentStoresAndAtomics) return "atomics in fragment shaders";
  if (!features.fullDrawIndexUint32) return "32-bit indices";
  return "";
}

}  // namespace

Candidate chosen_device(VkInstance instance, const std::string& name) {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "vkEnumeratePhysicalDevices");

  Candidate best;
  int best_rank = 0;
  std::string others;
  for (VkPhysicalDevice device : devices) {
    VkPhysicalDeviceProperties properties;
    vkGetPhysicalDeviceProperties(device, &properties);
    const std::string lack = lack_of(device, properties.apiVersion);
    const bool is_named = lower_case(properties.deviceName).find(lower_case(name)) != std::string::npos;
    if (!lack.empty() || !is_named) {
      others += (others.empty() ? "" : ", ") + std::string(properties.deviceName);
      if (!lack.empty()) others += " (which lacks " + lack + ')';
    } else if (best.device == VK_NULL_HANDLE || rank(properties.deviceType) < best_rank) {
      const GraphicsQueue queue = *graphics_queue(device);
      best = {device, queue.family, queue.timestamp_bits, depth_format(device)};
      best_rank = rank(properties.deviceType);
    }
  }
  if (best.device != VK_NULL_HANDLE) return best;
  if (others.empty()) throw std::runtime_error(no_device);
  if (name.empty()) throw std::runtime_error("no Vulkan device that will do, only " + others);
  throw std::runtime_error("no Vulkan device that will do is called '" + name + "', but there is " + others);
}

}  // namespace foredraw::gpu
