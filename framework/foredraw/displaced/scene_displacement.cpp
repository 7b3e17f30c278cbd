#include <foredraw/displaced/scene_displacement.h>

#include <foredraw/displaced/displacement_stamp.h>
#include <foredraw/displaced/smooth_directions.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

struct Directions {
  static constexpr std::string_view name = "displacement-directions";
  std::vector<std::vector<glm::vec3>> of_draws;

  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const auto& of : of_draws) sum += of.size() * sizeof(glm::vec3);
    return sum;
  }
};

/// Those of the displaced draws that are in a mesh with it, itself among them.
std::vector<DrawId> displaced_with(const Scene& scene, DrawId draw) {
  for (const Mesh& mesh : scene.meshes) {
    if (std::ranges::find(mesh.draws, draw) == mesh.draws.end()) continue;
    std::vector<DrawId> together;
    for (const DrawId id : mesh.draws) {
      const Draw& other = scene.draws[id];
      const Material* material = scene.material_of(other);
      const bool has_surface = other.topology == Topology::triangles && other.full().vertices->find("POSITION");
      if (id == draw || (has_surface && material != nullptr && material->displacement)) together.push_back(id);
    }
    return together;
  }
  return {draw};
}

Stamp surface_stamp(const Scene& scene, const std::vector<DrawId>& draws) {
  std::vector<Stamp> content;
  for (const DrawId draw : draws) {
    content.push_back(scene.draws[draw].full().vertices->stamp());
    content.push_back(scene.draws[draw].full().stream().indices.stamp());
  }
  return combine(content);
}

}  // namespace

std::variant<LaidOutMap, std::string> laid_out_map(const Scene& scene, DrawId id, Analyses& analyses) {
  const Draw& draw = scene.draws[id];
  const Material* material = scene.material_of(draw);
  if (draw.topology != Topology::triangles) return "it has no triangles";
  if (material == nullptr || !material->displacement) return "its material names no map of heights";
  const Texture& texture = material->displacement->texture;
  if (!std::isfinite(std::abs(material->displacement->factor) + std::abs(material->displacement->offset)))
    return "its factor and offset move points farther than a float holds";
  if (!texture.image || *texture.image >= scene.images.size()) return "its map is of a kind that is not known here";
  const VertexStreams& vertices = *draw.full().vertices;
  const std::string semantic = "TEXCOORD_" + std::to_string(texture.texcoord);
  const VertexStream* texcoords = vertices.find(semantic);
  if (texcoords == nullptr) return "it has no " + semantic;
  if (vertices.find("POSITION") == nullptr) return "it has no positions";
  const auto map = height_map_of(analyses, scene.images[*texture.image]);
  if (const std::string* why = std::get_if<std::string>(&map)) return *why;
  const auto& heights = std::get<std::shared_ptr<const HeightMap>>(map);
  return LaidOutMap{heights, *material->displacement, height_places(*texcoords, texture, *heights)};
}

std::vector<glm::vec3> displacement_directions(const Scene& scene, DrawId draw, Analyses& analyses) {
  const std::vector<DrawId> together = displaced_with(scene, draw);
  const auto directions = analyses.get<Directions>(surface_stamp(scene, together), [&]() -> Directions {
    std::vector<std::vector<glm::vec3>> positions, normals;
    for (const DrawId one : together) {
      const VertexStreams& vertices = *scene.draws[one].full().vertices;
      const VertexStream* stored = vertices.find("NORMAL");
      positions.push_back(decode_vec3(*vertices.find("POSITION")));
      normals.push_back(stored == nullptr ? std::vector<glm::vec3>{} : decode_vec3(*stored));
    }
    std::vector<DirectedPart> parts;
    for (std::size_t i = 0; i < together.size(); ++i)
      parts.push_back({positions[i], normals[i], scene.draws[together[i]].full().stream().indices.view()});
    return {smooth_directions(parts)};
  });
  return directions->of_draws[static_cast<std::size_t>(std::ranges::find(together, draw) - together.begin())];
}

Stamp displacement_stamp(const Scene& scene, DrawId draw) {
  const Displacement& displacement = *scene.material_of(scene.draws[draw])->displacement;
  const Image& image = scene.images[*displacement.texture.image];
  const Stamp parts[] = {stamp_of(displacement),
                         image.bytes.stamp(),
                         content_hash(std::span<const char>(image.uri)),
                         scene.draws[draw].full().vertices->stamp(),
                         scene.draws[draw].full().stream().indices.stamp(),
                         surface_stamp(scene, displaced_with(scene, draw))};
  return combine(parts);
}

}  // namespace foredraw
