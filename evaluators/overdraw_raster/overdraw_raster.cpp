#include "overdraw_raster.h"

#include "camera.h"
#include "coverage.h"

#include <foredraw/analysis/bounding_sphere.h>
#include <foredraw/analysis/mesh_facts.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <tuple>
#include <utility>
#include <vector>

namespace foredraw {

namespace {

using Triangle = std::array<std::uint32_t, 3>;

constexpr std::uint32_t nobody = ~std::uint32_t{0};

/// A part as every view draws it: positions in radii from the sphere's centre, and the triangles that may cover
/// something.
struct PreparedPart {
  std::vector<glm::dvec3> positions;
  std::vector<Triangle> triangles;
  bool culls_back_faces = true;
  bool is_mirrored = false;
};

bool is_drawable(const RasterPart& part, const Triangle& t) {
  return t[0] != t[1] && t[1] != t[2] && t[2] != t[0] && is_finite(part.positions[t[0]]) &&
         is_finite(part.positions[t[1]]) && is_finite(part.positions[t[2]]);
}

PreparedPart prepared(const RasterPart& part, const BoundingSphere& sphere) {
  PreparedPart result;
  result.culls_back_faces = part.culls_back_faces;
  result.is_mirrored = part.is_mirrored;
  for (const glm::vec3& position : part.positions) {
    const bool has_place = is_finite(position) && sphere.radius > 0;
    result.positions.push_back(has_place ? (glm::dvec3(position) - sphere.centre) / sphere.radius : glm::dvec3(0));
  }
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    const Triangle triangle = {part.indices[i], part.indices[i + 1], part.indices[i + 2]};
    if (is_drawable(part, triangle)) result.triangles.push_back(triangle);
  }
  return result;
}

std::vector<PreparedPart> prepared(std::span<const RasterPart> parts) {
  std::vector<DrawnPositions> drawn;
  for (const RasterPart& part : parts) drawn.push_back({part.positions, part.indices});
  const BoundingSphere sphere = bounding_sphere(drawn);
  std::vector<PreparedPart> result;
  for (const RasterPart& part : parts) result.push_back(prepared(part, sphere));
  return result;
}

/// The depth buffer, and in it whose fragment each pixel shows.
class Picture {
 public:
  explicit Picture(int size) : size_(size), pixels_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}

  /// Counts for each part what passes and what stays.
  std::vector<OverdrawCount> draw(std::span<const PreparedPart> parts, const Camera& camera) {
    counts_.assign(parts.size(), {});
    std::fill(pixels_.begin(), pixels_.end(), Pixel{});
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
      if (camera.is_perspective()) {
        draw<PerspectiveDepth>(parts[part], part, camera);
      } else {
        draw<OrthographicDepth>(parts[part], part, camera);
      }
    }
    return counts_;
  }

 private:
  struct Pixel {
    std::uint32_t depth = ~std::uint32_t{0};
    std::uint32_t part = nobody;
  };

  template <class Depth>
  void draw(const PreparedPart& part, std::uint32_t number, const Camera& camera) {
    corners_.clear();
    for (const glm::dvec3& position : part.positions) corners_.push_back(camera.project(position));
    for (const auto& [i, j, k] : part.triangles) {
      Corner a = corners_[i];
      Corner b = corners_[j];
      Corner c = corners_[k];
      const PixelBox box(a, b, c);
      if (box.is_empty()) continue;
      const std::int64_t area = doubled_area(a, b, c);
      if (area == 0) continue;
      const bool shows_front = (area > 0) != part.is_mirrored;
      if (part.culls_back_faces && !shows_front) continue;
      // From here on nothing depends on which corner comes first or on how they turn: a triangle drawn twice, from its
      // two sides too, has the same depths and ties.
      sort(a, b, c);
      if (doubled_area(a, b, c) < 0) std::swap(b, c);
      const Depth depth(camera, a, b, c, std::abs(area));
      for_each_covered(a, b, c, box, [&](std::int32_t x, std::int32_t y, const std::array<std::int64_t, 3>& weights) {
        put(x, y, depth.at(weights), number);
      });
    }
  }

  static void sort(Corner& a, Corner& b, Corner& c) {
    const auto in_order = [](Corner& p, Corner& q) {
      if (std::tie(q.x, q.y, q.depth) < std::tie(p.x, p.y, p.depth)) std::swap(p, q);
    };
    in_order(a, b);
    in_order(b, c);
    in_order(a, b);
  }

  void put(std::int32_t x, std::int32_t y, std::uint32_t depth, std::uint32_t part) {
    Pixel& pixel = pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(x)];
    OverdrawCount& count = counts_[part];
    if (depth < pixel.depth) {
      ++count.shaded;
      ++count.visible;
      if (pixel.part != nobody) --counts_[pixel.part].visible;
      pixel = {depth, part};
    } else if (depth == pixel.depth) {
      ++count.ties;
    }
  }

  int size_;
  std::vector<Pixel> pixels_;
  std::vector<Corner> corners_;
  std::vector<OverdrawCount> counts_;
};

}  // namespace

OverdrawCounts overdraw_raster(std::span<const RasterPart> parts, const Views& views) {
  const std::vector<PreparedPart> ready = prepared(parts);
  OverdrawCounts counts(parts.size());
  Picture picture(views.size);
  for (const View& view : views.views) {
    const auto of_view = picture.draw(ready, Camera(view.direction, views.distance, views.size));
    for (std::size_t part = 0; part < parts.size(); ++part) counts[part].push_back(of_view[part]);
  }
  return counts;
}

std::size_t count_non_finite_triangles(const RasterPart& part) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
    for (std::size_t corner = i; corner < i + 3; ++corner) {
      if (is_finite(part.positions[part.indices[corner]])) continue;
      ++count;
      break;
    }
  }
  return count;
}

}  // namespace foredraw
