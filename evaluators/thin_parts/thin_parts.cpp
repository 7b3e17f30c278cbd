#include "thin_parts.h"

#include <foredraw/analysis/closed_surfaces.h>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>

namespace foredraw {

namespace {

/// A surface that falls off more steeply, in depth for each step across, is taken for two.
constexpr double steepest = 8;

struct Direction {
  int right, up;
};
constexpr std::array directions = {Direction{1, 0}, Direction{0, 1}, Direction{1, 1}, Direction{1, -1}};

/// Samples of a picture, and how far away each is.
class Distances {
 public:
  Distances(std::span<const float> nearness, FrameSize size, double unit_a_sample)
      : width_(size.width), height_(size.height), unit_a_sample_(unit_a_sample) {
    for (const float near : nearness) values_.push_back(near > 0 ? 1 / static_cast<double>(near) : 0);
  }
  int width() const { return width_; }
  int height() const { return height_; }
  bool is_in(int x, int y) const { return x >= 0 && y >= 0 && x < width_ && y < height_; }
  double at(int x, int y) const { return values_[static_cast<std::size_t>(y * width_ + x)]; }

  /// Whether two neighbours show one surface.
  bool hang_together(double a, double b, double steps) const {
    return a > 0 && b > 0 && std::abs(a - b) <= steepest * steps * unit_a_sample_ * std::min(a, b);
  }

 private:
  int width_, height_;
  double unit_a_sample_;  // at distance 1
  std::vector<double> values_;
};

/// Shortens each sample's width to the run that it is part of, along one direction.
void shorten(const Distances& distances, const Direction& along, std::vector<float>& widths) {
  const double step = along.right != 0 && along.up != 0 ? std::sqrt(2.0) : 1;
  const auto place = [&](int x, int y) { return static_cast<std::size_t>(y * distances.width() + x); };
  for (int y = 0; y < distances.height(); ++y) {
    for (int x = 0; x < distances.width(); ++x) {
      const auto follows = [&](int column, int row) {
        return distances.is_in(column - along.right, row - along.up) &&
               distances.hang_together(distances.at(column - along.right, row - along.up), distances.at(column, row),
                                       step);
      };
      if (distances.at(x, y) == 0 || follows(x, y)) continue;  // only where a run begins
      int length = 1;
      while (distances.is_in(x + length * along.right, y + length * along.up) &&
             follows(x + length * along.right, y + length * along.up)) {
        ++length;
      }
      for (int i = 0; i < length; ++i) {
        float& width = widths[place(x + i * along.right, y + i * along.up)];
        width = std::min(width, static_cast<float>(length * step));
      }
    }
  }
}

double area_of(std::span<const glm::vec3> positions, const glm::dmat3& turn, std::span<const std::uint32_t> triangle) {
  const glm::dvec3 a(positions[triangle[0]]), b(positions[triangle[1]]), c(positions[triangle[2]]);
  const double doubled = glm::length(glm::cross(turn * (b - a), turn * (c - a)));
  return std::isfinite(doubled) ? doubled / 2 : 0;
}

/// All draws of a mesh as one.
struct WholeMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<bool> is_wire, is_closed;  // [triangle]

  explicit WholeMesh(const FrameMesh& mesh) {
    for (const FrameDraw& draw : mesh.draws) {
      const FrameLevel& level = draw.levels.front();
      const auto first = static_cast<std::uint32_t>(positions.size());
      positions.insert(positions.end(), level.positions->values.begin(), level.positions->values.end());
      for (std::size_t i = 0; i + 2 < level.indices.size(); i += 3) {
        bool all = !level.wires.empty(), any = false;
        for (const std::uint32_t v : level.indices.subspan(i, 3)) {
          indices.push_back(first + v);
          all = all && level.wires[v].w != 0;
          any = any || (!level.wires.empty() && level.wires[v].w > 0);
        }
        is_wire.push_back(all && any);
      }
    }
    is_closed = closed_outwards(positions, indices);
  }
};

}  // namespace

void SeenWidths::add(double pixels) {
  ++counts_[std::min(static_cast<std::size_t>(pixels * samples), counts_.size() - 1)];
}

void SeenWidths::add(const SeenWidths& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
}

double SeenWidths::seen() const { return std::accumulate(counts_.begin(), counts_.end(), 0.0); }

double SeenWidths::thinner_than(double pixels) const {
  const auto end = std::min(static_cast<std::size_t>(std::ceil(pixels * samples)), counts_.size());
  return std::accumulate(counts_.begin(), counts_.begin() + static_cast<std::ptrdiff_t>(end), 0.0);
}

double SeenWidths::width_of(double part) const {
  const double wanted = part * seen();
  double sum = 0;
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    sum += counts_[i];
    if (sum >= wanted) return static_cast<double>(i) / samples;
  }
  return most_pixels;
}

SeenWidths seen_widths(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera, FrameSize size) {
  std::vector<DrawnObject> objects;
  for (const SeenObject& seen : seen_objects(scene, moment, camera, size)) objects.push_back({seen.object});
  ReferenceRenderer renderer(size, SeenWidths::samples);
  renderer.draw(scene, moment, camera, objects, FrameStyle::objects);
  const FrameSize in_samples{size.width * SeenWidths::samples, size.height * SeenWidths::samples};
  const Distances distances(renderer.nearness(), in_samples, 2 * camera.half_height / in_samples.height);
  std::vector<float> widths(renderer.nearness().size(),
                            static_cast<float>(SeenWidths::most_pixels * SeenWidths::samples));
  for (const Direction& along : directions) shorten(distances, along, widths);
  SeenWidths found;
  for (std::size_t i = 0; i < widths.size(); ++i) {
    if (renderer.nearness()[i] > 0) found.add(static_cast<double>(widths[i]) / SeenWidths::samples);
  }
  return found;
}

SurfaceShares surface_shares(const FrameScene& scene, const FrameMoment& moment) {
  SurfaceShares shares;
  std::map<MeshId, WholeMesh> meshes;
  for (std::size_t object = 0; object < scene.objects().size(); ++object) {
    const auto found = meshes.try_emplace(scene.objects()[object].mesh, scene.mesh_of(object)).first;
    const WholeMesh& mesh = found->second;
    const glm::dmat3 turn(moment.world[object]);
    for (std::size_t t = 0; t < mesh.is_wire.size(); ++t) {
      const double area = area_of(mesh.positions, turn, std::span(mesh.indices).subspan(3 * t, 3));
      shares.area += area;
      if (mesh.is_closed[t]) shares.closed += area;
      if (mesh.is_wire[t]) shares.wires += area;
    }
  }
  return shares;
}

}  // namespace foredraw
