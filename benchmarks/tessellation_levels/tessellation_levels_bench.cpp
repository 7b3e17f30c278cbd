// How many triangles a displaced mesh needs for the same error: with levels by content, with levels by the length of
// edges, as powers of two and as any whole number, and with one level for all. Errors are deviations from the map in
// per cent of the diagonal, measured on the patterns that a tessellator makes. What one level for all needs lies
// between two whole levels and is interpolated, by logarithms. Beside it, for the levels by content: how far the
// surfaces lie apart.
//   tessellation-levels-bench MODEL MAP FACTOR RMS...   a map of heights, in units; errors in per cent
//   tessellation-levels-bench MODEL SEED FACTOR RMS...  a map of noise, 1024 x 1024, made from the seed

#include <benchmarks/timing.h>
#include <plugins/processors/displacement/displacement.h>
#include <plugins/processors/tessellation_levels/tessellation_levels.h>

#include <foredraw/analysis/surface_distance.h>
#include <foredraw/base/random.h>
#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/io/file_lender.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstring>
#include <stdexcept>

namespace foredraw::bench {
namespace {

/// Smooth noise of five octaves, of which most is flat: as maps of skin or rock have it.
Image noise(std::uint64_t seed) {
  constexpr std::uint32_t size = 1024;
  std::vector<double> heights(std::size_t{size} * size, 0);
  Random random(seed);
  for (std::uint32_t cells = 8, octave = 0; octave < 5; ++octave, cells *= 2) {
    std::vector<double> corners(std::size_t{cells} * cells);
    for (double& corner : corners) corner = static_cast<double>(random.below(65536)) / 65535;
    for (std::uint32_t y = 0; y < size; ++y) {
      for (std::uint32_t x = 0; x < size; ++x) {
        const double u = (x + 0.5) * cells / size, v = (y + 0.5) * cells / size;
        const auto i = static_cast<std::uint32_t>(u), j = static_cast<std::uint32_t>(v);
        const auto smooth = [](double t) { return t * t * (3 - 2 * t); };
        const auto at = [&](std::uint32_t a, std::uint32_t b) { return corners[b % cells * cells + a % cells]; };
        const double s = smooth(u - i), t = smooth(v - j);
        const double value =
            (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) + t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
        heights[std::size_t{y} * size + x] += value / (1u << octave);
      }
    }
  }
  std::vector<std::byte> bytes(2 * heights.size());
  for (std::size_t i = 0; i < heights.size(); ++i) {
    const double above = std::max(0.0, heights[i] / 1.9375 - 0.5);
    const auto height = static_cast<std::uint16_t>(std::lround(65535 * std::min(1.0, 4 * above * above * 4)));
    std::memcpy(&bytes[2 * i], &height, 2);
  }
  Image image{.name = "noise", .bytes = Shared(std::move(bytes))};
  image.is_texels = true;
  image.facts = {size, size, 1, 16};
  return image;
}

struct Displaced {
  Scene scene;
  std::vector<DrawId> draws;
  std::vector<LaidOutMap> maps;
  std::vector<std::vector<glm::vec3>> positions;
  std::vector<HeightPart> parts;
  double diagonal = 0;
};

Displaced displaced(const std::string& model, const std::string& map, float factor, Analyses& analyses) {
  Diagnostics diagnostics;
  auto file = read_scene(model, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  Displaced made{std::move(file->scene), {}, {}, {}, {}, 0};
  const bool is_seed = map.find_first_not_of("0123456789") == std::string::npos;
  const auto lent = is_seed ? std::nullopt : FileLender().image(map, diagnostics);
  if (!is_seed && !lent) throw std::runtime_error(to_text(diagnostics));
  made.scene.images.push_back(is_seed ? noise(std::stoull(map)) : *lent->content);
  for (DrawId id = 0; id < made.scene.draws.size(); ++id) made.draws.push_back(id);
  made.draws =
      displace(made.scene, made.draws, {.map = static_cast<ImageId>(made.scene.images.size() - 1), .factor = factor})
          .displaced;
  glm::dvec3 low(INFINITY), high(-INFINITY);
  for (const DrawId id : made.draws) {
    made.maps.push_back(std::get<LaidOutMap>(laid_out_map(made.scene, id, analyses)));
    made.positions.push_back(decode_vec3(*made.scene.draws[id].full().vertices->find("POSITION")));
    for (const glm::vec3& p : made.positions.back())
      low = glm::min(low, glm::dvec3(p)), high = glm::max(high, glm::dvec3(p));
  }
  for (std::size_t i = 0; i < made.draws.size(); ++i) {
    made.parts.push_back({made.positions[i], made.scene.draws[made.draws[i]].full().stream().indices.view(),
                          made.maps[i].places, made.maps[i].sampled(), factor});
  }
  made.diagonal = glm::length(high - low);
  return made;
}

struct Point {
  double triangles = 0, rms = 0, largest = 0;
};

/// Of levels that a function gives each edge; inside as the finest edge.
template <class OfEdge>
Point measured(const Displaced& mesh, const HeightDeviations& deviations, OfEdge of_edge) {
  std::vector<std::uint32_t> which;
  std::vector<WholeLevels> levels;
  Point point;
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    const auto indices = mesh.parts[p].indices;
    for (std::size_t t = 0; t < indices.size() / 3; ++t) {
      which.push_back(static_cast<std::uint32_t>(which.size()));
      WholeLevels& of = levels.emplace_back(WholeLevels{1, 1, 1, 1});
      TessellationLevels shown;
      for (std::size_t e = 0; e < 3; ++e) {
        const glm::dvec3 a(mesh.positions[p][indices[3 * t + (e + 1) % 3]]),
            b(mesh.positions[p][indices[3 * t + (e + 2) % 3]]);
        of[e] = of_edge(glm::length(a - b));
        of[3] = std::max(of[3], of[e]);
        shown.outer[e] = of[e];
      }
      shown.inner = of[3];
      point.triangles += tessellation_counts(shown, TessellationSpacing::equal).triangles;
    }
  }
  double squared = 0;
  for (const HeightDeviation& of : deviations.of(which, levels)) {
    squared += of.squared;
    point.largest = std::max(point.largest, of.largest * deviations.unit());
  }
  point.rms = std::sqrt(squared) * deviations.unit();
  return point;
}

/// Triangles at an error between two points, by logarithms; 0 beyond the last one.
double at_error(const std::vector<Point>& falling, double rms) {
  for (std::size_t i = 1; i < falling.size(); ++i) {
    const Point &a = falling[i - 1], &b = falling[i];
    if (!(b.rms <= rms && rms <= a.rms)) continue;
    const double part = (std::log(a.rms) - std::log(rms)) / (std::log(a.rms) - std::log(b.rms));
    return std::exp(std::log(a.triangles) + part * (std::log(b.triangles) - std::log(a.triangles)));
  }
  return 0;
}

std::vector<glm::vec3> shown(const Displaced& mesh, std::span<const TessellationLevels> levels, Analyses& analyses,
                             std::vector<std::uint32_t>& indices) {
  std::vector<glm::vec3> all;
  std::size_t first = 0;
  for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
    const HeightPart& part = mesh.parts[p];
    const auto of = levels.subspan(first, part.indices.size() / 3);
    first += of.size();
    const auto vertices = static_cast<std::uint32_t>(part.positions.size());
    const TessellatedMesh made = tessellated_mesh(part.indices, vertices, of, TessellationSpacing::equal);
    const auto by = displacements(made, part.indices, part.places, part.map, part.factor, 0);
    const auto directions = displacement_directions(mesh.scene, mesh.draws[p], analyses);
    for (const std::uint32_t i : made.indices) indices.push_back(static_cast<std::uint32_t>(all.size()) + i);
    const auto moved = displaced_positions(made, part.indices, part.positions, directions, by);
    all.insert(all.end(), moved.begin(), moved.end());
  }
  return all;
}

void print_distance(const Displaced& mesh, const ChosenLevels& chosen, Analyses& analyses, const Executor& executor) {
  std::vector<TessellationLevels> fine, ours;
  for (double texels = 1;; texels *= 2) {
    fine.clear();
    double triangles = 0;
    for (std::size_t p = 0; p < mesh.parts.size(); ++p) {
      const HeightPart& part = mesh.parts[p];
      for (const TessellationLevels& of : levels_by_texels(part.indices, part.positions, part.places, texels)) {
        fine.push_back(of);
        triangles += tessellation_counts(of, TessellationSpacing::equal).triangles;
      }
    }
    if (triangles < 2e6) break;
  }
  for (const LogLevels& of : chosen.levels) {
    const auto level = [&](std::size_t i) { return static_cast<float>(1u << of[i]); };
    ours.push_back({{level(0), level(1), level(2)}, level(3)});
  }
  std::vector<std::uint32_t> fine_indices, our_indices;
  const auto fine_at = shown(mesh, fine, analyses, fine_indices), ours_at = shown(mesh, ours, analyses, our_indices);
  const auto apart = surface_distance({fine_at, fine_indices}, {ours_at, our_indices}, {.samples = 100'000}, executor);
  fmt::print(" {:.5f} ±{:.5f} | {:.4f} |", 100 * apart->rms / mesh.diagonal, 100 * apart->rms_error / mesh.diagonal,
             100 * apart->largest / mesh.diagonal);
}

void run(const std::vector<std::string>& arguments) {
  const Executor executor;
  Analyses analyses(image_decoder(arguments[0]));
  const Displaced mesh = displaced(arguments[0], arguments[1], std::stof(arguments[2]), analyses);
  const HeightDeviations deviations(mesh.parts, executor);
  std::vector<Point> constant;
  fmt::print("| the same level for all | triangles | rms | largest |\n|---:|---:|---:|---:|\n");
  for (const std::uint8_t level : {1, 2, 3, 4, 6, 8, 12}) {
    constant.push_back(measured(mesh, deviations, [&](double) { return level; }));
    fmt::print("| {} | {:.0f} | {:.5f} | {:.4f} |\n", level, constant.back().triangles,
               100 * constant.back().rms / mesh.diagonal, 100 * constant.back().largest / mesh.diagonal);
  }
  std::vector<Point> by_length;
  for (double part = mesh.diagonal / 60; part > mesh.diagonal / 1200; part /= 1.25) {
    by_length.push_back(measured(mesh, deviations, [&](double length) {
      return static_cast<std::uint8_t>(std::clamp(std::ceil(length / part), 1.0, 64.0));
    }));
  }
  fmt::print(
      "\n| rms | by content | seconds | largest | surfaces apart, rms | largest | by edge length needs | in powers of "
      "two | one level for all needs |\n|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (std::size_t i = 3; i < arguments.size(); ++i) {
    const double rms = std::stod(arguments[i]) / 100 * mesh.diagonal;
    ChosenLevels content;
    const double seconds = seconds_of(
        [&] { content = tessellation_levels(mesh.parts, LevelMethod::content, {.error = rms}, Executor(1)); });
    const auto ours = static_cast<double>(content.chosen.triangles);
    fmt::print("| {:.5f} | {:.0f} | {:.2f} | {:.4f} |", 100 * content.chosen.rms / mesh.diagonal, ours, seconds,
               100 * content.chosen.largest / mesh.diagonal);
    print_distance(mesh, content, analyses, executor);
    const ChosenLevels powers = tessellation_levels(mesh.parts, LevelMethod::edge_length, {.error = rms}, executor);
    fmt::print(" {:.2f} x | {:.2f} x | {:.2f} x |\n", at_error(by_length, content.chosen.rms) / ours,
               static_cast<double>(powers.chosen.triangles) / ours, at_error(constant, content.chosen.rms) / ours);
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  if (count < 5) {
    fmt::print(stderr, "tessellation-levels-bench MODEL MAP|SEED FACTOR RMS...\n");
    return 2;
  }
  try {
    foredraw::bench::run({arguments + 1, arguments + count});
  } catch (const std::exception& wrong) {
    fmt::print(stderr, "{}\n", wrong.what());
    return 1;
  }
  return 0;
}
