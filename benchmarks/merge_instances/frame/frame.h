#pragma once
// A frame on the device: its buffers, and its commands as an engine records them.

#include "frame_device.h"

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/storage_sets.h>

#include <optional>
#include <vector>

namespace foredraw::bench {

class Frame {
 public:
  /// Uploads everything. Throws std::runtime_error where the device can not draw in this way. The device has to live
  /// longer.
  Frame(FrameDevice& device, const Scene& scene, const FrameContent& content);

  /// All commands between the beginning and the end of the render pass.
  void record(VkCommandBuffer commands, const glm::mat4& clip_from_world) const;

  /// Each pixel's hash, row by row, or ~0 where nothing is. Throws std::logic_error where the content is not complete.
  std::vector<std::uint32_t> pixels(const glm::mat4& clip_from_world) const;

  /// The device's own time for it; nothing where it has no clock or the content is not complete.
  std::optional<double> milliseconds(const glm::mat4& clip_from_world) const;

 private:
  struct MergedCall {
    VkPipeline pipeline;
    std::uint32_t vertices, first_slot;
  };

  struct Part {
    gpu::DeviceBuffer vertices, indices, transforms, materials, slots, commands, places, instances;
    std::vector<VkBuffer> vertex_buffers;  ///< as the pipelines number them
    std::vector<VkDeviceSize> vertex_offsets;
    VkIndexType index_type = VK_INDEX_TYPE_UINT32;
    VkDescriptorSet set = VK_NULL_HANDLE;
    std::vector<gpu::OwnedPipeline> pipelines;  ///< plain and mirrored; of merged draws one for each frequency
    std::vector<DirectCall> direct;
    std::vector<IndirectCall> indirect;
    std::vector<MergedCall> merged;
  };

  void upload(const FramePart& from, Part& part);
  void add_calls(const Scene& scene, const FramePart& from, Part& part);
  VkDescriptorSet written_set(const FramePart& from, const Part& part);
  void record(VkCommandBuffer commands, const Part& part) const;
  void record_pass(VkCommandBuffer commands, const glm::mat4& clip_from_world) const;

  FrameDevice& device_;
  bool is_complete_;
  gpu::DeviceBuffer looks_;
  gpu::StorageSets sets_;
  std::vector<Part> parts_;
};

}  // namespace foredraw::bench
