#include <foredraw/gpu/capture.h>

#include <array>
#include <stdexcept>

namespace foredraw::gpu {

namespace {

/// A function of an extension, which the loader knows by name alone.
template <class Function>
Function named(const Device& device, const char* name) {
  return reinterpret_cast<Function>(vkGetDeviceProcAddr(device.get(), name));
}

const Device& capturing(const Device& device) {
  if (device.captures()) return device;
  throw std::runtime_error(device.name() + " lacks VK_EXT_transform_feedback; choose another device");
}

}  // namespace

Capture::Capture(const Device& device, VkDeviceSize bytes)
    : outputs_(capturing(device), bytes, VK_BUFFER_USAGE_TRANSFORM_FEEDBACK_BUFFER_BIT_EXT),
      counts_(device, VK_QUERY_TYPE_TRANSFORM_FEEDBACK_STREAM_EXT, 1),
      bind_(named<PFN_vkCmdBindTransformFeedbackBuffersEXT>(device, "vkCmdBindTransformFeedbackBuffersEXT")),
      begin_(named<PFN_vkCmdBeginTransformFeedbackEXT>(device, "vkCmdBeginTransformFeedbackEXT")),
      end_(named<PFN_vkCmdEndTransformFeedbackEXT>(device, "vkCmdEndTransformFeedbackEXT")) {}

void Capture::begin(VkCommandBuffer commands) const {
  const VkBuffer buffer = outputs_.get();
  const VkDeviceSize offset = 0;
  bind_(commands, 0, 1, &buffer, &offset, nullptr);
  vkCmdBeginQuery(commands, counts_.get(), 0, 0);
  begin_(commands, 0, 0, nullptr, nullptr);
}

void Capture::end(VkCommandBuffer commands) const {
  end_(commands, 0, 0, nullptr, nullptr);
  vkCmdEndQuery(commands, counts_.get(), 0);
}

void Capture::let_read(VkCommandBuffer commands) const {
  let_see(commands, VK_PIPELINE_STAGE_TRANSFORM_FEEDBACK_BIT_EXT, VK_ACCESS_TRANSFORM_FEEDBACK_WRITE_BIT_EXT,
          VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
}

Capture::Triangles Capture::triangles() const {
  std::array<std::uint64_t, 2> counts{};
  counts_.read(0, counts, counts.size());
  return {counts[0], counts[1]};
}

}  // namespace foredraw::gpu
