#include <foredraw/gpu/candidate.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace foredraw::gpu {

namespace {

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

/// A small number is better.
int rank(const Candidate& candidate) {
  switch (candidate.properties.deviceType) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 0;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 1;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return 4;
    default: return 3;
  }
}

bool has_graphics_queue(Candidate& candidate) {
  std::uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(candidate.device, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(candidate.device, &count, families.data());
  const auto found = std::ranges::find_if(
      families, [](const VkQueueFamilyProperties& family) { return (family.queueFlags & VK_QUEUE_GRAPHICS_BIT) != 0; });
  if (found == families.end()) return false;
  candidate.queue_family = static_cast<std::uint32_t>(found - families.begin());
  candidate.timestamp_bits = found->timestampValidBits;
  return true;
}

VkFormat depth_format(VkPhysicalDevice device) {
  VkFormatProperties properties;
  vkGetPhysicalDeviceFormatProperties(device, VK_FORMAT_D32_SFLOAT, &properties);
  const bool has_float = (properties.optimalTilingFeatures & VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT) != 0;
  return has_float ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_X8_D24_UNORM_PACK32;  // one of the two is always there
}

bool has_transform_feedback(VkPhysicalDevice device) {
  std::uint32_t count = 0;
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, nullptr), "vkEnumerateDeviceExtensionProperties");
  std::vector<VkExtensionProperties> extensions(count);
  check(vkEnumerateDeviceExtensionProperties(device, nullptr, &count, extensions.data()),
        "vkEnumerateDeviceExtensionProperties");
  const std::string_view wanted = VK_EXT_TRANSFORM_FEEDBACK_EXTENSION_NAME;
  if (std::ranges::none_of(extensions, [&](const auto& extension) { return extension.extensionName == wanted; })) {
    return false;
  }
  VkPhysicalDeviceTransformFeedbackFeaturesEXT feedback{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_TRANSFORM_FEEDBACK_FEATURES_EXT};
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, .pNext = &feedback};
  vkGetPhysicalDeviceFeatures2(device, &features);
  return feedback.transformFeedback == VK_TRUE;
}

/// What the device can not do that is needed; empty: nothing, and the candidate is whole.
std::string lack_of(Candidate& candidate) {
  VkPhysicalDeviceFeatures has;
  vkGetPhysicalDeviceFeatures(candidate.device, &has);
  if (candidate.properties.apiVersion < VK_API_VERSION_1_1) return "Vulkan 1.1";
  if (!has_graphics_queue(candidate)) return "a graphics queue";
  if (!has.occlusionQueryPrecise) return "precise occlusion queries";
  if (!has.fullDrawIndexUint32) return "32-bit indices";
  candidate.features = {.fullDrawIndexUint32 = VK_TRUE,
                        .tessellationShader = has.tessellationShader,
                        .multiDrawIndirect = has.multiDrawIndirect & has.drawIndirectFirstInstance,
                        .drawIndirectFirstInstance = has.multiDrawIndirect & has.drawIndirectFirstInstance,
                        .occlusionQueryPrecise = VK_TRUE,
                        .pipelineStatisticsQuery = has.pipelineStatisticsQuery,
                        .fragmentStoresAndAtomics = has.fragmentStoresAndAtomics};
  candidate.depth_format = depth_format(candidate.device);
  candidate.has_transform_feedback = has_transform_feedback(candidate.device);
  return "";
}

}  // namespace

Candidate chosen_device(VkInstance instance, const std::string& name) {
  std::uint32_t count = 0;
  check(vkEnumeratePhysicalDevices(instance, &count, nullptr), "vkEnumeratePhysicalDevices");
  std::vector<VkPhysicalDevice> devices(count);
  check(vkEnumeratePhysicalDevices(instance, &count, devices.data()), "vkEnumeratePhysicalDevices");

  Candidate best;
  std::string others;
  for (VkPhysicalDevice device : devices) {
    Candidate candidate{device};
    vkGetPhysicalDeviceProperties(device, &candidate.properties);
    const std::string lack = lack_of(candidate), called = candidate.properties.deviceName;
    if (!lack.empty() || lower_case(called).find(lower_case(name)) == std::string::npos) {
      others += (others.empty() ? "" : ", ") + called + (lack.empty() ? "" : " (lacks " + lack + ')');
    } else if (best.device == VK_NULL_HANDLE || rank(candidate) < rank(best)) {
      best = candidate;
    }
  }
  if (best.device != VK_NULL_HANDLE) return best;
  if (others.empty()) throw std::runtime_error(no_device);
  if (name.empty()) throw std::runtime_error("no suitable Vulkan device; found " + others);
  throw std::runtime_error("no suitable Vulkan device is called '" + name + "'; found " + others);
}

}  // namespace foredraw::gpu
