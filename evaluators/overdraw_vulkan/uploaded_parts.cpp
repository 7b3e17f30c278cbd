#include "uploaded_parts.h"

#include <foredraw/analysis/mesh_facts.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace foredraw {

namespace {

Culled culled(const RasterPart& part) {
  if (!part.culls_back_faces) return Culled::none;
  return part.is_mirrored ? Culled::counter_clockwise : Culled::clockwise;
}

void append_finite(std::vector<std::uint32_t>& indices, const RasterPart& part) {
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const std::span<const std::uint32_t> triangle = part.indices.subspan(i, 3);
    const bool is_finite_one = std::all_of(triangle.begin(), triangle.end(),
                                           [&](std::uint32_t index) { return is_finite(part.positions[index]); });
    if (is_finite_one) indices.insert(indices.end(), triangle.begin(), triangle.end());
  }
}

}  // namespace

UploadedParts::UploadedParts(VulkanDevice& device, std::span<const RasterPart> parts) {
  std::vector<glm::vec3> all_positions;
  std::vector<std::uint32_t> all_indices;
  const std::vector<PreparedPart> ready = prepared(parts);
  for (std::uint32_t number = 0; number < parts.size(); ++number) {
    const std::size_t first = all_indices.size();
    append_finite(all_indices, parts[number]);
    const std::size_t count = all_indices.size() - first;
    if (count == 0) continue;
    if (count > 0xFFFFFFFF)
      throw std::runtime_error("overdraw-vulkan draws 2^32 indices at once at most; split the mesh");
    drawn.push_back({number, all_positions.size() * sizeof(glm::vec3), first * sizeof(std::uint32_t),
                     static_cast<std::uint32_t>(count), culled(parts[number])});
    triangles += count / 3;
    for (std::size_t v = 0; v < parts[number].positions.size(); ++v) {
      // Those that no triangle uses may lie anywhere, and too far out for a float.
      all_positions.emplace_back(glm::clamp(ready[number].position(v), -1.0, 1.0));
    }
  }
  vertices = DeviceBuffer(device, std::as_bytes(std::span(all_positions)), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  indices = DeviceBuffer(device, std::as_bytes(std::span(all_indices)), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

}  // namespace foredraw
