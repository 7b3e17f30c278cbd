// Meshes that become finer and coarser while they are drawn (runtime/progressive_mesh.h, runtime/selective_refine.h):
// how many splits a second, singly and in a jump; how long the way from 1 per cent of the triangles to all takes; and
// how often vertices are shaded in the order in which triangles come. Positions alone; vertices at one place are one.
// Times are of the processor, one thread, medians of eleven rounds.
//   progressive-mesh-bench FILES     tables of files (glTF, OBJ, PLY, ...), each as one mesh

#include "split_order.h"

#include <benchmarks/meshes/one_mesh.h>
#include <plugins/orderers/lookahead/lookahead.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <foredraw/analysis/vertex_cache.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numeric>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 11;

struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
};

Mesh mesh_of(const std::string& path) {
  WeldedMesh mesh = welded_mesh(read_joined(path));
  return {std::filesystem::path(path).stem().string(), std::move(mesh.positions), std::move(mesh.indices)};
}

/// The median of what the work took; `before` is not counted.
template <class Before, class Work>
double seconds_of(Before before, Work work) {
  std::array<double, rounds> times{};
  for (double& time : times) {
    before();
    const double begin = seconds();
    work();
    time = seconds() - begin;
  }
  std::ranges::sort(times);
  return times[rounds / 2];
}

double acmr(std::span<const std::uint32_t> indices, std::size_t vertices) {
  FifoCache cache(vertices, 16);
  return 3.0 * cache.misses(indices) / static_cast<double>(indices.size());
}

RefineRecords records_of(const Mesh& mesh) {
  const QuadricCollapseOptions options{.placement = CollapsePlacement::endpoint, .least = mesh.indices.size() / 300};
  return refine_records(quadric_collapse(mesh.positions, mesh.indices, options), mesh.positions, mesh.indices);
}

void time_splits(const std::string& name, RefineRecords records) {
  ProgressiveRecords& of = records.progressive;
  const std::size_t splits = of.splits.size() - 1;
  foredraw_progressive_mesh mesh{of.splits.data(),
                                 splits,
                                 of.patches.data(),
                                 of.indices.data(),
                                 static_cast<std::uint32_t>(of.vertex.size()),
                                 static_cast<std::uint32_t>(of.triangle.size()),
                                 splits};
  const auto go = [&](std::size_t to) { return [&mesh, to] { foredraw_progressive_go(&mesh, to); }; };
  const auto singly_up = [&] {
    for (std::size_t done = 1; done <= splits; ++done) foredraw_progressive_go(&mesh, done);
  };
  const auto singly_down = [&] {
    for (std::size_t done = splits; done-- > 0;) foredraw_progressive_go(&mesh, done);
  };
  const double jump = seconds_of(go(0), go(splits));
  const auto rate = [&](double time) { return static_cast<double>(splits) / time / 1e6; };
  const std::size_t bytes = of.splits.size() * sizeof(foredraw_split) + of.patches.size() * sizeof(foredraw_patch);
  fmt::print("| {} | {} | {} | {:.0f} / {:.0f} | {:.0f} / {:.0f} | {:.3f} | {:.1f} |\n", name, of.triangle.size(),
             splits, rate(seconds_of(go(0), singly_up)), rate(seconds_of(go(splits), singly_down)), rate(jump),
             rate(seconds_of(go(splits), go(0))), 1e3 * jump, static_cast<double>(bytes) / static_cast<double>(splits));
}

std::vector<std::uint32_t> in_cache_order(std::span<const std::uint32_t> indices, std::size_t vertices) {
  std::vector<std::uint32_t> ordered;
  for (const std::uint32_t t : lookahead(indices, vertices)) {
    const auto three = indices.subspan(std::size_t{3} * t, 3);
    ordered.insert(ordered.end(), three.begin(), three.end());
  }
  return ordered;
}

/// As if states between the ends of windows were never drawn, so that triangles need not come with their splits.
std::vector<std::uint32_t> in_windows(const RefineRecords& records, double window) {
  const ProgressiveRecords& of = records.progressive;
  std::vector<std::uint32_t> ordered;
  const auto add = [&](std::uint32_t end) {
    const auto more = std::span(of.indices).first(std::size_t{3} * end).subspan(ordered.size());
    const std::vector<std::uint32_t> next = in_cache_order(more, records.point.size());
    ordered.insert(ordered.end(), next.begin(), next.end());
  };
  add(of.splits.front().triangles);
  for (const std::uint32_t end : window_ends(records, window)) add(of.splits[end].triangles);
  return ordered;
}

void count_misses(const std::string& name, const RefineRecords& records) {
  const std::size_t vertices = records.point.size();
  const std::vector<std::uint32_t>& indices = records.progressive.indices;
  fmt::print("| {} | {:.3f} |", name, acmr(indices, vertices));
  for (const double window : {1.1, 1.2, 1.5, 2.0, 4.0, 1e9}) {
    fmt::print(" {:.3f} / {:.3f} |", acmr(indices_in(records, splits_by_place(records, window)), vertices),
               acmr(in_windows(records, window), vertices));
  }
  fmt::print(" {:.3f} |\n", acmr(in_cache_order(indices, vertices), vertices));
}

int everything(const void*, const foredraw_refine_mesh*, std::uint32_t) { return 1; }
int nothing(const void*, const foredraw_refine_mesh*, std::uint32_t) { return 0; }

/// A camera goes once around the mesh, in 360 frames, so near that a part of it is beside the picture.
void time_views(const std::string& name, const RefineRecords& records) {
  const foredraw_refine_mesh mesh = records.mesh();
  const foredraw_refine_arrays arrays = records.arrays();
  std::vector<std::uint32_t> memory(foredraw_refine_words(&mesh)), check(foredraw_refine_check_words(&mesh, &arrays));
  foredraw_refinement state;
  const auto settle = [&](foredraw_refine_wants wants) {
    while (foredraw_refine(&state, wants, nullptr, ~0u) > 0) {
    }
  };
  const auto begin = [&] { foredraw_refine_begin(&state, &mesh, memory.data()); };
  const double up = seconds_of(begin, [&] { settle(everything); });
  const double down = seconds_of([&] { settle(everything); }, [&] { settle(nothing); });
  const char* mistake = nullptr;
  const double checked = seconds_of([] {}, [&] { mistake = foredraw_refine_check(&mesh, &arrays, check.data()); });
  if (mistake != nullptr) throw std::runtime_error(name + ": " + mistake);

  float low[3] = {1e30f, 1e30f, 1e30f}, high[3] = {-1e30f, -1e30f, -1e30f};
  for (std::uint32_t s = 0; s < mesh.split_count; ++s) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], mesh.nodes[s].centre[k]);
      high[k] = std::max(high[k], mesh.nodes[s].centre[k]);
    }
  }
  const float radius = std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2;
  std::vector<double> times;
  std::uint64_t changed = 0, drawn = 0;
  const auto frame = [&](int number) {
    const float angle = static_cast<float>(number) * 0.0174532925f, side = 0.5f, forward = 0.8660254f;
    const float ahead[3] = {-std::sin(angle), 0, -std::cos(angle)}, right[3] = {std::cos(angle), 0, -std::sin(angle)};
    foredraw_refine_view view{};
    for (int k = 0; k < 3; ++k) {
      view.eye[k] = (low[k] + high[k]) / 2 - 1.3f * radius * ahead[k];
      for (int sign = 0; sign < 2; ++sign) {
        view.planes[sign][k] = side * ahead[k] + (sign == 0 ? forward : -forward) * right[k];
        view.planes[2 + sign][k] = side * ahead[k] + (k == 1 ? (sign == 0 ? forward : -forward) : 0.0f);
      }
    }
    for (auto& plane : view.planes) plane[3] = -foredraw_refine_dot(plane, view.eye);
    view.pixels = 540 / 0.5773503f;
    view.surface = 1;
    view.silhouette = 0.5f;
    return foredraw_refine(&state, foredraw_refine_view_wants, &view, ~0u);
  };
  begin();
  while (frame(0) > 0) {
  }
  for (int number = 1; number <= 360; ++number) {
    const double from = seconds();
    changed += frame(number);
    times.push_back(seconds() - from);
    drawn += state.triangles;
  }
  std::ranges::sort(times);
  const auto rate = [&](double time) { return mesh.split_count / time / 1e6; };
  const double bytes = static_cast<double>(records.nodes.size() * sizeof(foredraw_refine_node) +
                                           4 * (records.needs.size() + records.corners.size()));
  fmt::print("| {} | {} | {:.1f} / {:.1f} | {:.0f} % | {:.0f} | {:.2f} / {:.2f} | {:.0f} | {:.0f} | {:.1f} |\n", name,
             mesh.triangles, rate(up), rate(down), 100.0 / 360 * static_cast<double>(drawn) / mesh.triangles,
             static_cast<double>(changed) / 360, 1e3 * times[times.size() / 2], 1e3 * times.back(),
             bytes / mesh.split_count, 4.0 * static_cast<double>(memory.size()) / mesh.split_count, 1e3 * checked);
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::vector<std::pair<std::string, foredraw::RefineRecords>> all;
  for (int i = 1; i < argc; ++i) {
    const Mesh mesh = mesh_of(argv[i]);
    all.emplace_back(mesh.name, records_of(mesh));
  }
  fmt::print("| mesh | triangles | splits | singly, M/s: up / down | in a jump | 1 % to all, ms | bytes a split |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& [name, records] : all) time_splits(name, records);
  fmt::print(
      "\n| mesh | as it comes | 1.1 | 1.2 | 1.5 | 2 | 4 | all | lookahead "
      "|\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& [name, records] : all) count_misses(name, records);
  fmt::print(
      "\n| mesh | triangles | base to all / back, M/s | drawn | changes a frame | ms a frame: median / longest | "
      "bytes a split | of a state | check, ms |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& [name, records] : all) time_views(name, records);
  return 0;
}
