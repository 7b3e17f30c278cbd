// A polygon mesh to a scene: faces cut into triangles, corners made vertices, parts made draws.
#include <foredraw/image/found_traits.h>
#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>
#include <foredraw/scene/triangle_draw.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <numeric>
#include <unordered_map>

namespace foredraw::mesh_files {

namespace {

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t h = corner.position * 0x9E3779B97F4A7C15u;
    h = (h ^ (h >> 29) ^ corner.texcoord) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 32) ^ corner.normal) * 0x94D049BB133111EBu;
    return h ^ (h >> 31);
  }
};

/// One draw being made: the faces of a part that have the same attributes.
struct DrawMaking {
  std::uint32_t part = 0;
  bool has_texcoords = false;
  bool has_normals = false;
  std::vector<std::uint32_t> indices = {};
  DrawRecords records = {};
  std::unordered_map<Corner, std::uint32_t, CornerHash> numbers = {};

  /// The vertex of a corner; a new one where the corner has not been seen.
  std::uint32_t vertex(Corner corner) {
    if (!has_texcoords) corner.texcoord = none;
    if (!has_normals) corner.normal = none;
    const auto [found, is_new] = numbers.try_emplace(corner, static_cast<std::uint32_t>(records.vertices.size()));
    if (is_new) records.vertices.push_back(corner);
    return found->second;
  }
};

class SceneMaking {
 public:
  SceneMaking(const PolygonMesh& mesh, const std::string& name, Diagnostics& diagnostics)
      : mesh_(mesh), name_(name), diagnostics_(diagnostics) {}

  bool run(std::vector<Material> materials) {
    made.scene.name = name_;
    made.scene.materials = std::move(materials);
    if (!collect()) return false;
    for (DrawMaking& making : makings_) add(making);
    name_draws();
    find_traits(made.scene);
    return true;
  }

  MeshScene made;

 private:
  bool refuse(std::string message) {
    diagnostics_.error({.file = name_}, "empty-mesh", std::move(message));
    return false;
  }

  bool collect() {
    if (mesh_.positions.empty()) return refuse("the file holds no vertices");
    if (mesh_.face_count() == 0) {
      cloud();
      return true;
    }
    Triangulator triangulator(mesh_.corners.size());
    std::vector<glm::vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::size_t too_small = 0;
    for (std::uint32_t f = 0; f < mesh_.face_count(); ++f) {
      const auto corners = mesh_.face(f);
      if (corners.size() < 3) {
        ++too_small;
        continue;
      }
      points.clear();
      triangles.clear();
      for (const Corner& corner : corners) points.push_back(mesh_.positions[corner.position]);
      triangulator.cut(points, triangles);
      DrawMaking& making = making_of(f, corners);
      for (const auto& triangle : triangles) {
        for (std::uint32_t i : triangle) {
          making.indices.push_back(mesh_.whole_vertices ? corners[i].position : making.vertex(corners[i]));
        }
        making.records.faces.push_back(f);
      }
    }
    const auto say = [&](std::size_t count, const char* code, std::string message) {
      if (count > 0) diagnostics_.warning({.file = name_}, code, std::move(message));
    };
    say(too_small, "faces-left-out", fmt::format("{} faces have fewer than three corners and are left out", too_small));
    say(triangulator.earless(), "polygons-as-fans",
        fmt::format("{} polygons cross themselves or have no area; they are triangulated as fans, wholly or in part",
                    triangulator.earless()));
    say(triangulator.unfinished(), "polygons-unfinished",
        fmt::format("{} polygons are triangulated as fans, wholly or in part, because the file has too many concave "
                    "polygons with very many corners",
                    triangulator.unfinished()));
    return !makings_.empty() || refuse("none of the file's faces has three corners");
  }

  void cloud() {
    DrawMaking& making = makings_.emplace_back();
    making.indices.resize(mesh_.positions.size());
    std::iota(making.indices.begin(), making.indices.end(), 0u);
    if (!mesh_.whole_vertices) {
      for (std::uint32_t i : making.indices) making.records.vertices.push_back({i, none, none});
    }
  }

  DrawMaking& making_of(std::uint32_t face, std::span<const Corner> corners) {
    const auto all_have = [&](std::uint32_t Corner::*record) {
      return std::all_of(corners.begin(), corners.end(), [&](const Corner& c) { return c.*record != none; });
    };
    const std::uint32_t part = mesh_.part.empty() ? 0 : mesh_.part[face];
    const bool texcoords = all_have(&Corner::texcoord), normals = all_have(&Corner::normal);
    const auto [found, is_new] = numbers_.try_emplace({part, texcoords, normals}, makings_.size());
    if (is_new) makings_.push_back({part, texcoords, normals});
    return makings_[found->second];
  }

  /// One stream of a draw: the record that `record` names, for each vertex.
  template <class T>
  VertexStream gathered(const char* semantic, const std::vector<T>& values, const DrawMaking& making,
                        std::uint32_t Corner::*record) const {
    if (mesh_.whole_vertices) return float_stream(semantic, values);
    std::vector<T> rows;
    rows.reserve(making.records.vertices.size());
    for (const Corner& corner : making.records.vertices) rows.push_back(values[corner.*record]);
    return float_stream(semantic, rows);
  }

  VertexStream colors(const DrawMaking& making) const {
    if (mesh_.whole_vertices) return {"COLOR_0", mesh_.color_format, Shared<std::byte>(mesh_.colors)};
    const std::size_t size = mesh_.color_format.bytes;
    std::vector<std::byte> rows;
    rows.reserve(making.records.vertices.size() * size);
    for (const Corner& corner : making.records.vertices) {
      const auto row = mesh_.colors.begin() + static_cast<std::ptrdiff_t>(corner.position * size);
      rows.insert(rows.end(), row, row + static_cast<std::ptrdiff_t>(size));
    }
    return {"COLOR_0", mesh_.color_format, Shared<std::byte>(std::move(rows))};
  }

  void add(DrawMaking& making) {
    const bool whole = mesh_.whole_vertices;
    const bool is_cloud = mesh_.face_count() == 0;
    VertexStreams streams;
    streams.count = static_cast<std::uint32_t>(whole ? mesh_.positions.size() : making.records.vertices.size());
    streams.base.push_back(gathered("POSITION", mesh_.positions, making, &Corner::position));
    const bool normals = making.has_normals || (is_cloud && whole && !mesh_.normals.empty());
    const bool texcoords = making.has_texcoords || (is_cloud && whole && !mesh_.texcoords.empty());
    if (normals) streams.base.push_back(gathered("NORMAL", mesh_.normals, making, &Corner::normal));
    if (texcoords) streams.base.push_back(gathered("TEXCOORD_0", mesh_.texcoords, making, &Corner::texcoord));
    if (!mesh_.colors.empty()) streams.base.push_back(colors(making));

    Draw draw;
    draw.topology = is_cloud ? Topology::points : Topology::triangles;
    Level level;
    level.vertices = std::make_shared<const VertexStreams>(std::move(streams));
    IndexStream order;
    order.indices = Shared<std::uint32_t>(std::move(making.indices));
    level.orders.push_back(std::move(order));
    draw.levels.push_back(std::move(level));
    draw.material = material_of(mesh_.parts[making.part].material);

    Mesh& mesh = mesh_of(mesh_.parts[making.part].object);
    draw.origin = DrawOrigin{static_cast<std::uint32_t>(&mesh - made.scene.meshes.data()),
                             static_cast<std::uint32_t>(mesh.draws.size())};
    mesh.draws.push_back(static_cast<DrawId>(made.scene.draws.size()));
    made.scene.draws.push_back(std::move(draw));
    made.draws.push_back(std::move(making.records));
  }

  std::optional<MaterialId> material_of(const std::string& name) {
    if (name.empty()) return std::nullopt;
    auto& materials = made.scene.materials;
    if (material_numbers_.empty()) {
      for (std::size_t i = 0; i < materials.size(); ++i) material_numbers_.try_emplace(materials[i].name, i);
    }
    const auto [found, is_new] = material_numbers_.try_emplace(name, materials.size());
    if (is_new) materials.push_back({.name = name});
    return static_cast<MaterialId>(found->second);
  }

  /// The mesh of an object, on a node of its own.
  Mesh& mesh_of(const std::string& object) {
    auto& meshes = made.scene.meshes;
    const auto [found, is_new] = mesh_numbers_.try_emplace(object, meshes.size());
    if (is_new) {
      const std::string name = object.empty() ? name_in(std::filesystem::path(name_).stem().string()) : object;
      Node node;
      node.name = name;
      node.mesh = static_cast<MeshId>(meshes.size());
      made.scene.nodes.push_back(std::move(node));
      meshes.push_back({.name = name});
    }
    return meshes[found->second];
  }

  void name_draws() {
    for (const Mesh& mesh : made.scene.meshes) {
      for (std::size_t i = 0; i < mesh.draws.size(); ++i) {
        made.scene.draws[mesh.draws[i]].name = mesh.draws.size() == 1 ? mesh.name : fmt::format("{}/{}", mesh.name, i);
      }
    }
  }

  const PolygonMesh& mesh_;
  const std::string& name_;
  Diagnostics& diagnostics_;
  std::vector<DrawMaking> makings_;
  std::map<std::tuple<std::uint32_t, bool, bool>, std::size_t> numbers_;
  std::map<std::string, std::size_t> material_numbers_, mesh_numbers_;
};

}  // namespace

std::optional<MeshScene> scene_of(const PolygonMesh& mesh, std::vector<Material> materials, const std::string& name,
                                  Diagnostics& diagnostics) {
  SceneMaking making(mesh, name, diagnostics);
  if (!making.run(std::move(materials))) return std::nullopt;
  return std::move(making.made);
}

}  // namespace foredraw::mesh_files
