#pragma once
#include <foredraw/gpu/memory.h>
#include <foredraw/viewing/raster_part.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// What shaders/masked.frag is told.
struct HoleConstants {
  std::uint32_t first_texel, width, height, wrap_u, wrap_v, is_nearest;
  float cutoff;
};

/// The vertex and index buffers of all parts on the device: indices as they are, so that the device finds in its vertex
/// cache what it would find in a renderer's draw call. Positions are in radii from the centre of the sphere around all
/// parts. Triangles with a position that is not finite are left out.
struct UploadedParts {
  struct Holes {
    VkDeviceSize places_at;  ///< in `places`
    HoleConstants constants;
  };
  struct Part {
    std::uint32_t number;  ///< among all parts
    VkDeviceSize vertices_at;
    VkDeviceSize indices_at;
    std::uint32_t index_count;
    VkCullModeFlags culled;
    VkFrontFace front_face;
    std::optional<Holes> holes;
  };

  UploadedParts(gpu::Device& device, std::span<const RasterPart> parts);

  std::vector<Part> drawn;  ///< those that have triangles
  std::uint64_t triangles = 0;
  gpu::DeviceBuffer vertices;
  gpu::DeviceBuffer indices;
  gpu::DeviceBuffer places;  ///< of the vertices of parts with holes: where in their image, and their alpha
  gpu::DeviceBuffer texels;  ///< alphas of their images
};

}  // namespace foredraw
