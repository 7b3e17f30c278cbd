#pragma once
// What tests of occlusion-order look at.

#include "plugins/orderers/occlusion_order/k_orders.h"

#include "support/overdraw.h"
#include "support/painter.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/overdraw/cluster_layers.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <numeric>

namespace foredraw::testing {

inline std::vector<std::uint32_t> rising(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

inline bool is_permutation_of(std::vector<std::uint32_t> order, std::size_t count) {
  std::ranges::sort(order);
  return order == rising(count);
}

/// Spheres in one another, the innermost drawn first: the worst order there is.
inline TestMesh shells(int count) {
  TestMesh all = sphere(32, 16);
  for (int i = 2; i <= count; ++i) all = joined(all, sphere(32, 16, static_cast<float>(i)));
  return all;
}

/// Random triangles that hide one another, no two of them equally near.
inline TestMesh thicket(std::uint64_t seed) {
  Random random(seed);
  TestMesh mesh;
  for (std::uint32_t corner = 0; corner < 3 * 60; ++corner) {
    mesh.indices.push_back(corner);
    const auto coordinate = [&] { return static_cast<float>(random.unit()); };
    mesh.positions.push_back(glm::vec3{coordinate(), coordinate(), coordinate()});
  }
  return mesh;
}

/// A mesh as views see it.
struct Seen {
  TestMesh mesh;
  SubjectLayers subject;

  Seen(const TestMesh& shape, const Views& views, const Clusters& clusters = {}) : mesh(shape) {
    const Executor executor(2);
    const RasterPart part{mesh.positions, mesh.indices};
    const Clusters atoms =
        clusters.count() > 0 ? clusters : cut_atoms(mesh.indices, mesh.positions.size(), 16, {4, 12});
    static_cast<Layers&>(subject.layers) =
        cluster_layers(fragment_layers({&part, 1}, views, executor).value(), atoms, executor);
    for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) subject.owners.push_back({0, 0, atom});
    for (const View& view : views.views) {
      subject.directions.push_back(view.direction);
      subject.weights.push_back(view.weight);
    }
    subject.draws.push_back({mesh.indices, mesh.positions.size(), atoms});
  }
  Seen(const Seen&) = delete;

  double excess(const std::vector<std::uint32_t>& atoms) const { return excess_of(counts_of(subject, {&atoms, 1})); }

  static double excess_of(std::span<const OverdrawCount> counts) {
    OverdrawCount sum;
    for (const OverdrawCount& count : counts) sum += count;
    return static_cast<double>(sum.shaded) / static_cast<double>(sum.visible) - 1;
  }

  std::vector<std::uint32_t> indices(const std::vector<std::uint32_t>& atoms) const {
    const Clusters& all = subject.draws[0].atoms;
    std::vector<std::uint32_t> result;
    for (const std::uint32_t atom : atoms) {
      const auto from = mesh.indices.begin();
      result.insert(result.end(), from + 3 * all.offsets[atom], from + 3 * all.offsets[atom + 1]);
    }
    return result;
  }

  double acmr(const std::vector<std::uint32_t>& atoms) const {
    const CacheCount count = count_fifo(indices(atoms), mesh.positions.size(), 16);
    return static_cast<double>(count.misses) / static_cast<double>(count.triangles);
  }
};

inline TestMesh for_the_cache(const TestMesh& mesh) {
  TestMesh result = mesh;
  meshopt_optimizeVertexCacheFifo(result.indices.data(), mesh.indices.data(), mesh.indices.size(),
                                  mesh.positions.size(), 16);
  return result;
}

/// A shape that hides itself from all sides: rings through one another.
inline TestMesh rings() {
  TestMesh all = torus(60, 24);
  TestMesh turned = torus(60, 24);
  for (glm::vec3& p : turned.positions) p = {p.y, p.z, p.x};
  all = joined(all, turned);
  for (glm::vec3& p : turned.positions) p = {p.y, p.z, p.x};
  return for_the_cache(joined(all, turned));
}

/// What drawing the pieces in this order costs, but for what it costs in any order; straight from the definition.
inline std::int64_t cost_of(const Occlusions& occlusions, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> place(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
  std::int64_t cost = 0;
  for (std::uint32_t p = 0; p < occlusions.pieces; ++p) {
    for (std::uint32_t i = occlusions.first_pair[p]; i < occlusions.first_pair[p + 1]; ++i) {
      const auto& [other, net] = occlusions.pairs[i];
      if (p < other && place[other] < place[p]) cost += net;  // each pair stands in two rows
    }
  }
  for (std::size_t l = 0; l < occlusions.weights.size(); ++l) {
    std::uint32_t earliest = ~std::uint32_t{0};
    for (std::uint32_t i = occlusions.first_layer[l]; i < occlusions.first_layer[l + 1]; ++i) {
      const std::uint32_t at = place[occlusions.layers[i]];
      if (at > earliest) continue;
      earliest = at;
      cost += occlusions.weights[l];
    }
  }
  return cost;
}

inline std::vector<WeightedLayers> unweighted(const Layers& layers) {
  std::vector<WeightedLayers> views;
  for (const ViewLayers& view : layers.views) views.push_back({&view, 1});
  return views;
}

}  // namespace foredraw::testing
