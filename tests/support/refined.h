#pragma once
// A mesh with arrays for selective_refine.h and a state of them, and what should be drawn then.

#include "support/collapses.h"

#include <foredraw/collapses/collapse_recorder.h>
#include <foredraw/collapses/refine_records.h>

#include <gtest/gtest.h>

#include <array>
#include <numeric>

namespace foredraw::testing {

/// Random edges, whose ends are in no other one of the same round, until no edge may go: so that splits hang together
/// in few steps, as they do where a simplifier made them.
inline CollapseSequence collapses_of(const TestMesh& mesh, std::uint64_t seed, bool keeps_topology = true) {
  CollapseRecorder recorder(mesh.positions, mesh.indices);
  Random random(seed);
  double error = 0;
  for (bool has_changed = true; has_changed;) {
    has_changed = false;
    std::vector<bool> is_touched(mesh.positions.size(), false);
    std::vector<std::uint32_t> corners(3 * recorder.points().size());
    std::iota(corners.begin(), corners.end(), 0u);
    for (std::size_t i = corners.size(); i > 1; --i) std::swap(corners[i - 1], corners[random.below(i)]);
    for (const std::uint32_t corner : corners) {
      const CollapseRecorder::Corners& points = recorder.points()[corner / 3];
      const std::uint32_t p = points[corner % 3], q = points[(corner + 1) % 3];
      if (p == q || is_touched[p] || is_touched[q] || recorder.triangles_of_edge(p, q) == 0) continue;
      if (keeps_topology && !recorder.keeps_topology(p, q)) continue;
      if (!recorder.pairs_up(p, q)) continue;
      recorder.collapse(p, q, {.blend = 0, .error = error += 1, .place = {}});
      is_touched[p] = is_touched[q] = has_changed = true;
    }
  }
  return recorder.take();
}

inline std::vector<TestMesh> surfaces() {
  return {closed_torus(14, 9), flat_ring(20, 4), moebius_strip(30), box_of_sides(4), sphere(16, 10), grid(9, 7)};
}

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A mesh with a state, and what should be drawn.
struct Refined {
  explicit Refined(const TestMesh& of, std::uint64_t seed = 1, bool keeps_topology = true)
      : mesh(of),
        sequence(collapses_of(of, seed, keeps_topology)),
        records(refine_records(sequence, mesh.positions, mesh.indices)),
        arrays(records.mesh()),
        memory(foredraw_refine_words(&arrays)) {
    begin();
  }

  void begin() { foredraw_refine_begin(&state, &arrays, memory.data()); }
  std::uint32_t splits() const { return arrays.split_count; }
  bool is_done(std::uint32_t split) const { return foredraw_refine_is_done(&state, split) != 0; }

  /// Runs frames until nothing changes.
  template <class Wants>
  void settle(Wants wants, std::uint32_t most = ~0u) {
    const auto call = [](const void* context, const foredraw_refine_mesh*, std::uint32_t split) -> int {
      return (*static_cast<const Wants*>(context))(split);
    };
    int frames = 0;
    while (foredraw_refine(&state, call, &wants, most) > 0) ASSERT_LT(++frames, 10000);
  }

  Triangles drawn() const {
    Triangles triangles;
    for (std::uint32_t i = 0; i < 3 * state.triangles; i += 3) {
      triangles.push_back({state.indices[i], state.indices[i + 1], state.indices[i + 2]});
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  /// Full detail, each corner at the vertex that stands for it. By the sequence alone.
  Triangles expected() const {
    const auto collapses = static_cast<std::uint32_t>(sequence.collapses.size());
    std::vector<std::uint32_t> stands(mesh.positions.size()), point = records.point, full = records.progressive.indices;
    std::iota(stands.begin(), stands.end(), 0u);
    for (std::uint32_t c = collapses; c-- > 0;) {
      if (is_done(collapses - 1 - c)) continue;
      for (std::uint32_t i = sequence.first_pair[c]; i < sequence.first_pair[c + 1]; ++i) {
        stands[sequence.pairs[i].removed] = stands[sequence.pairs[i].kept];
      }
    }
    std::vector<std::uint32_t> number(mesh.positions.size());
    for (std::uint32_t v = 0; v < point.size(); ++v) number[records.progressive.vertex[v]] = v;
    Triangles triangles;
    for (std::size_t i = 0; i < full.size(); i += 3) {
      std::array<std::uint32_t, 3> three{};
      for (std::size_t k = 0; k < 3; ++k) three[k] = number[stands[records.progressive.vertex[full[i + k]]]];
      const bool has_area = point[three[0]] != point[three[1]] && point[three[1]] != point[three[2]] &&
                            point[three[2]] != point[three[0]];
      if (has_area) triangles.push_back(three);
    }
    std::ranges::sort(triangles);
    return triangles;
  }

  TestMesh surface() const {
    TestMesh left;
    for (const std::uint32_t v : records.progressive.vertex) left.positions.push_back(mesh.positions[v]);
    left.indices.assign(state.indices, state.indices + std::size_t{3} * state.triangles);
    return left;
  }

  TestMesh mesh;
  CollapseSequence sequence;
  RefineRecords records;
  foredraw_refine_mesh arrays;
  std::vector<std::uint32_t> memory;
  foredraw_refinement state{};
};

}  // namespace foredraw::testing
