#pragma once
// A device with what drawing needs on it, kept from subject to subject.

#include "draw_pipelines.h"
#include "uploaded_parts.h"

#include <foredraw/gpu/pictures.h>
#include <foredraw/scene/views.h>

#include <functional>
#include <memory>

namespace foredraw {

/// How parts are drawn, and what is done around each draw, by its number among those that are drawn.
struct DrawManner {
  Shading shading = Shading::owner;
  Passing passing = Passing::nearer;
  std::function<void(std::uint32_t)> before = [](std::uint32_t) {};
  std::function<void(std::uint32_t)> after = [](std::uint32_t) {};
};

/// Used by one thread at a time.
class VulkanPainter {
 public:
  /// Throws std::runtime_error where there is no such device.
  explicit VulkanPainter(const gpu::DeviceChoice& choice = {}) : device_(choice), pipelines_(device_) {}

  gpu::Device& device() { return device_; }
  DrawPipelines& pipelines() { return pipelines_; }
  /// Kept as long as the same size is asked for.
  gpu::Pictures& pictures(int size);
  /// Those that there are, of whatever size.
  gpu::Pictures& any_pictures() { return pictures_ ? *pictures_ : pictures(16); }

  /// Ready to be drawn, and the last ones that are: the shaders' texels are theirs from here on.
  UploadedParts uploaded(std::span<const RasterPart> parts);

  /// Draws the parts one after the other into the picture that was begun.
  void draw(VkCommandBuffer commands, const UploadedParts& parts, const View& view, const DrawManner& manner);

 private:
  gpu::Device device_;
  DrawPipelines pipelines_;
  std::unique_ptr<gpu::Pictures> pictures_;
};

}  // namespace foredraw
