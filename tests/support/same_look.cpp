#include "support/same_look.h"

#include <foredraw/base/random.h>
#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_directions.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>

namespace foredraw::testing {

namespace {

constexpr std::uint32_t nothing = ~std::uint32_t{0};

struct Picture {
  std::vector<std::uint32_t> depths, triangles;  // [pixel], the latter counted through the parts
};

Picture drawn_picture(std::span<const PreparedPart> parts, const View& view, int size) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  Picture picture{std::vector(pixels, nothing), std::vector(pixels, nothing)};
  Rasteriser rasteriser;
  for (const PreparedPart& part : parts) {
    rasteriser.draw(part, Camera(view, size), [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        if (some.depths[i] >= picture.depths[some.pixels[i]]) continue;
        picture.depths[some.pixels[i]] = some.depths[i];
        picture.triangles[some.pixels[i]] = some.triangles[i];
      }
    });
  }
  return picture;
}

/// A subject of a scene, in a pose.
class Posed {
 public:
  Posed(const Scene& scene, const Subject& subject, const Pose& pose, Analyses& analyses)
      : drawn_(subject_geometry(scene, subject, Faces::material,
                                subject.is_placed() ? posed_nodes(scene, pose) : PosedNodes(), analyses)),
        prepared_(prepared(drawn_.parts)) {
    for (std::size_t part = 0; part < drawn_.parts.size(); ++part) {
      first_.push_back(first_.back() + static_cast<std::uint32_t>(drawn_.parts[part].indices.size() / 3));
      const VertexStream* normals = scene.draws[subject.parts[part].draw].full().vertices->find("NORMAL");
      normals_.push_back(normals == nullptr ? std::vector<glm::vec3>() : decode_vec3(*normals));
    }
  }

  Picture picture(const View& view, int size) const { return drawn_picture(prepared_, view, size); }

  /// What a shader gets at the middle of a pixel that shows the triangle.
  glm::dvec3 normal(std::uint32_t number, std::size_t pixel, const Camera& camera) const {
    const auto part = static_cast<std::size_t>(std::ranges::upper_bound(first_, number) - first_.begin()) - 1;
    const RasterPart& drawn = drawn_.parts[part];
    if (normals_[part].empty()) return {};
    std::array<glm::dvec2, 3> at;
    std::array<glm::dvec3, 3> normals;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::uint32_t vertex = drawn.indices[3 * std::size_t{number - first_[part]} + c];
      const Corner corner = camera.project(prepared_[part].position(vertex));
      at[c] = {corner.x, corner.y};
      normals[c] = glm::dvec3(normals_[part][vertex]);
    }
    const auto size = static_cast<std::size_t>(camera.size());
    const glm::dvec2 middle = (glm::dvec2(pixel % size, pixel / size) + 0.5) * static_cast<double>(subpixels);
    const auto doubled = [](const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    };
    const double area = doubled(at[0], at[1], at[2]);
    const glm::dvec3 sum = doubled(middle, at[1], at[2]) / area * normals[0] +
                           doubled(at[0], middle, at[2]) / area * normals[1] +
                           doubled(at[0], at[1], middle) / area * normals[2];
    const bool shows_back = !drawn.culls_back_faces && (area < 0) != drawn.is_mirrored;
    return shows_back ? -sum : sum;
  }

 private:
  SubjectGeometry drawn_;
  std::vector<PreparedPart> prepared_;
  std::vector<std::uint32_t> first_{0};
  std::vector<std::vector<glm::vec3>> normals_;
};

}  // namespace

Looks compared(const Scene& before, const Scene& after, const LookOptions& options, const Executor& executor) {
  Analyses analyses;
  const std::vector<Subject> was = subjects_of(before), is = subjects_of(after);
  if (was.size() != is.size()) throw std::logic_error("the scenes have different subjects");
  const auto pictures = static_cast<std::size_t>(options.pictures);
  const Directions directions = random_directions(pictures, options.seed);
  const Poses keys = make_poses(before, {.poses = "all"});
  Random random(options.seed);
  Looks sum;
  for (std::size_t s = 0; s < was.size(); ++s) {
    std::vector<Pose> poses;
    for (std::size_t i = 0; i < pictures; ++i) poses.push_back(keys.poses[random.below(keys.poses.size())]);
    std::vector<Looks> looks(pictures);
    executor.for_each(pictures, [&](std::size_t i) {
      const Posed old(before, was[s], poses[i], analyses), now(after, is[s], poses[i], analyses);
      const View view{directions[i]};
      const Camera camera(view, options.size);
      const Picture a = old.picture(view, options.size), b = now.picture(view, options.size);
      for (std::size_t pixel = 0; pixel < a.depths.size(); ++pixel) {
        if (a.depths[pixel] == nothing) continue;
        ++looks[i].shown;
        if (b.depths[pixel] == nothing) {
          ++looks[i].lost;
        } else if (b.depths[pixel] - a.depths[pixel] > 64) {
          ++looks[i].moved;
        } else {
          const glm::dvec3 apart =
              old.normal(a.triangles[pixel], pixel, camera) - now.normal(b.triangles[pixel], pixel, camera);
          looks[i].coloured += glm::dot(apart, apart) > 1e-4;
        }
      }
    });
    for (const Looks& one : looks) {
      sum.shown += one.shown;
      sum.lost += one.lost;
      sum.moved += one.moved;
      sum.coloured += one.coloured;
    }
  }
  return sum;
}

}  // namespace foredraw::testing
