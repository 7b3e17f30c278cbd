#pragma once
#include "vulkan_memory.h"

#include <foredraw/analysis/raster_part.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Which triangles are not drawn, by how they turn in the picture.
enum class Culled { none, clockwise, counter_clockwise };

/// The vertex and index buffers of all parts on the device: indices as they are, so that the device finds in its vertex
/// cache what it would find in a renderer's draw call. Positions are in radii from the centre of the sphere around all
/// parts. Triangles with a position that is not finite are left out.
struct UploadedParts {
  struct Part {
    std::uint32_t number;  ///< among all parts
    VkDeviceSize vertices_at;
    VkDeviceSize indices_at;
    std::uint32_t index_count;
    Culled culled;
  };

  UploadedParts(VulkanDevice& device, std::span<const RasterPart> parts);

  std::vector<Part> drawn;  ///< those that have triangles
  std::uint64_t triangles = 0;
  DeviceBuffer vertices;
  DeviceBuffer indices;
};

}  // namespace foredraw
