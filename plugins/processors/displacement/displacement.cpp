#include "displacement.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/displaced/displacement_stamp.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/scene/scaled_texcoords.h>

#include <map>

namespace foredraw {

namespace {

std::string why_not(const Scene& scene, DrawId id, const GivenDisplacement& given) {
  const Draw& draw = scene.draws[id];
  const Material* material = scene.material_of(draw);
  const bool has_map = material != nullptr && material->displacement && material->displacement->texture.image;
  if (!given.map && !has_map) {
    return "its material names no map of heights; give one, as in displacement(map=\"heights.png\")";
  }
  const std::uint32_t texcoord = given.texcoord.value_or(
      material != nullptr && material->displacement ? material->displacement->texture.texcoord : 0);
  const std::string semantic = "TEXCOORD_" + std::to_string(texcoord);
  if (draw.full().vertices->find(semantic) == nullptr) return "it has no " + semantic;
  return {};
}

/// Of the box around all of these draws, each in its own space.
double diagonal_of(const Scene& scene, const std::vector<DrawId>& draws) {
  std::vector<glm::vec3> all;
  for (const DrawId draw : draws) {
    const VertexStream* positions = scene.draws[draw].full().vertices->find("POSITION");
    if (positions == nullptr) continue;
    const std::vector<glm::vec3> of_draw = decode_vec3(*positions);
    all.insert(all.end(), of_draw.begin(), of_draw.end());
  }
  return foredraw::diagonal_of(all);
}

/// Looked up by another set of coordinates, with the same transform of those that the file had.
Texture on_set(Texture texture, std::uint32_t set, const Material& material) {
  if (texture.texcoord == set) return texture;
  const ScaledTexcoords was = scaled_texcoords_of(&material, texture.texcoord);
  texture = with_scaled_texcoords(texture, {was.set, -was.offset / was.scale, 1.0 / was.scale});
  texture.texcoord = set;
  return with_scaled_texcoords(texture, scaled_texcoords_of(&material, set));
}

}  // namespace

DisplacementAnswer displace(Scene& scene, const std::vector<DrawId>& draws, const GivenDisplacement& given) {
  DisplacementAnswer answer;
  std::map<std::optional<MaterialId>, std::vector<DrawId>> by_material;
  bool has_factor = given.factor.has_value();
  for (const DrawId id : draws) {
    if (std::string why = why_not(scene, id, given); !why.empty()) {
      answer.why_not.emplace_back(id, std::move(why));
      continue;
    }
    answer.displaced.push_back(id);
    const Material* material = scene.material_of(scene.draws[id]);
    has_factor = has_factor || (material != nullptr && material->displacement);
    by_material[material == nullptr ? std::nullopt : scene.draws[id].material].push_back(id);
  }
  if (answer.displaced.empty()) return answer;
  if (!has_factor) answer.factor = static_cast<float>(usual_displacement * diagonal_of(scene, answer.displaced));

  for (const auto& [material, sharing] : by_material) {
    Material& own = scene.materials[own_material(scene, material, sharing)];
    const Texture plain = with_scaled_texcoords(Texture{}, scaled_texcoords_of(&own, 0));
    Displacement displacement = own.displacement.value_or(Displacement{plain, answer.factor.value_or(1)});
    if (given.map) displacement.texture.image = given.map;
    if (given.factor) displacement.factor = *given.factor;
    if (given.offset) displacement.offset = *given.offset;
    if (given.texcoord) displacement.texture = on_set(displacement.texture, *given.texcoord, own);
    if (own.displacement == displacement) continue;
    own.displacement = displacement;
    change_look(own, stamp_of(displacement));  // alike are those that were, and are moved alike
  }
  return answer;
}

}  // namespace foredraw
