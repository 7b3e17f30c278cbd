#include "content_parts.h"

#include <foredraw/instances/merged_instances.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

namespace foredraw::bench {

namespace {

/// A primitive with the vertices that it uses, and no others.
struct UsedMesh {
  std::vector<std::uint32_t> vertices;  ///< [number here] = number in the primitive's streams
  std::vector<std::uint32_t> indices;   ///< into `vertices`
};

UsedMesh used_mesh(const Draw& draw) {
  UsedMesh mesh;
  std::vector<std::uint32_t> number(draw.levels[0].vertices->count, ~std::uint32_t{0});
  for (const std::uint32_t index : draw.levels[0].orders[0].indices.view()) {
    if (number[index] == ~std::uint32_t{0}) {
      number[index] = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back(index);
    }
    mesh.indices.push_back(number[index]);
  }
  return mesh;
}

using Vector = std::array<float, 3>;

Vector cross(const float* a, const float* b) {
  return {a[1] * b[2] - b[1] * a[2], a[2] * b[0] - b[2] * a[0], a[0] * b[1] - b[0] * a[1]};
}
float dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vector position_in_world(const MergedTransform& m, const Vector& p) {
  const auto row = [&](std::size_t r) {
    return m[4 * r] * p[0] + m[4 * r + 1] * p[1] + m[4 * r + 2] * p[2] + m[4 * r + 3];
  };
  return {row(0), row(1), row(2)};
}

/// By the cofactors, as the shaders do it: its length is not kept.
Vector normal_in_world(const MergedTransform& m, const Vector& n) {
  const Vector a = cross(&m[4], &m[8]);
  const Vector turned{dot(a, n), dot(cross(&m[8], &m[0]), n), dot(cross(&m[0], &m[4]), n)};
  return dot({m[0], m[1], m[2]}, a) < 0 ? Vector{-turned[0], -turned[1], -turned[2]} : turned;
}

/// One instance's vertices, appended to the bytes of one stream.
void add_vertices(const VertexStream& stream, const UsedMesh& mesh, const MergedTransform& world,
                  std::vector<std::byte>& to) {
  const std::size_t size = stream.format.bytes;
  const bool is_position = stream.semantic == "POSITION", is_normal = stream.semantic == "NORMAL";
  for (const std::uint32_t vertex : mesh.vertices) {
    const std::size_t at = to.size();
    to.resize(at + size);
    const std::byte* from = stream.bytes.view().data() + vertex * size;
    if (is_position || is_normal) {  // floats, or the pipeline would not take them
      Vector v;
      std::memcpy(v.data(), from, sizeof(v));
      v = is_position ? position_in_world(world, v) : normal_in_world(world, v);
      std::memcpy(to.data() + at, v.data(), sizeof(v));
    } else {
      std::memcpy(to.data() + at, from, size);
    }
  }
}

/// The streams of one set as they grow.
struct Growing {
  const VertexStreams* like = nullptr;
  std::vector<std::vector<std::byte>> bytes;
  std::uint32_t count = 0;

  void add(const Draw& draw, const UsedMesh& mesh, const MergedTransform& world) {
    const VertexStreams& streams = *draw.levels[0].vertices;
    if (like == nullptr) like = &streams;
    bytes.resize(streams.base.size());
    for (std::size_t s = 0; s < streams.base.size(); ++s) add_vertices(streams.base[s], mesh, world, bytes[s]);
    count += static_cast<std::uint32_t>(mesh.vertices.size());
  }

  std::shared_ptr<const VertexStreams> taken() {
    VertexStreams made;
    made.count = count;
    for (std::size_t s = 0; s < bytes.size(); ++s) {
      made.base.push_back({like->base[s].semantic, like->base[s].format, Shared(std::move(bytes[s]))});
    }
    return std::make_shared<const VertexStreams>(std::move(made));
  }
};

}  // namespace

void add_duplicated_parts(const Scene& scene, std::span<const PlacedDraw> placed, std::uint64_t most_bytes,
                          FrameContent& content) {
  std::map<DrawId, UsedMesh> meshes;
  for (const MergedInstances& merged : merged_sets(scene)) {
    for (const MergedMesh& mesh : merged.meshes) meshes.try_emplace(mesh.draw, used_mesh(scene.draws[mesh.draw]));
  }
  const auto found = [&](const MergedPlace& place) -> const PlacedDraw& {
    return *std::ranges::lower_bound(placed, place, {}, &PlacedDraw::place);
  };
  FrameBytes& bytes = content.bytes;
  for (const MergedInstances& merged : merged_sets(scene)) {
    // Vertices of several materials each have to say theirs.
    const std::size_t material_bytes = looks_differ(scene, merged.materials.view()) ? sizeof(std::uint32_t) : 0;
    for (const MergedPlace& place : merged.places.view()) {
      const PlacedDraw& one = found(place);
      const UsedMesh& mesh = meshes.at(one.draw);
      const std::size_t vertex_bytes = scene.draws[one.draw].levels[0].vertices->bytes_per_vertex() + material_bytes;
      bytes.vertices += mesh.vertices.size() * vertex_bytes;
      bytes.indices += mesh.indices.size() * sizeof(std::uint32_t);
    }
  }
  content.is_complete = bytes.vertices + bytes.indices <= most_bytes;

  for (const MergedInstances& merged : merged_sets(scene)) {
    FramePart part;
    part.fetch = VertexFetch::in_world;
    Growing vertices;
    std::uint64_t first_index = 0;
    for (const MergedGroup& group : merged.groups) {
      DirectCall call;
      call.command.first_index = static_cast<std::uint32_t>(first_index);
      for (std::uint32_t i = group.first_instance; i < group.first_instance + group.instance_count; ++i) {
        const PlacedDraw& one = found(merged.places.view()[i]);
        const UsedMesh& mesh = meshes.at(one.draw);
        content.sequence.push_back(one.place);
        call.command.index_count += static_cast<std::uint32_t>(mesh.indices.size());
        first_index += mesh.indices.size();
        if (!content.is_complete) continue;
        const auto number = static_cast<std::uint32_t>(part.places.size());
        part.places.push_back(hash_of(one.place));
        part.materials.push_back(look_of(scene, one.draw));
        part.instances.insert(part.instances.end(), mesh.vertices.size(), number);
        for (std::size_t corner = 0; corner < mesh.indices.size(); ++corner) {
          // One front face for all: what is mirrored winds the other way.
          static constexpr std::size_t exchanged[] = {0, 2, 1};
          const std::size_t from = one.is_mirrored ? corner - corner % 3 + exchanged[corner % 3] : corner;
          part.indices.push_back(vertices.count + mesh.indices[from]);
        }
        vertices.add(scene.draws[one.draw], mesh, rows_of(one.world));
      }
      if (call.command.index_count > 0) part.direct.push_back(call);
    }
    part.vertices = vertices.taken();
    content.parts.push_back(std::move(part));
  }
}

}  // namespace foredraw::bench
