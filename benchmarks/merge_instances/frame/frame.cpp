#include "frame.h"

#include "frame_pipeline.h"
#include "frame_shaders.h"

#include <foredraw/gpu/stopwatch.h>
#include <plugins/processors/merge_instances/merged_shader.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <stdexcept>

namespace foredraw::bench {

namespace {

template <class T>
gpu::DeviceBuffer uploaded(gpu::Device& device, const std::vector<T>& content, VkBufferUsageFlags usage) {
  const bool is_read_by_shaders = (usage & VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) != 0;
  if (is_read_by_shaders && content.size() * sizeof(T) > device.limits().maxStorageBufferRange) {
    throw std::runtime_error(device.name() + " has no storage buffers of " +
                             std::to_string(content.size() * sizeof(T)) + " bytes, at most " +
                             std::to_string(device.limits().maxStorageBufferRange) + "; draw fewer instances");
  }
  return gpu::DeviceBuffer(device, std::as_bytes(std::span(content)), usage);
}

void push(VkCommandBuffer commands, VkPipelineLayout layout, std::uint32_t first) {
  vkCmdPushConstants(commands, layout, VK_SHADER_STAGE_VERTEX_BIT, offsetof(FrameConstants, first), sizeof(first),
                     &first);
}

/// Binds only what is not bound yet.
class BoundPipeline {
 public:
  explicit BoundPipeline(VkCommandBuffer commands) : commands_(commands) {}

  void bind(VkPipeline pipeline) {
    if (pipeline != bound_) vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
    bound_ = pipeline;
  }

 private:
  VkCommandBuffer commands_;
  VkPipeline bound_ = VK_NULL_HANDLE;
};

}  // namespace

Frame::Frame(FrameDevice& device, const Scene& scene, const FrameContent& content)
    : device_(device),
      is_complete_(content.is_complete),
      looks_(uploaded(device.device(), hashes_of_looks(scene), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT)),
      sets_(device.device(), device.set_layout(), binding::count, content.parts.size()) {
  for (const FramePart& from : content.parts) {
    Part& part = parts_.emplace_back();
    upload(from, part);
    add_calls(scene, from, part);
    part.set = written_set(from, part);
  }
}

void Frame::upload(const FramePart& from, Part& part) {
  gpu::Device& device = device_.device();
  constexpr VkBufferUsageFlags storage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, vertex = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT,
                               index = VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
  const bool is_merged = from.fetch == VertexFetch::merged;
  const MergedVertexLayout layout = merged_vertex_layout(*from.vertices);
  part.vertices = uploaded(device, merged_vertex_bytes(*from.vertices, layout), is_merged ? storage : vertex);
  if (from.index_bytes == 2) {
    const std::vector<std::uint16_t> small(from.indices.begin(), from.indices.end());
    part.indices = uploaded(device, small, index);
    part.index_type = VK_INDEX_TYPE_UINT16;
  } else {
    part.indices = uploaded(device, from.indices, is_merged ? storage : index);
  }
  part.transforms = uploaded(device, from.transforms, storage);
  part.materials = uploaded(device, from.materials, storage);
  part.slots = uploaded(device, from.slots, storage);
  part.commands = uploaded(device, from.commands, VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT);
  part.places = uploaded(device, from.places, storage);
  part.instances = uploaded(device, from.instances, vertex);
  if (is_merged) return;
  for (const MergedVertexLayout::Attribute& attribute : layout.attributes) {
    part.vertex_buffers.push_back(part.vertices.get());
    part.vertex_offsets.push_back(attribute.offset);
  }
  if (from.fetch == VertexFetch::in_world) {
    part.vertex_buffers.push_back(part.instances.get());
    part.vertex_offsets.push_back(0);
  }
}

void Frame::add_calls(const Scene& scene, const FramePart& from, Part& part) {
  if (from.fetch == VertexFetch::merged) {
    std::map<std::uint32_t, VkPipeline> of_frequency;
    for (const MergedDraw& draw : from.merged) {
      VkPipeline& pipeline = of_frequency[draw.frequency];
      if (pipeline == VK_NULL_HANDLE) {
        part.pipelines.push_back(frame_pipeline(device_, scene, from, draw.frequency, false));
        pipeline = part.pipelines.back().get();
      }
      part.merged.push_back({pipeline, draw.slot_count * draw.frequency, draw.first_slot});
    }
    return;
  }
  if (!from.indirect.empty() && !device_.device().draws_many_indirectly()) {
    throw std::runtime_error(device_.device().name() + " does not support multi-draw indirect with a first instance");
  }
  for (const bool is_mirrored : {false, true}) {
    part.pipelines.push_back(frame_pipeline(device_, scene, from, 0, is_mirrored));
  }
  part.direct = from.direct;
  part.indirect = from.indirect;
}

VkDescriptorSet Frame::written_set(const FramePart& from, const Part& part) {
  // Where a part's shader reads none there has to be one all the same.
  std::array<VkBuffer, binding::count> buffers;
  buffers.fill(looks_.get());
  if (from.fetch == VertexFetch::merged) {
    buffers[binding::slots] = part.slots.get();
    buffers[binding::indices] = part.indices.get();
    buffers[binding::vertices] = part.vertices.get();
  }
  buffers[binding::transforms] = part.transforms.get();
  buffers[binding::materials] = part.materials.get();
  buffers[binding::places] = part.places.get();
  const VkDescriptorSet set = sets_.add();
  sets_.write(set, buffers);
  return set;
}

void Frame::record(VkCommandBuffer commands, const glm::mat4& clip_from_world) const {
  const FrameConstants constants{clip_from_world, 0};
  vkCmdPushConstants(commands, device_.layout(), VK_SHADER_STAGE_VERTEX_BIT, 0, sizeof(constants), &constants);
  for (const Part& part : parts_) record(commands, part);
}

void Frame::record(VkCommandBuffer commands, const Part& part) const {
  BoundPipeline bound(commands);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, device_.layout(), 0, 1, &part.set, 0, nullptr);
  if (!part.vertex_buffers.empty()) {
    vkCmdBindVertexBuffers(commands, 0, static_cast<std::uint32_t>(part.vertex_buffers.size()),
                           part.vertex_buffers.data(), part.vertex_offsets.data());
    vkCmdBindIndexBuffer(commands, part.indices.get(), 0, part.index_type);
  }
  // The parts before left their own.
  std::uint32_t first = 0;
  push(commands, device_.layout(), first);
  for (const DirectCall& call : part.direct) {
    bound.bind(part.pipelines[call.is_mirrored ? 1 : 0].get());
    if (call.first != first) push(commands, device_.layout(), first = call.first);
    vkCmdDrawIndexed(commands, call.command.index_count, call.command.instance_count, call.command.first_index,
                     call.command.vertex_offset, call.command.first_instance);
  }
  const std::uint32_t most = std::max(1u, device_.device().limits().maxDrawIndirectCount);
  for (const IndirectCall& call : part.indirect) {
    bound.bind(part.pipelines[call.is_mirrored ? 1 : 0].get());
    for (std::uint32_t done = 0; done < call.commands; done += std::min(most, call.commands - done)) {
      vkCmdDrawIndexedIndirect(commands, part.commands.get(), (call.first_command + done) * sizeof(IndexedCommand),
                               std::min(most, call.commands - done), sizeof(IndexedCommand));
    }
  }
  for (const MergedCall& call : part.merged) {
    bound.bind(call.pipeline);
    if (call.first_slot != first) push(commands, device_.layout(), first = call.first_slot);
    vkCmdDraw(commands, call.vertices, 1, 0, 0);
  }
}

void Frame::record_pass(VkCommandBuffer commands, const glm::mat4& clip_from_world) const {
  device_.pictures().begin(commands, 0);
  record(commands, clip_from_world);
  vkCmdEndRenderPass(commands);
}

std::vector<std::uint32_t> Frame::pixels(const glm::mat4& clip_from_world) const {
  if (!is_complete_) throw std::logic_error("a frame is drawn whose vertices were only counted");
  device_.device().run([&](VkCommandBuffer commands) {
    record_pass(commands, clip_from_world);
    device_.pictures().copy_out(commands, 1);
  });
  const auto shown = device_.pictures().pixels(0);
  return {shown.begin(), shown.end()};
}

std::optional<double> Frame::milliseconds(const glm::mat4& clip_from_world) const {
  if (!is_complete_ || device_.device().timestamp_mask() == 0) return std::nullopt;
  const auto record = [&](VkCommandBuffer commands) { record_pass(commands, clip_from_world); };
  return 1e-6 * gpu::nanoseconds(device_.device(), record);
}

}  // namespace foredraw::bench
