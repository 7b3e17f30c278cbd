// The order of a scene's triangles and vertices, told in the numbers of the file that the scene came from.
#include <foredraw/io/mesh/private/source.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>

namespace foredraw::mesh_files {

namespace {

bool same_nodes(const Scene& a, const Scene& b) {
  return std::ranges::equal(a.nodes, b.nodes, [](const Node& x, const Node& y) {
    return x.name == y.name && x.mesh == y.mesh && x.matrix == y.matrix && x.children == y.children &&
           x.transform.translation == y.transform.translation && x.transform.rotation == y.transform.rotation &&
           x.transform.scale == y.transform.scale;
  });
}

/// What a file of polygons holds besides draws.
bool same_surroundings(const Scene& a, const Scene& b) {
  return same_nodes(a, b) && a.skins.empty() && a.animations.empty() && a.images.size() == b.images.size() &&
         std::ranges::equal(a.meshes, b.meshes,
                            [](const Mesh& x, const Mesh& y) {
                              return x.name == y.name && std::ranges::is_permutation(x.draws, y.draws);
                            }) &&
         std::ranges::equal(a.materials, b.materials, [](const Material& x, const Material& y) {
           return x.name == y.name && x.alpha_mode == y.alpha_mode && x.double_sided == y.double_sided;
         });
}

/// A draw beside what it was when it was read.
class DrawChange {
 public:
  DrawChange(const Draw& now, const Draw& was) : now_(now.full()), was_(was.full()) {
    alike_ = now.levels.size() == 1 && now_.orders.size() == 1 && now.topology == was.topology &&
             now.material == was.material;
  }

  bool is_order_alone() const { return alike_ && same_triangles() && same_vertices(); }
  bool moved_vertices() const { return !now_.vertex_destination.empty(); }

  std::uint32_t triangle(std::size_t place) const {
    const auto origin = now_.orders[0].triangle_origin.view();
    return origin.empty() ? static_cast<std::uint32_t>(place) : origin[place];
  }
  std::uint32_t destination(std::size_t vertex) const {
    const auto moved = now_.vertex_destination.view();
    return moved.empty() ? static_cast<std::uint32_t>(vertex) : moved[vertex];
  }
  std::size_t triangles() const { return was_.orders[0].triangle_count(); }
  std::size_t vertices() const { return was_.vertices->count; }

 private:
  bool same_triangles() const {
    const auto now = now_.orders[0].indices.view();
    const auto was = was_.orders[0].indices.view();
    const auto origin = now_.orders[0].triangle_origin.view();
    if (now.size() != was.size() || (!origin.empty() && 3 * origin.size() != was.size())) return false;
    for (std::size_t i = 0; i < now.size(); ++i) {
      const std::size_t from = origin.empty() ? i : 3 * std::size_t{origin[i / 3]} + i % 3;
      if (from >= was.size()) return false;  // a triangle that comes from none of them
      if (now[i] != destination(was[from])) return false;
    }
    return true;
  }

  bool same_vertices() const {
    const VertexStreams& now = *now_.vertices;
    const VertexStreams& was = *was_.vertices;
    if (!now.morph_targets.empty() || now.base.size() != was.base.size()) return false;
    if (!moved_vertices() && now.count != was.count) return false;
    for (std::size_t s = 0; s < now.base.size(); ++s) {
      const VertexStream& a = now.base[s];
      const VertexStream& b = was.base[s];
      if (a.semantic != b.semantic || a.format != b.format) return false;
      for (std::size_t v = 0; v < was.count; ++v) {
        const std::uint32_t to = destination(v);
        if (to == no_vertex) continue;
        if (to >= now.count || std::memcmp(a.bytes.view().data() + std::size_t{to} * a.format.bytes,
                                           b.bytes.view().data() + v * b.format.bytes, b.format.bytes) != 0) {
          return false;
        }
      }
    }
    return true;
  }

  const Level& now_;
  const Level& was_;
  bool alike_ = false;
};

/// Ranks given in the sequence of the asking.
class Ranks {
 public:
  explicit Ranks(std::size_t count) : ranks_(count, none) {}

  void use(std::uint32_t record) {
    if (record < ranks_.size() && ranks_[record] == none) ranks_[record] = next_++;
  }

  std::vector<std::uint32_t> finished() && {
    for (std::uint32_t& rank : ranks_) {
      if (rank == none) rank = next_++;
    }
    return std::move(ranks_);
  }

 private:
  std::vector<std::uint32_t> ranks_;
  std::uint32_t next_ = 0;
};

class OrderMaking {
 public:
  OrderMaking(const Scene& scene, const MeshSource& source, const RecordCounts& counts, Diagnostics& diagnostics)
      : scene_(scene),
        source_(source),
        diagnostics_(diagnostics),
        positions_(counts.positions),
        texcoords_(counts.texcoords),
        normals_(counts.normals),
        is_placed_(counts.faces, false) {
    order_.faces.resize(counts.faces);
    std::iota(order_.faces.begin(), order_.faces.end(), 0u);
  }

  std::optional<MeshOrder> run() {
    bool moved_vertices = false;
    for (std::size_t d = 0; d < scene_.draws.size(); ++d) {
      const DrawChange change(scene_.draws[d], source_.as_read.draws[d]);
      if (!change.is_order_alone()) return std::nullopt;
      if (scene_.draws[d].topology == Topology::triangles) faces(change, source_.records[d].faces);
      vertices(change, source_.records[d].vertices);
      moved_vertices = moved_vertices || change.moved_vertices();
    }
    if (moved_vertices) {
      order_.positions = std::move(positions_).finished();
      order_.texcoords = std::move(texcoords_).finished();
      order_.normals = std::move(normals_).finished();
    }
    order_.moved = moved_vertices || !std::ranges::is_sorted(order_.faces);
    tell();
    return std::move(order_);
  }

 private:
  /// The draw's faces, in the sequence of their first triangles, go to the places that the draw's faces had.
  void faces(const DrawChange& change, const std::vector<std::uint32_t>& of_triangles) {
    std::vector<std::uint32_t> places = of_triangles;  // rising, the triangles of a face side by side
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::size_t next = 0;
    std::uint32_t last = none;
    for (std::size_t t = 0; t < change.triangles(); ++t) {
      const std::uint32_t face = of_triangles[change.triangle(t)];
      if (is_placed_[face] && face != last) ++torn_;
      last = face;
      if (is_placed_[face]) continue;
      is_placed_[face] = true;
      order_.faces[places[next++]] = face;
    }
  }

  void vertices(const DrawChange& change, const std::vector<Corner>& records) {
    std::vector<std::uint32_t> by_place;
    for (std::uint32_t v = 0; v < change.vertices(); ++v) {
      if (change.destination(v) == no_vertex) {
        ++kept_;
      } else {
        by_place.push_back(v);
      }
    }
    std::ranges::stable_sort(by_place, {}, [&](std::uint32_t v) { return change.destination(v); });
    std::uint32_t last = none;
    for (std::uint32_t v : by_place) {
      if (change.destination(v) == last) ++kept_;
      last = change.destination(v);
      const Corner corner = records.empty() ? Corner{v, none, none} : records[v];
      positions_.use(corner.position);
      texcoords_.use(corner.texcoord);
      normals_.use(corner.normal);
    }
  }

  void tell() const {
    const Where where{.file = source_.as_read.name};
    if (torn_ > 0) {
      diagnostics_.note(
          where, "polygons-stay-whole",
          fmt::format("polygons stay whole in the file: {} triangles move with the first triangle of their polygon",
                      torn_),
          "write a .glb to keep the triangles' own order");
    }
    if (!std::ranges::equal(scene_.meshes, source_.as_read.meshes, {}, &Mesh::draws, &Mesh::draws)) {
      diagnostics_.note(where, "sequence-stays", "the file keeps its sequence of draws",
                        "write a .glb for the new one");
    }
    if (kept_ > 0) {
      diagnostics_.note(where, "vertices-stay",
                        fmt::format("{} vertices that were merged or left out stay in the file", kept_),
                        "write a .glb to leave them out");
    }
  }

  const Scene& scene_;
  const MeshSource& source_;
  Diagnostics& diagnostics_;
  MeshOrder order_;
  Ranks positions_, texcoords_, normals_;
  std::vector<bool> is_placed_;  // [face]
  std::size_t torn_ = 0, kept_ = 0;
};

}  // namespace

std::optional<MeshOrder> order_of(const Scene& scene, const MeshSource& source, const RecordCounts& counts,
                                  Diagnostics& diagnostics) {
  std::optional<MeshOrder> order;
  if (scene.draws.size() == source.as_read.draws.size() && same_surroundings(scene, source.as_read)) {
    order = OrderMaking(scene, source, counts, diagnostics).run();
  }
  if (order) return order;
  diagnostics.error(
      {.file = scene.name}, "other-triangles",
      fmt::format("more than the order of triangles and vertices was changed; {} can hold only a new order",
                  extension_of(source.kind)),
      "give the output the extension .glb");
  return std::nullopt;
}

}  // namespace foredraw::mesh_files
