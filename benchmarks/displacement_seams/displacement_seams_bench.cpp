// displacement-seams-bench MAP MODEL...: every draw of the models with the map laid on it, at the map's size and at
// halves of it down to 512 texels. Times are those of one thread, without decoding, medians of seven.

#include "evaluators/seam_gap/seam_gap.h"
#include "plugins/processors/displacement_seams/displacement_seams.h"
#include "timing.h"

#include <foredraw/displaced/height_map.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

namespace foredraw::bench {
namespace {

HeightMap map_at(const std::string& path) {
  Diagnostics diagnostics;
  const auto bytes = read_file(path, diagnostics);
  const auto texels = bytes ? decode_image(*bytes, {path}, diagnostics) : std::nullopt;
  if (!texels) throw std::runtime_error(to_text(diagnostics));
  return height_map(*texels);
}

/// Each texel the mean of four.
HeightMap halved(const HeightMap& map) {
  HeightMap half{map.width / 2, map.height / 2, {}};
  for (std::size_t y = 0; y < half.height; ++y) {
    for (std::size_t x = 0; x < half.width; ++x) {
      const std::uint16_t* at = &map.texels[2 * y * map.width + 2 * x];
      half.texels.push_back(static_cast<std::uint16_t>((at[0] + at[1] + at[map.width] + at[map.width + 1] + 2u) / 4));
    }
  }
  return half;
}

struct LaidOut {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec2> uvs;
  std::vector<std::uint32_t> indices;

  SeamEdges seams() const { return seam_edges(std::array{UvMesh{positions, uvs, indices}}); }
};

std::vector<LaidOut> draws_of(const std::string& path) {
  Diagnostics diagnostics;
  const auto file = read_scene(path, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  std::vector<LaidOut> draws;
  for (const Draw& draw : file->scene.draws) {
    const VertexStreams& vertices = *draw.full().vertices;
    if (draw.topology != Topology::triangles || vertices.find("TEXCOORD_0") == nullptr) continue;
    const auto indices = draw.full().stream().indices.view();
    LaidOut laid_out{draw.name, decode_vec3(*vertices.find("POSITION")), {}, {indices.begin(), indices.end()}};
    for (const glm::vec3& uv : decode_vec3(*vertices.find("TEXCOORD_0"))) laid_out.uvs.emplace_back(uv);
    draws.push_back(std::move(laid_out));
  }
  return draws;
}

void print_row(const LaidOut& draw, const HeightMap& map, const std::string& method, const RepairedMap* repaired,
               double seconds) {
  HeightMap now = map;
  if (repaired != nullptr && !repaired->texels.empty()) now.texels = repaired->texels;
  const SeamGap gap = seam_gap(draw.seams(), sampled(now, {}));
  const double edges = std::max(1.0, static_cast<double>(gap.edges));
  const std::size_t texels = repaired != nullptr ? repaired->seam_texels.size() : 0;
  fmt::print("| {} | {} | {} | {} | {} of {} | {:.2f} | {:.5f} / {:.6f} | {:.3f} | {:.3f} |\n", draw.name, map.width,
             method, gap.edges, gap.unequal, gap.points, 100 * static_cast<double>(gap.below) / edges, gap.largest,
             std::sqrt(gap.squares / std::max(1.0, static_cast<double>(gap.samples))),
             100 * static_cast<double>(texels) / static_cast<double>(now.texels.size()), seconds);
  std::fflush(stdout);
}

void measure(const LaidOut& draw, const HeightMap& map) {
  print_row(draw, map, "as it came", nullptr, 0);
  struct Method {
    const char* name;
    DisplacementSeamsOptions options;
  };
  for (const Method& method :
       {Method{"averaged once", {.method = SeamMethod::average, .iterations = 1}},
        Method{"averaged x20", {.method = SeamMethod::average, .iterations = 20}},
        Method{"averaged x100", {.method = SeamMethod::average, .iterations = 100}}, Method{"**exact**", {}}}) {
    std::vector<double> times;
    RepairedMap repaired;
    for (int round = 0; round < 7; ++round) {
      times.push_back(
          seconds_of([&] { repaired = displacement_seams(draw.seams(), sampled(map, {}), method.options); }));
    }
    print_row(draw, map, method.name, &repaired, median(times));
  }
}

void run(int count, char** arguments) {
  if (count < 3) throw std::runtime_error("usage: displacement-seams-bench MAP MODEL...");
  std::vector<HeightMap> maps{map_at(arguments[1])};
  while (std::min(maps.back().width, maps.back().height) >= 1024) maps.push_back(halved(maps.back()));
  fmt::print(
      "| draw | map | method | seam edges | unequal points | edges below the rule, % | largest / rms gap, of the "
      "range | texels changed, % | seconds |\n|---|---:|---|---:|---:|---:|---:|---:|---:|\n");
  for (int m = 2; m < count; ++m) {
    for (const LaidOut& draw : draws_of(arguments[m])) {
      if (draw.seams().seams == 0) continue;
      for (const HeightMap& map : maps) measure(draw, map);
    }
  }
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** arguments) {
  try {
    foredraw::bench::run(count, arguments);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
  return 0;
}
