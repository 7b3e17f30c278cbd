#pragma once
#include "draw_pipelines.h"
#include "overdraw_vulkan.h"

#include <foredraw/gpu/memory.h>
#include <foredraw/gpu/queries.h>

#include <vector>

namespace foredraw {

/// Numbered counters of fragments that pass. A shader that may discard can not count what passes, so parts with holes
/// are counted by queries whatever the method is.
class FragmentCounters {
 public:
  FragmentCounters(const gpu::Device& device, DrawPipelines& pipelines, CountMethod method, std::uint32_t count);

  /// The fragment shader that goes with them.
  Shading shading() const { return method_ == CountMethod::atomics ? Shading::counted : Shading::owner; }
  /// Before the first picture is begun; `behind` when the last is done.
  void start(VkCommandBuffer commands);
  void finish(VkCommandBuffer commands) const;
  /// Around each draw.
  void begin(VkCommandBuffer commands, std::uint32_t counter, bool has_holes);
  void end(VkCommandBuffer commands, std::uint32_t counter) const;
  /// Once the commands are done. Each of the first `count` counters has to have been used.
  std::vector<std::uint64_t> read(std::uint32_t count) const;

 private:
  DrawPipelines& pipelines_;
  CountMethod method_;
  std::uint32_t count_;
  gpu::Queries queries_;
  gpu::VisibleBuffer atomics_;
  std::vector<bool> is_queried_;  ///< [counter]
};

}  // namespace foredraw
