#include <foredraw/displaced/map_seams.h>

#include <foredraw/image/texture_uv.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace foredraw {

namespace {

std::string why_not(const Scene& scene, const Draw& draw) {
  const Material* material = scene.material_of(draw);
  if (draw.topology != Topology::triangles) return "it has no triangles";
  if (material == nullptr || !material->displacement) return "its material names no map of heights";
  const Texture& texture = material->displacement->texture;
  if (!texture.image || *texture.image >= scene.images.size()) return "its map is of a kind that is not known here";
  const std::string semantic = "TEXCOORD_" + std::to_string(texture.texcoord);
  if (draw.full().vertices->find(semantic) == nullptr) return "it has no " + semantic;
  if (draw.full().vertices->find("POSITION") == nullptr) return "it has no positions";
  return {};
}

struct LaidOutDraw {
  std::shared_ptr<const Positions> positions;
  std::vector<glm::vec2> uvs;
  std::span<const std::uint32_t> indices;
};

LaidOutDraw laid_out(const Draw& draw, const Texture& texture, Analyses& analyses) {
  const VertexStreams& vertices = *draw.full().vertices;
  LaidOutDraw result{positions_of(analyses, vertices), {}, draw.full().stream().indices.view()};
  const VertexStream& texcoords = *vertices.find("TEXCOORD_" + std::to_string(texture.texcoord));
  for (const glm::dvec2 uv : texture_uv(texcoords, texture)) result.uvs.emplace_back(uv);
  return result;
}

/// [draw] The first mesh that has it; none of the scene's meshes where none does.
std::vector<std::size_t> meshes_of_draws(const Scene& scene) {
  std::vector<std::size_t> mesh_of(scene.draws.size(), scene.meshes.size());
  for (std::size_t m = scene.meshes.size(); m-- > 0;) {
    for (const DrawId draw : scene.meshes[m].draws) mesh_of[draw] = m;
  }
  for (std::size_t d = 0; d < mesh_of.size(); ++d) {
    if (mesh_of[d] == scene.meshes.size()) mesh_of[d] += d;
  }
  return mesh_of;
}

/// Those of draws that lie in one space, behind the others; `numbers`: of the draws.
void append(SeamEdges& to, SeamEdges from, std::span<const std::uint32_t> numbers, std::uint32_t& points) {
  const auto sides = static_cast<std::uint32_t>(to.sides.size()), uvs = static_cast<std::uint32_t>(to.uvs.size());
  for (SharedEdge& edge : from.edges) {
    edge.first_side += sides;
    for (std::uint32_t& point : edge.points) point += points;
  }
  for (EdgeSide& side : from.sides) side.mesh = numbers[side.mesh];
  for (UvCorner& corner : from.corners) {
    corner.first_uv += uvs;
    corner.point += points;
  }
  to.edges.insert(to.edges.end(), from.edges.begin(), from.edges.end());
  to.sides.insert(to.sides.end(), from.sides.begin(), from.sides.end());
  to.corners.insert(to.corners.end(), from.corners.begin(), from.corners.end());
  to.uvs.insert(to.uvs.end(), from.uvs.begin(), from.uvs.end());
  to.seams += from.seams;
  to.of_many_faces += from.of_many_faces;
  to.left_out += from.left_out;
}

SeamEdges seams_of(const Scene& scene, const std::vector<DrawId>& draws, const std::vector<std::size_t>& mesh_of,
                   Analyses& analyses, const std::atomic<bool>* cancel) {
  std::map<std::size_t, std::vector<std::uint32_t>> by_mesh;
  for (std::uint32_t i = 0; i < draws.size(); ++i) by_mesh[mesh_of[draws[i]]].push_back(i);
  SeamEdges all;
  std::uint32_t points = 0;
  for (const auto& [mesh, numbers] : by_mesh) {
    std::vector<LaidOutDraw> parts;
    std::vector<UvMesh> meshes;
    std::uint32_t vertices = 0;
    for (const std::uint32_t number : numbers) {
      const Draw& draw = scene.draws[draws[number]];
      parts.push_back(laid_out(draw, scene.material_of(draw)->displacement->texture, analyses));
      vertices += draw.full().vertices->count;
    }
    for (const LaidOutDraw& part : parts) meshes.push_back({part.positions->values, part.uvs, part.indices});
    append(all, seam_edges(meshes, cancel), numbers, points);
    points += vertices;
  }
  return all;
}

}  // namespace

SceneSeams seams_of_maps(const Scene& scene, const std::vector<DrawId>& draws, Analyses& analyses,
                         const std::atomic<bool>* cancel) {
  SceneSeams result;
  std::map<std::tuple<ImageId, std::array<Wrap, 2>, bool>, std::vector<DrawId>> by_map;
  for (const DrawId id : draws) {
    if (std::string why = why_not(scene, scene.draws[id]); !why.empty()) {
      result.left_out.emplace_back(id, std::move(why));
      continue;
    }
    const Texture& texture = scene.material_of(scene.draws[id])->displacement->texture;
    by_map[{*texture.image, texture.wrap, texture.is_nearest}].push_back(id);
  }
  const std::vector<std::size_t> mesh_of = meshes_of_draws(scene);
  for (auto& [key, of_map] : by_map) {
    const ImageId image = std::get<ImageId>(key);
    const auto heights = height_map_of(analyses, scene.images[image]);
    if (const std::string* why = std::get_if<std::string>(&heights)) {
      for (const DrawId id : of_map) result.left_out.emplace_back(id, "its map cannot be read: " + *why);
      continue;
    }
    const Texture& texture = scene.material_of(scene.draws[of_map.front()])->displacement->texture;
    result.maps.push_back({image, std::get<std::shared_ptr<const HeightMap>>(heights), texture, of_map,
                           seams_of(scene, of_map, mesh_of, analyses, cancel)});
  }
  std::ranges::sort(result.left_out);
  return result;
}

}  // namespace foredraw
