#include "uploaded_parts.h"

#include <foredraw/geometry/finite.h>
#include <foredraw/viewing/mask.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <stdexcept>

namespace foredraw {

namespace {

void append_finite(std::vector<std::uint32_t>& indices, const RasterPart& part) {
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const std::span<const std::uint32_t> triangle = part.indices.subspan(i, 3);
    const bool is_finite_one = std::all_of(triangle.begin(), triangle.end(),
                                           [&](std::uint32_t index) { return is_finite(part.positions[index]); });
    if (is_finite_one) indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
}

/// Images that parts share are there once.
struct UploadedMasks {
  std::vector<glm::vec3> places;
  std::vector<std::uint32_t> texels;
  std::map<const AlphaImage*, std::size_t> first_texels;

  UploadedParts::Holes append(const Mask& mask) {
    UploadedParts::Holes holes{places.size() * sizeof(glm::vec3), {.cutoff = static_cast<float>(mask.cutoff)}};
    for (std::size_t v = 0; v < mask.alphas.size(); ++v) {
      places.emplace_back(glm::vec2(mask.image ? mask.uv[v] : glm::dvec2(0)), mask.alphas[v]);
    }
    if (!mask.image) return holes;
    const auto [found, is_new] = first_texels.emplace(mask.image.get(), texels.size());
    if (is_new) texels.insert(texels.end(), mask.image->alpha.begin(), mask.image->alpha.end());
    holes.constants = {static_cast<std::uint32_t>(found->second),
                       mask.image->width,
                       mask.image->height,
                       static_cast<std::uint32_t>(mask.sampling.wrap[0]),
                       static_cast<std::uint32_t>(mask.sampling.wrap[1]),
                       mask.sampling.is_nearest ? 1u : 0u,
                       holes.constants.cutoff};
    return holes;
  }
};

}  // namespace

UploadedParts::UploadedParts(gpu::Device& device, std::span<const RasterPart> parts) {
  std::vector<glm::vec3> all_positions;
  std::vector<std::uint32_t> all_indices;
  UploadedMasks masks;
  const std::vector<PreparedPart> ready = prepared(parts);
  for (std::uint32_t number = 0; number < parts.size(); ++number) {
    const std::size_t first = all_indices.size();
    append_finite(all_indices, parts[number]);
    const std::size_t count = all_indices.size() - first;
    if (count == 0) continue;
    if (count > 0xFFFFFFFF)
      throw std::runtime_error(
          "overdraw-vulkan draws fewer than 2^32 indices at once; split the mesh or measure with overdraw-raster");
    drawn.push_back(
        {number, all_positions.size() * sizeof(glm::vec3), first * sizeof(std::uint32_t),
         static_cast<std::uint32_t>(count), parts[number].culls_back_faces ? VK_CULL_MODE_BACK_BIT : VK_CULL_MODE_NONE,
         parts[number].is_mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE, std::nullopt});
    if (parts[number].mask) drawn.back().holes = masks.append(*parts[number].mask);
    triangles += count / 3;
    for (std::size_t v = 0; v < parts[number].positions.size(); ++v) {
      // Those that no triangle uses may lie anywhere, and too far out for a float.
      all_positions.emplace_back(glm::clamp(ready[number].position(v), -1.0, 1.0));
    }
  }
  vertices = gpu::DeviceBuffer(device, std::as_bytes(std::span(all_positions)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  indices = gpu::DeviceBuffer(device, std::as_bytes(std::span(all_indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  if (masks.places.empty()) return;
  if (masks.texels.size() * sizeof(std::uint32_t) > device.limits().maxStorageBufferRange) {
    throw std::runtime_error(device.name() +
                             " cannot hold the alpha of all masked materials at once; measure with overdraw-raster");
  }
  places = gpu::DeviceBuffer(device, std::as_bytes(std::span(masks.places)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  texels = gpu::DeviceBuffer(device, std::as_bytes(std::span(masks.texels)), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
}

}  // namespace foredraw
