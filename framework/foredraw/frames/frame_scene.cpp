#include <foredraw/frames/frame_scene.h>

#include <foredraw/geometry/finite.h>
#include <foredraw/image/texture_uv.h>
#include <foredraw/scene/walk.h>
#include <foredraw/viewing/shown_scene.h>
#include <foredraw/wires/wires.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace foredraw {

namespace {

std::vector<glm::vec2> places_of(const VertexStreams& vertices, const std::optional<Texture>& texture) {
  if (!texture) return {};
  const VertexStream* stream = vertices.find("TEXCOORD_" + std::to_string(texture->texcoord));
  if (stream == nullptr) return {};
  const std::vector<glm::dvec2> places = texture_uv(*stream, *texture);
  return {places.begin(), places.end()};
}

FrameLevel frame_level(const Level& level, const Material* material, std::optional<std::uint32_t> wire_texcoords,
                       Analyses& analyses) {
  FrameLevel made;
  made.positions = positions_of(analyses, *level.vertices);
  if (const VertexStream* normals = level.vertices->find("NORMAL")) made.normals = decode_vec3(*normals);
  if (material != nullptr) {
    made.base_places = places_of(*level.vertices, material->base_colour);
    made.normal_map_places = places_of(*level.vertices, material->normal_map);
  }
  if (auto of_vertices = decoded_wires(*level.vertices, wire_texcoords)) {
    made.wires = std::move(of_vertices->wires);
    made.wire_axes = std::move(of_vertices->axes);
  }
  made.indices = level.stream().indices.view();
  for (const std::uint32_t v : made.indices) made.vertices = std::max<std::size_t>(made.vertices, v + std::size_t{1});
  made.error = static_cast<double>(level.error);
  return made;
}

std::shared_ptr<const MippedImage> image_of(const Scene& scene, const std::optional<Texture>& texture,
                                            Analyses& analyses) {
  if (!texture || !texture->image || *texture->image >= scene.images.size()) return nullptr;
  return mipped_image_of(analyses, scene.images[*texture->image]);
}

Sampling sampling_of(const std::optional<Texture>& texture) {
  return texture ? Sampling{texture->wrap, texture->is_nearest} : Sampling{};
}

FrameSurface surface_of(const Scene& scene, const Material* material, Analyses& analyses) {
  FrameSurface surface;
  if (material == nullptr) return surface;
  surface.colour = glm::vec4(material->colour, material->alpha);
  surface.base = image_of(scene, material->base_colour, analyses);
  surface.base_sampling = sampling_of(material->base_colour);
  surface.normal_map = image_of(scene, material->normal_map, analyses);
  surface.normal_map_sampling = sampling_of(material->normal_map);
  surface.normal_scale = material->normal_scale;
  surface.alpha_mode = material->alpha_mode;
  surface.alpha_cutoff = material->alpha_cutoff;
  surface.is_double_sided = material->double_sided;
  return surface;
}

/// The positions that each joint moves, [joint].
void add_moved_by_joints(std::vector<std::vector<glm::vec3>>& moved, const VertexStreams& vertices,
                         std::span<const glm::vec3> positions) {
  for (int set = 0;; ++set) {
    const VertexStream* joints = vertices.find("JOINTS_" + std::to_string(set));
    const VertexStream* weights = vertices.find("WEIGHTS_" + std::to_string(set));
    if (joints == nullptr || weights == nullptr) return;
    const std::size_t components = std::min(joints->format.components, weights->format.components);
    for (std::size_t v = 0; v < positions.size(); ++v) {
      for (std::size_t c = 0; c < components; ++c) {
        const float joint = decode_component(*joints, v, c);
        if (decode_component(*weights, v, c) == 0 || !(joint >= 0 && joint < 65536)) continue;
        if (moved.size() <= static_cast<std::size_t>(joint)) moved.resize(static_cast<std::size_t>(joint) + 1);
        moved[static_cast<std::size_t>(joint)].push_back(positions[v]);
      }
    }
  }
}

std::vector<BoundingSphere> spheres_of_joints(const Scene& scene, const FrameMesh& mesh) {
  std::vector<std::vector<glm::vec3>> moved;
  for (const FrameDraw& draw : mesh.draws) {
    add_moved_by_joints(moved, *scene.draws[draw.draw].full().vertices, draw.levels.front().positions->values);
  }
  std::vector<BoundingSphere> spheres;
  std::vector<std::uint32_t> all;
  for (const std::vector<glm::vec3>& positions : moved) {
    all.resize(positions.size());
    std::iota(all.begin(), all.end(), 0u);
    const DrawnPositions drawn[] = {{positions, all}};
    spheres.push_back(positions.empty() ? BoundingSphere{glm::dvec3(0), -1} : bounding_sphere(drawn));
  }
  return spheres;
}

/// The box is around the sphere's centre, as the sphere is around the middle of the box.
glm::dvec3 half_box_of(const BoundingSphere& sphere, std::span<const DrawnPositions> drawn) {
  glm::dvec3 half(0);
  for (const DrawnPositions& part : drawn) {
    for (const std::uint32_t v : part.indices) {
      const glm::dvec3 apart = glm::abs(glm::dvec3(part.positions[v]) - sphere.centre);
      if (is_finite(apart)) half = glm::max(half, apart);
    }
  }
  return half;
}

/// A convex body covers a quarter of its surface in the mean (Cauchy). Where more lies behind, it is at most the
/// sphere.
double fill_of(const BoundingSphere& sphere, std::span<const DrawnPositions> drawn) {
  double area = 0;
  for (const DrawnPositions& part : drawn) {
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
      const glm::dvec3 a(part.positions[part.indices[i]]), b(part.positions[part.indices[i + 1]]),
          c(part.positions[part.indices[i + 2]]);
      const double doubled = glm::length(glm::cross(b - a, c - a));
      if (std::isfinite(doubled)) area += doubled / 2;
    }
  }
  const double whole = 4 * glm::pi<double>() * sphere.radius * sphere.radius;
  return whole > 0 ? std::min(1.0, area / whole) : 1;
}

FrameMesh frame_mesh(const Scene& scene, const Mesh& mesh, Analyses& analyses) {
  FrameMesh made;
  std::vector<DrawnPositions> drawn;
  for (const DrawId id : mesh.draws) {
    const Draw& draw = scene.draws[id];
    if (draw.topology != Topology::triangles) continue;
    const Material* material = scene.material_of(draw);
    FrameDraw frame{id, {}, surface_of(scene, material, analyses)};
    const auto* wires = scene.products.find<Wires>();
    const DrawWires* of = wires == nullptr ? nullptr : wires->of(id);
    const auto texcoords = of == nullptr ? std::nullopt : of->texcoords;
    for (const Level& level : draw.levels) {
      frame.levels.push_back(frame_level(level, material, texcoords, analyses));
    }
    made.levels = std::max(made.levels, frame.levels.size());
    drawn.push_back({frame.levels.front().positions->values, frame.levels.front().indices});
    made.draws.push_back(std::move(frame));
  }
  made.sphere = bounding_sphere(drawn);
  made.half_box = half_box_of(made.sphere, drawn);
  made.fill = fill_of(made.sphere, drawn);
  made.of_joints = spheres_of_joints(scene, made);
  return made;
}

bool has_morph_targets(const Scene& scene, const Mesh& mesh) {
  return std::ranges::any_of(mesh.draws,
                             [&](DrawId draw) { return !scene.draws[draw].full().vertices->morph_targets.empty(); });
}

}  // namespace

FrameScene::FrameScene(const Scene& stored, Analyses& analyses, const Executor& executor)
    : scene_(stored), shown_(shown_scene(stored, analyses)), meshes_(stored.meshes.size()) {
  const Scene& scene = this->scene();
  std::vector<bool> is_shown(scene.meshes.size());
  for (const NodeId id : walk(scene)) {
    const Node& node = scene.nodes[id];
    if (!node.mesh || !node.is_shown) continue;
    is_shown[*node.mesh] = true;
    const bool is_posed = node.skin.has_value() || has_morph_targets(scene, scene.meshes[*node.mesh]);
    const std::size_t instances = std::max<std::size_t>(node.instances.size(), 1);
    for (std::size_t i = 0; i < instances; ++i) objects_.push_back({id, i, *node.mesh, is_posed});
  }
  executor.for_each(meshes_.size(), [&](std::size_t mesh) {
    if (is_shown[mesh]) meshes_[mesh] = frame_mesh(scene, scene.meshes[mesh], analyses);
  });
  std::erase_if(objects_, [&](const PlacedObject& object) { return meshes_[object.mesh].draws.empty(); });
}

}  // namespace foredraw
