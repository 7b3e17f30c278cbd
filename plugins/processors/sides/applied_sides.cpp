#include "applied_sides.h"

#include "turned_vertices.h"

#include <algorithm>
#include <utility>

namespace foredraw::processors::sides {

namespace {

/// Triangles by their numbers, from a list with vertices of its own numbering.
IndexStream stream_of(const IndexStream& before, std::vector<std::uint32_t> indices,
                      std::span<const std::uint32_t> triangles) {
  IndexStream stream;
  stream.indices = Shared(std::move(indices));
  std::vector<std::uint32_t> origin;
  const auto of_file = before.triangle_origin.view();
  for (const std::uint32_t t : triangles) origin.push_back(of_file.empty() ? t : of_file[t]);
  stream.triangle_origin = Shared(std::move(origin));
  return stream;
}

}  // namespace

void make_single_sided(Scene& scene, DrawId id, std::span<const Side> wanted, SingleSidedMaterials& materials) {
  Draw& draw = scene.draws[id];
  Level& level = draw.full();
  SingleSided made = single_sided(level.stream().indices.view(), level.vertices->count, wanted);
  if (!made.copies.empty()) {
    const auto old = level.vertices;
    const auto vertices = processors::sides::with_turned_copies(*old, made.copies);
    for (Draw& other : scene.draws) {  // who shared the vertices shares them still: all keep their numbers
      for (Level& sharing : other.levels) {
        if (sharing.vertices == old) sharing.vertices = vertices;
      }
    }
    level.stream() = stream_of(level.stream(), std::move(made.indices), made.triangles);
  }
  draw.material = materials.of(*draw.material);
  draw.traits.remove(traits::double_sided);
}

void split(Scene& scene, DrawId id, std::span<const Side> wanted, const std::vector<bool>& stays,
           SingleSidedMaterials& materials) {
  const IndexStream stream = scene.draws[id].full().stream();
  std::vector<std::uint32_t> triangles[2], indices[2];
  std::vector<Side> wanted_of_rest;
  for (std::uint32_t t = 0; t < wanted.size(); ++t) {
    if (!stays[t]) wanted_of_rest.push_back(wanted[t]);
    triangles[stays[t]].push_back(t);
    for (std::size_t c = 0; c < 3; ++c) indices[stays[t]].push_back(stream.indices.view()[3 * std::size_t{t} + c]);
  }
  Draw two_sided = scene.draws[id];
  two_sided.full().stream() = stream_of(stream, std::move(indices[1]), triangles[1]);
  two_sided.name += " (both sides)";
  const auto added = static_cast<DrawId>(scene.draws.size());
  scene.draws.push_back(std::move(two_sided));
  for (Mesh& mesh : scene.meshes) {
    const auto at = std::ranges::find(mesh.draws, id);
    if (at != mesh.draws.end()) mesh.draws.insert(at + 1, added);
  }
  scene.draws[id].full().stream() = stream_of(stream, std::move(indices[0]), triangles[0]);
  make_single_sided(scene, id, wanted_of_rest, materials);
}

}  // namespace foredraw::processors::sides
