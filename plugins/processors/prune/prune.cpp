#include "prune.h"

#include <algorithm>

namespace foredraw {

namespace {

bool are_all(const VertexStream& stream, float value) {
  for (std::size_t v = 0; v < stream.count(); ++v) {
    for (std::size_t i = 0; i < stream.format.components; ++i) {
      if (decode_component(stream, v, i) != value) return false;
    }
  }
  return true;
}

bool has_morphed_colours(const VertexStreams& vertices) {
  return std::ranges::any_of(vertices.morph_targets, [](const auto& target) {
    return std::ranges::any_of(target, [](const VertexStream& stream) { return stream.semantic == "COLOR_0"; });
  });
}

}  // namespace

std::optional<VertexNeeds> needs_of(const Draw& draw, const Scene& scene) {
  const Material* material = scene.material_of(draw);
  if (material == nullptr || !material->needs || draw.traits.has(traits::extended)) return std::nullopt;
  VertexNeeds needs = *material->needs;
  const auto add = [&](const Texture& texture) { needs.texcoords |= 1u << std::min(texture.texcoord, 31u); };
  if (material->base_colour) add(*material->base_colour);
  if (material->displacement) add(material->displacement->texture);
  if (material->normal_map) {
    add(*material->normal_map);
    needs.has_tangents = true;
  }
  return needs;
}

PrunedStreams prune_streams(const VertexStreams& vertices, const std::optional<VertexNeeds>& needs) {
  PrunedStreams result;
  const auto prune = [&](const std::string& semantic, const char* why) { result.pruned.push_back({semantic, why}); };
  // Sets of joints are numbered without a gap: only the last ones can go.
  std::size_t sets = 0;
  while (vertices.find("WEIGHTS_" + std::to_string(sets)) != nullptr) ++sets;
  while (sets > 1 && are_all(*vertices.find("WEIGHTS_" + std::to_string(sets - 1)), 0)) {
    --sets;
    prune("WEIGHTS_" + std::to_string(sets), "all weights are 0");
    prune("JOINTS_" + std::to_string(sets), "all weights are 0");
  }
  const VertexStream* colours = vertices.find("COLOR_0");
  const bool is_only = vertices.find("COLOR_1") == nullptr && !has_morphed_colours(vertices);
  if (colours != nullptr && is_only && are_all(*colours, 1)) prune("COLOR_0", "all colours are 1");
  if (needs) {
    std::uint32_t coordinates = 0;
    while (vertices.find("TEXCOORD_" + std::to_string(coordinates)) != nullptr) ++coordinates;
    const char* why =
        needs->texcoords == 0 ? "no texture of its material is looked up" : "no texture is looked up by it";
    for (; coordinates > 0 && needs->texcoords >> std::min(coordinates - 1, 31u) == 0; --coordinates) {
      prune("TEXCOORD_" + std::to_string(coordinates - 1), why);
    }
    if (!needs->has_tangents && vertices.find("TANGENT") != nullptr) prune("TANGENT", "its material has no normal map");
  }
  const auto leave_out = [&](std::vector<VertexStream>& streams) {
    std::erase_if(streams, [&](const VertexStream& stream) {
      return std::ranges::find(result.pruned, stream.semantic, &PrunedStream::semantic) != result.pruned.end();
    });
  };
  auto left = std::make_shared<VertexStreams>(vertices);
  leave_out(left->base);
  for (std::vector<VertexStream>& target : left->morph_targets) leave_out(target);
  result.vertices = std::move(left);
  return result;
}

}  // namespace foredraw
