#include "seen_by_rays.h"

#include <foredraw/analysis/ray_samples.h>

#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw::processors::hidden {

namespace {

RayTree tree_of_sight(const Sight& sight) {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<Blocks> blocks;
  for (std::size_t p = 0; p < sight.parts.size(); ++p) {
    const RasterPart& part = sight.parts[p];
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t index : part.indices.first(part.indices.size() / 3 * 3)) indices.push_back(base + index);
    const Blocks of_part = sight.hides[p] == 0      ? Blocks::neither
                           : !part.culls_back_faces ? Blocks::both
                           : part.is_mirrored       ? Blocks::back
                                                    : Blocks::front;
    blocks.resize(indices.size() / 3, of_part);
  }
  return {positions, indices, blocks};
}

BoundingSphere sphere_of(const Sight& sight) {
  std::vector<DrawnPositions> drawn;
  for (const RasterPart& part : sight.parts) drawn.push_back({part.positions, part.indices});
  return bounding_sphere(drawn);
}

glm::dvec3 camera_in(std::span<const glm::dmat4> boxes, Random& random) {
  const glm::dmat4& box = boxes[random.below(boxes.size())];
  const double x = random.unit(), y = random.unit(), z = random.unit();
  return glm::dvec3(box * glm::dvec4(x, y, z, 1));
}

/// A triangle as rays leave it.
struct Facing {
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 normal;
  double size = 0;  ///< about the length of a side
  bool shows_back = false;

  Facing(const RasterPart& part, std::size_t triangle) : shows_back(!part.culls_back_faces) {
    for (std::size_t c = 0; c < 3; ++c) corners[c] = glm::dvec3(part.positions[part.indices[3 * triangle + c]]);
    normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (part.is_mirrored) normal = -normal;
    size = std::sqrt(std::sqrt(glm::dot(normal, normal)));
  }

  bool is_finite() const { return std::isfinite(size); }
  bool shows(const glm::dvec3& to) const { return shows_back || glm::dot(to, normal) >= 0; }
  double nearest(double length) const { return 1e-4 * size / length; }
};

/// Three directions at right angles, of any turn.
std::array<glm::dvec3, 3> any_axes(Random& random) {
  const auto unit = [](const glm::dvec3& v) { return v / std::sqrt(glm::dot(v, v)); };
  const glm::dvec3 x = unit(random_direction(random));
  for (;;) {
    const glm::dvec3 y = glm::cross(x, random_direction(random));
    if (glm::dot(y, y) < 0.001) continue;
    return {x, unit(y), glm::cross(x, unit(y))};
  }
}

std::uint32_t number_of(std::uint32_t number) { return number; }
std::uint32_t number_of(const WayOut& way) { return way.number; }

}  // namespace

/// The ways out that `ask` finds, flagged.
template <class Questions, class Ask>
std::vector<WayOut> Rays::found(const Questions& questions, const Ask& ask, Flags& seen,
                                const Executor& executor) const {
  constexpr std::size_t at_once = 64;
  std::vector<std::optional<glm::dvec3>> answers(questions.size());
  executor.for_each((questions.size() + at_once - 1) / at_once, [&](std::size_t task) {
    for (std::size_t q = task * at_once; q < std::min(questions.size(), (task + 1) * at_once); ++q) {
      answers[q] = ask(questions[q]);
    }
  });
  std::vector<WayOut> ways;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (!answers[q]) continue;
    ways.push_back({number_of(questions[q]), *answers[q]});
    seen[sight_.triangles[ways.back().number]] = 1;
  }
  return ways;
}

Rays::Rays(const Sight& sight) : sight_(sight), tree_(tree_of_sight(sight)), sphere_(sphere_of(sight)) {
  for (std::size_t p = 0; p < sight.parts.size(); ++p) {
    for (std::size_t t = 0; t < sight.parts[p].indices.size() / 3; ++t) places_.push_back({p, t});
  }
}

/// Outside lies beyond the sphere, where the ray may go on for as long as it likes.
bool Rays::gets_out(const RayTree::Ray& ray) const {
  const auto& ups = sight_.cameras.ups;
  if (!ups.empty()) {
    const glm::dvec3 from = ray.from - sphere_.centre;
    const double a = glm::dot(ray.direction, ray.direction), b = glm::dot(from, ray.direction);
    const double c = glm::dot(from, from) - sphere_.radius * sphere_.radius;
    const double way = (std::sqrt(std::max(0.0, b * b - a * c)) - b) / a;
    const glm::dvec3 leaves = from + way * ray.direction;
    const auto is_above = [&](const glm::dvec3& up) {
      return glm::dot(up, ray.direction) > 0 || glm::dot(up, leaves) >= 0;
    };
    if (std::ranges::none_of(ups, is_above)) return false;
  }
  return tree_.escapes(ray);
}

/// The camera stands where the ray's direction ends, and looks back.
bool Rays::gets_to_camera(const RayTree::Ray& ray) const {
  const auto hit = tree_.first({ray.from + ray.direction, -ray.direction, 0, ray.except});
  return !hit || hit->way >= 1 - ray.nearest;
}

std::optional<glm::dvec3> Rays::way_out(std::uint32_t number, const RayRange& rays) const {
  const Facing triangle(sight_.parts[places_[number].part], places_[number].triangle);
  if (!triangle.is_finite()) return glm::dvec3(0);
  if (!(triangle.size > 0)) return std::nullopt;
  Random random(derive_seed(rays.seed, number, rays.first));
  const Cameras& cameras = sight_.cameras;
  const bool is_inside = !cameras.boxes.empty();
  for (std::size_t i = 0; i < rays.count; ++i) {
    const glm::dvec3 from = random_point(triangle.corners, random);
    glm::dvec3 direction = is_inside ? camera_in(cameras.boxes, random) - from : random_direction(random);
    if (!triangle.shows(direction)) {
      if (is_inside) continue;
      direction = -direction;
    }
    const double length = std::sqrt(glm::dot(direction, direction));
    if (!(length > 0)) return direction;  // the camera is on it
    const RayTree::Ray ray{from, direction, triangle.nearest(length), number};
    if (is_inside ? gets_to_camera(ray) : gets_out(ray)) return direction;
  }
  return std::nullopt;
}

std::optional<glm::dvec3> Rays::way_out_along(const WayOut& way, std::uint64_t seed) const {
  constexpr int tries = 32;
  constexpr double aside = 0.03;  // of the way's length: some two degrees
  const Facing triangle(sight_.parts[places_[way.number].part], places_[way.number].triangle);
  const double length = std::sqrt(glm::dot(way.direction, way.direction));
  if (!triangle.is_finite() || !(triangle.size > 0) || !(length > 0)) return std::nullopt;
  Random random(derive_seed(seed, way.number, 0));
  for (int i = 0; i < tries; ++i) {
    const glm::dvec3 from = random_point(triangle.corners, random);
    const glm::dvec3 direction = way.direction + (i % 2 == 0 ? 0 : aside * length) * random_direction(random);
    if (!triangle.shows(direction)) continue;
    if (gets_out({from, direction, triangle.nearest(length), way.number})) return direction;
  }
  return std::nullopt;
}

std::vector<WayOut> Rays::add_seen(const RayRange& rays, const Flags& asked, Flags& seen,
                                   const Executor& executor) const {
  std::vector<std::uint32_t> questions;
  for (std::uint32_t number = 0; number < places_.size(); ++number) {
    if (asked[sight_.triangles[number]] != 0) questions.push_back(number);
  }
  return found(
      questions, [&](std::uint32_t number) { return way_out(number, rays); }, seen, executor);
}

std::vector<WayOut> Rays::add_seen_along(std::span<const WayOut> ways, std::uint64_t seed, Flags& seen,
                                         const Executor& executor) const {
  return found(
      ways, [&](const WayOut& way) { return way_out_along(way, seed); }, seen, executor);
}

Pixels Rays::add_seen_around(std::size_t places, int size, std::uint64_t seed, const Flags& asked, Flags& seen,
                             const Executor& executor) const {
  const std::vector<glm::dmat4>& boxes = sight_.cameras.boxes;
  std::vector<Pixels> pixels(6 * places);
  std::vector<std::vector<std::uint32_t>> found(6 * places);
  executor.for_each(6 * places, [&](std::size_t task) {
    Random random(derive_seed(seed, task / 6, 0));
    // Every box has its turn.
    const glm::dvec3 camera = camera_in(std::span(&boxes[task / 6 % boxes.size()], 1), random);
    std::array<glm::dvec3, 3> axes = any_axes(random);
    std::rotate(axes.begin(), axes.begin() + static_cast<std::ptrdiff_t>(task % 3), axes.end());
    const glm::dvec3 ahead = task % 6 < 3 ? axes[0] : -axes[0];
    for (int y = 0; y < size; ++y) {
      for (int x = 0; x < size; ++x) {
        const double right = (2 * x + 1.0) / size - 1, up = (2 * y + 1.0) / size - 1;
        const auto hit = tree_.first({camera, ahead + right * axes[1] + up * axes[2]});
        if (!hit) continue;
        ++pixels[task].shown;
        if (asked[sight_.triangles[hit->triangle]] == 0) continue;
        ++pixels[task].asked;
        found[task].push_back(hit->triangle);
      }
    }
  });
  Pixels sum;
  for (std::size_t task = 0; task < pixels.size(); ++task) {
    sum += pixels[task];
    for (const std::uint32_t number : found[task]) seen[sight_.triangles[number]] = 1;
  }
  return sum;
}

}  // namespace foredraw::processors::hidden
