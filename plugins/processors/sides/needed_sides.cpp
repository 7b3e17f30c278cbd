#include "needed_sides.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/fragments.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw::sides {

namespace {

constexpr std::uint32_t nothing = ~std::uint32_t{0};

/// One picture, drawn whole and drawn of the kept sides alone.
struct TwoPictures {
  std::vector<std::uint32_t> whole, kept;  ///< [pixel] depth
  std::vector<std::uint32_t> nearest;      ///< [pixel] the side at the depth of `whole`
};

TwoPictures draw_both(std::span<const PreparedPart> parts, const std::vector<std::uint8_t>& is_kept, const View& view,
                      int size) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  TwoPictures pictures{std::vector(pixels, nothing), std::vector(pixels, nothing), std::vector(pixels, nothing)};
  const Camera camera(view, size);
  Rasteriser rasteriser;
  for (const PreparedPart& part : parts) {
    rasteriser.draw(part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        const std::uint32_t pixel = some.pixels[i], depth = some.depths[i];
        if (depth < pictures.whole[pixel]) {
          pictures.whole[pixel] = depth;
          pictures.nearest[pixel] = some.triangles[i];
        }
        if (is_kept[some.triangles[i]] != 0) pictures.kept[pixel] = std::min(pictures.kept[pixel], depth);
      }
    });
  }
  return pictures;
}

glm::dvec3 corner_of(const RasterPart& part, std::size_t triangle, std::size_t corner) {
  return glm::dvec3(part.positions[part.indices[3 * triangle + corner]]);
}

/// Uniform over the sphere, of a length from 0.1 to 1.
glm::dvec3 any_direction(Random& random) {
  for (;;) {
    const double x = 2 * random.unit() - 1, y = 2 * random.unit() - 1, z = 2 * random.unit() - 1;
    const double squared = x * x + y * y + z * z;
    if (squared <= 1 && squared >= 0.01) return {x, y, z};
  }
}

/// Pulled inwards by a fiftieth, so that no ray begins on an edge.
glm::dvec3 any_point(const std::array<glm::dvec3, 3>& corners, Random& random) {
  double u = random.unit(), v = random.unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  const glm::dvec3 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
  const glm::dvec3 point = corners[0] + u * (corners[1] - corners[0]) + v * (corners[2] - corners[0]);
  return middle + 0.98 * (point - middle);
}

bool is_seen_by_rays(const RayTree& tree, const RasterPart& part, std::size_t triangle, std::uint32_t number, Side side,
                     const RayOptions& options) {
  std::array<glm::dvec3, 3> corners;
  for (std::size_t c = 0; c < 3; ++c) corners[c] = corner_of(part, triangle, c);
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double area = glm::dot(normal, normal);
  if (!(area > 0) || !std::isfinite(area)) return false;  // covers nothing
  const double size = std::sqrt(std::sqrt(area));
  const bool is_turned = (side == back) != part.is_mirrored;
  Random random(derive_seed(options.seed, number, side));
  for (std::size_t i = 0; i < options.rays; ++i) {
    glm::dvec3 direction = any_direction(random);
    const bool leaves_back = glm::dot(direction, normal) < 0;
    if (leaves_back != is_turned) direction = -direction;
    const double length = std::sqrt(glm::dot(direction, direction));
    const RayTree::Ray ray{any_point(corners, random), direction, 1e-4 * size / length, number};
    if (tree.escapes(ray)) return true;
  }
  return false;
}

}  // namespace

Needed add_needed_by_pictures(const AllSides& all, SidesOfParts& kept, const Views& views, const Executor& executor) {
  std::vector<std::uint8_t> is_kept(all.count());
  for (std::uint32_t number = 0; number < is_kept.size(); ++number) {
    const AllSides::Place place = all.place_of(number);
    is_kept[number] = (kept[place.part][place.triangle] & place.side) != 0;
  }
  const std::vector<PreparedPart> parts = prepared(all.parts());
  struct OfView {
    Needed needed;
    std::vector<std::uint32_t> sides;
  };
  std::vector<OfView> of_views(views.views.size());
  executor.for_each(views.views.size(), [&](std::size_t v) {
    const TwoPictures pictures = draw_both(parts, is_kept, views.views[v], views.size);
    OfView& of_view = of_views[v];
    for (std::size_t pixel = 0; pixel < pictures.whole.size(); ++pixel) {
      if (pictures.whole[pixel] == nothing) continue;
      ++of_view.needed.shown;
      if (pictures.kept[pixel] - pictures.whole[pixel] <= most_steps_apart) continue;
      ++of_view.needed.pixels;
      of_view.sides.push_back(pictures.nearest[pixel]);
    }
  });
  Needed sum;
  for (const OfView& of_view : of_views) {
    sum.pixels += of_view.needed.pixels;
    sum.shown += of_view.needed.shown;
    for (const std::uint32_t number : of_view.sides) {
      const AllSides::Place place = all.place_of(number);
      Side& sides = kept[place.part][place.triangle];
      sides = static_cast<Side>(sides | place.side);
    }
  }
  return sum;
}

RayTree tree_of(std::span<const RasterPart> parts) {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<Blocks> blocks;
  for (const RasterPart& part : parts) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t index : part.indices) indices.push_back(base + index);
    const Blocks of_part = part.mask                ? Blocks::neither
                           : !part.culls_back_faces ? Blocks::both
                           : part.is_mirrored       ? Blocks::back
                                                    : Blocks::front;
    blocks.resize(indices.size() / 3, of_part);
  }
  return {positions, indices, blocks};
}

std::size_t add_needed_by_rays(const RayTree& tree, std::span<const RasterPart> parts, const SidesOfParts& wanted,
                               SidesOfParts& kept, const RayOptions& options, const Executor& executor) {
  std::vector<std::uint32_t> first{0};  // [part] its first triangle in the tree
  for (const RasterPart& part : parts) {
    first.push_back(first.back() + static_cast<std::uint32_t>(part.indices.size() / 3));
  }
  struct Question {
    std::size_t part, triangle;
    Side side;
  };
  std::vector<Question> questions;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    for (std::size_t triangle = 0; triangle < wanted[part].size(); ++triangle) {
      for (const Side side : {front, back}) {
        if ((wanted[part][triangle] & side) != 0) questions.push_back({part, triangle, side});
      }
    }
  }
  constexpr std::size_t at_once = 64;
  std::vector<std::uint8_t> is_seen(questions.size());
  executor.for_each((questions.size() + at_once - 1) / at_once, [&](std::size_t task) {
    const std::size_t end = std::min(questions.size(), (task + 1) * at_once);
    for (std::size_t q = task * at_once; q < end; ++q) {
      const auto& [part, triangle, side] = questions[q];
      const auto number = first[part] + static_cast<std::uint32_t>(triangle);
      is_seen[q] = is_seen_by_rays(tree, parts[part], triangle, number, side, options);
    }
  });
  std::size_t added = 0;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (is_seen[q] == 0) continue;
    Side& sides = kept[questions[q].part][questions[q].triangle];
    sides = static_cast<Side>(sides | questions[q].side);
    ++added;
  }
  return added;
}

}  // namespace foredraw::sides
