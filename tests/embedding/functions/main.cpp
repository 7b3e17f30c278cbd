// Makes the index buffer of an engine's own mesh cheaper to draw: first for the vertex cache, then for overdraw.

#include <plugins/clusterers/linear_clusters/linear_clusters.h>
#include <plugins/orderers/dot_rule/dot_rule.h>
#include <plugins/orderers/tipsify/tipsify.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory_resource>
#include <utility>
#include <vector>

#if defined(__cpp_exceptions) || defined(__cpp_rtti)
#error "compiled with exceptions or RTTI: this would prove little"
#endif

namespace {

struct Vertex {  // interleaved, and of nobody's types but the engine's
  std::uint32_t colour;
  float position[3];
  std::uint16_t uv[2];
};

struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<std::uint32_t> indices;
};

/// A box of `cells` x `cells` squares a side that faces outwards, its triangles in a bad order.
void add_box(Mesh& mesh, float half, std::uint32_t cells) {
  const auto first_triangle = mesh.indices.size() / 3;
  for (int side = 0; side < 6; ++side) {
    const int axis = side / 2;
    const float sign = side % 2 == 0 ? 1.0f : -1.0f;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (std::uint32_t i = 0; i <= cells; ++i) {
      for (std::uint32_t j = 0; j <= cells; ++j) {
        Vertex vertex{};
        vertex.position[axis] = sign * half;
        vertex.position[(axis + 1) % 3] = (2.0f * static_cast<float>(i) / static_cast<float>(cells) - 1) * half * sign;
        vertex.position[(axis + 2) % 3] = (2.0f * static_cast<float>(j) / static_cast<float>(cells) - 1) * half;
        mesh.vertices.push_back(vertex);
      }
    }
    for (std::uint32_t i = 0; i < cells; ++i) {
      for (std::uint32_t j = 0; j < cells; ++j) {
        const std::uint32_t a = first + i * (cells + 1) + j;
        const std::uint32_t b = a + cells + 1;
        mesh.indices.insert(mesh.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
      }
    }
  }
  const auto triangles = mesh.indices.size() / 3 - first_triangle;
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::size_t other = t * 7919 % triangles;
    for (std::size_t k = 0; k < 3; ++k) {
      std::swap(mesh.indices[3 * (first_triangle + t) + k], mesh.indices[3 * (first_triangle + other) + k]);
    }
  }
}

double misses_per_triangle(const Mesh& mesh, std::size_t cache_size) {
  std::vector<std::uint32_t> cache;
  std::size_t misses = 0;
  for (std::uint32_t v : mesh.indices) {
    bool hit = false;
    for (std::size_t i = cache.size() > cache_size ? cache.size() - cache_size : 0; i < cache.size(); ++i) {
      hit = hit || cache[i] == v;
    }
    if (hit) continue;
    cache.push_back(v);
    ++misses;
  }
  return static_cast<double>(misses) / (static_cast<double>(mesh.indices.size()) / 3);
}

}  // namespace

int main() {
  Mesh mesh;
  add_box(mesh, 1, 24);
  add_box(mesh, 3, 24);  // hides the first from every side, and comes after it
  const double before = misses_per_triangle(mesh, 16);
  std::printf("misses per triangle: %.3f\n", before);

  // 1. For the vertex cache, in memory of the engine's own: order[new] = old triangle.
  std::vector<std::byte> frame_memory(1 << 20);
  std::pmr::monotonic_buffer_resource arena(frame_memory.data(), frame_memory.size(), std::pmr::null_memory_resource());
  std::vector<std::uint32_t> order(mesh.indices.size() / 3);
  foredraw::tipsify(order, mesh.indices, mesh.vertices.size(), {.cache_size = 16}, arena);
  std::vector<std::uint32_t> reordered;
  for (std::uint32_t old : order) {
    reordered.insert(reordered.end(), mesh.indices.begin() + 3 * old, mesh.indices.begin() + 3 * old + 3);
  }
  mesh.indices = std::move(reordered);
  const double cached = misses_per_triangle(mesh, 16);
  std::printf("after tipsify:       %.3f\n", cached);

  // 2. For overdraw: patches that may be drawn in any sequence, those that face outwards first. Positions are read from
  // the interleaved buffer as they lie there.
  const foredraw::Clusters clusters = foredraw::linear_clusters(mesh.indices, mesh.vertices.size(), 16);
  const foredraw::Strided<glm::vec3> positions(mesh.vertices[0].position, mesh.vertices.size(), sizeof(Vertex));
  std::vector<std::uint32_t> sorted;
  for (std::uint32_t cluster : foredraw::dot_rule(positions, mesh.indices, clusters)) {
    sorted.insert(sorted.end(), mesh.indices.begin() + 3 * clusters.offsets[cluster],
                  mesh.indices.begin() + 3 * clusters.offsets[cluster + 1]);
  }
  const bool whole = sorted.size() == mesh.indices.size();
  mesh.indices = std::move(sorted);
  const double clustered = misses_per_triangle(mesh, 16);
  const std::size_t first_of_outer = mesh.vertices.size() / 2;
  const bool outer_first = mesh.indices[0] >= first_of_outer && mesh.indices.back() < first_of_outer;
  std::printf("after dot_rule:      %.3f, %zu clusters, %s box first\n", clustered, clusters.count(),
              outer_first ? "the outer" : "the inner");

  return whole && outer_first && cached < 0.5 * before && clustered < 1.1 * cached ? 0 : 1;
}
