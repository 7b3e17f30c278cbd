#pragma once
// Overdraw of an order by drawing in it, for the tests of those who do not draw.

#include "support/meshes.h"

#include <foredraw/overdraw/fragments.h>
#include <foredraw/overdraw/overdraw_count.h>

#include <numeric>
#include <vector>

namespace foredraw::testing {

/// Every triangle's fragments in one view, and a depth buffer to paint them into in any order.
class Painter {
 public:
  Painter(std::span<const RasterPart> parts, const View& view, int size)
      : pixels_(static_cast<std::size_t>(size * size)) {
    std::size_t triangles = 0;
    for (const RasterPart& part : parts) triangles += part.indices.size() / 3;
    fragments_.resize(triangles);
    Rasteriser rasteriser;
    for (const PreparedPart& part : prepared(parts)) {
      rasteriser.draw(part, Camera(view, size), [&](const Fragments& some) {
        for (std::size_t i = 0; i < some.count; ++i) {
          fragments_[some.triangles[i]].push_back({some.pixels[i], some.depths[i]});
        }
      });
    }
  }

  OverdrawCount paint(std::span<const std::uint32_t> order) const {
    constexpr std::uint32_t nothing = ~std::uint32_t{0};
    std::vector<std::uint32_t> depths(pixels_, nothing);
    OverdrawCount count;
    for (const std::uint32_t triangle : order) {
      for (const auto& [pixel, depth] : fragments_[triangle]) {
        if (depths[pixel] == nothing) ++count.visible;
        if (depth < depths[pixel]) ++count.shaded;
        if (depth == depths[pixel]) ++count.ties;
        depths[pixel] = std::min(depths[pixel], depth);
      }
    }
    return count;
  }

 private:
  struct Fragment {
    std::size_t pixel;
    std::uint32_t depth;
  };
  std::vector<std::vector<Fragment>> fragments_;
  std::size_t pixels_;
};

/// [view]
inline std::vector<OverdrawCount> painted(std::span<const RasterPart> parts, const Views& views,
                                          std::span<const std::uint32_t> order) {
  std::vector<OverdrawCount> counts;
  for (const View& view : views.views) counts.push_back(Painter(parts, view, views.size).paint(order));
  return counts;
}

inline std::vector<std::uint32_t> rising_order(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

inline std::vector<std::uint32_t> random_order(std::size_t count, std::uint64_t seed) {
  std::vector<std::uint32_t> order = rising_order(count);
  Random random(seed);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
  return order;
}

/// A mesh that is hard on layers: closed, open, interpenetrating, with surfaces that coincide (`twice`: all of it, so
/// that everything ties), and slivers.
inline TestMesh tangle(std::uint64_t seed, bool twice) {
  Random random(seed);
  const auto coordinate = [&] { return static_cast<float>(2 * random.unit() - 1); };
  const auto place = [&] { return glm::vec3{coordinate(), coordinate(), coordinate()} * 0.5f; };
  TestMesh mesh = joined(sphere(8, 5, 0.7f, place()), torus(9, 6, 0.8f, 0.3f));
  mesh = joined(mesh, joined(grid(2, 2), grid(2, 2)));
  mesh = joined(mesh, soup(12, seed));
  for (int i = 0; i < 8; ++i) {  // slivers
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 from = place();
    mesh.positions.insert(mesh.positions.end(), {from, place() * 3.0f, from + glm::vec3(0.01f, 0, 0.005f)});
    mesh.indices.insert(mesh.indices.end(), {first, first + 1, first + 2});
  }
  return shuffled(twice ? joined(mesh, mesh) : joined(mesh, sphere(8, 5, 0.7f, place())), seed);
}

inline RasterPart part_of(const TestMesh& mesh, bool culls_back_faces = true) {
  return {mesh.positions, mesh.indices, culls_back_faces, false};
}

}  // namespace foredraw::testing
