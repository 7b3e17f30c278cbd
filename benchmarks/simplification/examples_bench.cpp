// The three uses of progressive meshes that Hoppe 1996 shows (section 5 and figure captions there): a scan of two
// million triangles comes down to 7,500; a picture of 200 x 200 colours on a plate to 400 vertices, with colours
// counted and without; and sharp edges of a machine part stay sharp. Needs no file.
//   examples-bench

#include <benchmarks/meshes/one_mesh.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <foredraw/analysis/farthest_distance.h>
#include <foredraw/analysis/surface_distance.h>
#include <foredraw/collapses/attribute_walk.h>
#include <foredraw/collapses/replay.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <chrono>
#include <numbers>

namespace foredraw::bench {
namespace {

/// (u, v) to a place, for columns x rows quads; `columns` are closed where `is_closed`.
template <class Of>
WeldedMesh grid(std::uint32_t columns, std::uint32_t rows, bool is_closed, const Of& of) {
  WeldedMesh mesh;
  const std::uint32_t across = is_closed ? columns : columns + 1;
  for (std::uint32_t j = 0; j <= rows; ++j) {
    for (std::uint32_t i = 0; i < across; ++i) {
      mesh.positions.push_back(of(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
    }
  }
  for (std::uint32_t j = 0; j < rows; ++j) {
    for (std::uint32_t i = 0; i < columns; ++i) {
      const std::uint32_t a = j * across + i, b = j * across + (i + 1) % across, c = b + across, d = a + across;
      mesh.indices.insert(mesh.indices.end(), {a, b, c, a, c, d});
    }
  }
  return mesh;
}

/// A vase with relief at three scales, as a scanner sees it: what is small is noise.
glm::vec3 scanned(double u, double v) {
  const double a = 2 * std::numbers::pi * u, h = 3 * v;
  const double radius = 1 + 0.3 * std::sin(2.1 * h) + 0.03 * std::sin(9 * a + 4 * h) * std::sin(11 * h) +
                        0.004 * std::sin(61 * a - 37 * h) * std::cos(53 * h) + 0.00005 * std::sin(7919 * a + 6101 * h);
  return {radius * std::cos(a), radius * std::sin(a), h};
}

double wall_seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void show_scan(const Executor& executor) {
  const WeldedMesh scan = grid(1250, 800, true, scanned);
  CollapseSequence sequence;
  const double seconds = wall_seconds(
      [&] { sequence = quadric_collapse(scan.positions, scan.indices, {.least = 7500, .executor = &executor}); });
  const Collapsed left = collapsed(sequence, sequence.collapses.size(), scan.positions, scan.indices);
  const Surface before{scan.positions, scan.indices}, after{left.places, left.indices};
  const ClosestPoints to_before(before), to_after(after);
  const double diagonal = 4.2;  // 2.6 x 2.6 x 3, but for the relief
  const double rms = surface_distance(before, after, {200'000, 1}, executor)->rms;
  const double largest = hausdorff_distance({before, to_before}, {after, to_after}, {}, executor)->bound;
  fmt::print("scan: {} triangles, {} left, {:.1f} s on {} threads; rms {:.4f} % of the diagonal, at most {:.4f} %\n",
             scan.triangles(), left.indices.size() / 3, seconds, executor.threads(), 100 * rms / diagonal,
             100 * largest / diagonal);
}

/// Rings, a slope and a sharp disc: what is smooth and what is not.
glm::dvec3 colour_at(double x, double y) {
  const double from_middle = std::hypot(x - 0.5, y - 0.5);
  const bool is_disc = std::hypot(x - 0.3, y - 0.7) < 0.15;
  return is_disc ? glm::dvec3(0.9, 0.1, 0.1)
                 : glm::dvec3(0.5 + 0.4 * std::sin(18 * from_middle), x, 0.5 + 0.5 * y - 0.3 * x);
}

/// Rms over the plate, of colours from 0 to 1.
double colour_error(std::span<const glm::vec3> places, std::span<const std::uint32_t> indices,
                    const std::vector<float>& colours) {
  constexpr int size = 500;
  double sum = 0;
  std::vector<std::uint8_t> is_done(size * size, 0);
  std::size_t count = 0;
  for (std::size_t t = 0; t + 2 < indices.size(); t += 3) {
    const glm::dvec3 a(places[indices[t]]), b(places[indices[t + 1]]), c(places[indices[t + 2]]);
    const auto cross = [](const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r) {
      return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const double area = cross(a, b, c);
    if (area == 0) continue;
    const int low = std::max(0, static_cast<int>(std::min({a.y, b.y, c.y}) * size - 1));
    const int high = std::min(size - 1, static_cast<int>(std::max({a.y, b.y, c.y}) * size + 1));
    const int left = std::max(0, static_cast<int>(std::min({a.x, b.x, c.x}) * size - 1));
    const int right = std::min(size - 1, static_cast<int>(std::max({a.x, b.x, c.x}) * size + 1));
    for (int y = low; y <= high; ++y) {
      for (int x = left; x <= right; ++x) {
        const glm::dvec3 p((x + 0.5) / size, (y + 0.5) / size, 0);
        const double of_a = cross(p, b, c) / area, of_b = cross(a, p, c) / area, of_c = 1 - of_a - of_b;
        if (std::min({of_a, of_b, of_c}) < 0 || is_done[y * size + x]) continue;
        is_done[y * size + x] = 1;
        ++count;
        const glm::dvec3 want = colour_at(p.x, p.y);
        for (int k = 0; k < 3; ++k) {
          const double is = of_a * colours[3 * indices[t] + k] + of_b * colours[3 * indices[t + 1] + k] +
                            of_c * colours[3 * indices[t + 2] + k];
          sum += (is - want[k]) * (is - want[k]) / 3;
        }
      }
    }
  }
  return std::sqrt(sum / static_cast<double>(count));
}

void show_picture() {
  const WeldedMesh plate = grid(199, 199, false, [](double u, double v) { return glm::vec3(u, v, 0); });
  std::vector<float> colours;
  for (const glm::vec3& at : plate.positions) {
    for (int k = 0; k < 3; ++k) colours.push_back(static_cast<float>(colour_at(at.x, at.y)[k]));
  }
  const double weight = AttributeWeights{}.colors * std::numbers::sqrt2;  // of the plate's diagonal
  fmt::print("picture: 200 x 200 colours on a plate, 400 vertices left; rms of colours at all {:.4f}",
             colour_error(plate.positions, plate.indices, colours));
  for (const bool is_counted : {false, true}) {
    AttributeRows rows{is_counted ? std::size_t{3} : 0, {}};
    for (const float colour : colours) {
      if (is_counted) rows.values.push_back(static_cast<float>(weight * colour));
    }
    const CollapseSequence sequence = quadric_collapse(plate.positions, plate.indices, {}, rows);
    const std::size_t collapses = std::min(sequence.collapses.size(), plate.positions.size() - 400);
    const Collapsed left = collapsed(sequence, collapses, plate.positions, plate.indices);
    std::vector<float> now = colours;
    AttributeWalk walk(sequence, plate.positions, plate.indices);
    for (std::size_t i = 0; i < collapses; ++i) {
      for (const JoinedVertex& joined : walk.next()) {
        for (std::uint32_t k = 0; k < 3; ++k) {
          float& kept = now[3 * joined.vertex + k];
          if (!joined.shares.empty()) {
            kept = static_cast<float>(shared_number(std::span<const WedgeShare>(joined.shares),
                                                    [&](std::uint32_t v) { return double{now[3 * v + k]}; }));
          } else if (joined.stands_for_another()) {
            kept += (now[3 * joined.removed + k] - kept) * sequence.collapses[i].blend;
          }
        }
      }
    }
    fmt::print("; {} {:.4f}", is_counted ? "with colours counted" : "by distances alone",
               colour_error(left.places, left.indices, now));
  }
  fmt::print("\n");
}

/// A gear: flanks, bores and rims meet in sharp edges.
WeldedMesh gear() {
  return grid(480, 160, true, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, tooth = std::fmod(12 * u, 1.0);
    const double outer = tooth < 0.5 ? 1.0 : 0.8;
    // Four walls in turn, 40 rows each: outer, top, bore, bottom.
    const double wall = 4 * v, along = wall - std::floor(std::min(wall, 3.0));
    const auto at = [&](double radius, double z) { return glm::vec3(radius * std::cos(a), radius * std::sin(a), z); };
    if (wall < 1) return at(outer, 0.4 * along);
    if (wall < 2) return at(outer + (0.3 - outer) * along, 0.4);
    if (wall < 3) return at(0.3, 0.4 - 0.4 * along);
    return at(0.3 + (outer - 0.3) * along, 0);
  });
}

/// Length of the edges between triangles that stand at more than 60 degrees.
double sharp_length(std::span<const glm::vec3> places, std::span<const std::uint32_t> indices) {
  std::vector<std::array<std::uint32_t, 3>> edges;  // low point, high point, triangle
  const auto normal = [&](std::uint32_t t) {
    const glm::dvec3 a(places[indices[3 * t]]);
    const glm::dvec3 n =
        glm::cross(glm::dvec3(places[indices[3 * t + 1]]) - a, glm::dvec3(places[indices[3 * t + 2]]) - a);
    const double length = glm::length(n);
    return length > 0 ? n / length : n;
  };
  for (std::uint32_t t = 0; 3 * t < indices.size(); ++t) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax(indices[3 * t + k], indices[3 * t + (k + 1) % 3]);
      edges.push_back({low, high, t});
    }
  }
  std::ranges::sort(edges);
  double sum = 0;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    if (edges[i][0] != edges[i + 1][0] || edges[i][1] != edges[i + 1][1]) continue;
    if (glm::dot(normal(edges[i][2]), normal(edges[i + 1][2])) < 0.5) {
      sum += glm::distance(places[edges[i][0]], places[edges[i][1]]);
    }
  }
  return sum;
}

void show_sharp_edges(const Executor& executor) {
  const WeldedMesh part = gear();
  const Surface before{part.positions, part.indices};
  const ClosestPoints to_before(before);
  const double sharp = sharp_length(part.positions, part.indices);
  fmt::print("sharp edges: a gear of {} triangles, edges of more than 60 degrees {:.2f} long\n", part.triangles(),
             sharp);
  for (const std::size_t least : {10000, 2500, 1000}) {
    const CollapseSequence sequence = quadric_collapse(part.positions, part.indices, {.least = least});
    const Collapsed left = collapsed(sequence, sequence.collapses.size(), part.positions, part.indices);
    const Surface after{left.places, left.indices};
    const ClosestPoints to_after(after);
    fmt::print("  {} triangles: {:.2f} long, surface at most {:.5f} away\n", left.indices.size() / 3,
               sharp_length(left.places, left.indices),
               hausdorff_distance({before, to_before}, {after, to_after}, {}, executor)->bound);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main() {
  const foredraw::Executor executor;
  foredraw::bench::show_scan(executor);
  foredraw::bench::show_picture();
  foredraw::bench::show_sharp_edges(executor);
  return 0;
}
