#include <foredraw/scene/scaled_texcoords.h>

#include <foredraw/scene/turn.h>

#include <glm/common.hpp>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

/// Kinds differ in what a shader is built for: whether it scales coordinates, and not by what.
void look_otherwise(Material& material, const ScaledTexcoords& change, bool is_first) {
  const std::array<double, 5> numbers = {double(change.set), change.offset.x, change.offset.y, change.scale.x,
                                         change.scale.y};
  const auto change_stamp = [](std::optional<Stamp>& stamp, std::span<const double> by) {
    if (stamp) stamp = combine(std::array{*stamp, content_hash(by)});
  };
  change_stamp(material.look, numbers);
  if (is_first) change_stamp(material.kind, std::span(numbers).first(1));
}

}  // namespace

Texture with_scaled_texcoords(Texture texture, const ScaledTexcoords& change) {
  if (texture.texcoord != change.set) return texture;
  texture.offset += turned(texture.scale * change.offset, turn_by(texture.rotation));
  texture.scale *= change.scale;
  return texture;
}

Material with_scaled_texcoords(Material material, const ScaledTexcoords& change) {
  for (std::optional<Texture>* texture : {&material.base_colour, &material.normal_map}) {
    if (*texture) *texture = with_scaled_texcoords(**texture, change);
  }
  if (material.displacement)
    material.displacement->texture = with_scaled_texcoords(material.displacement->texture, change);
  std::vector<ScaledTexcoords>& all = material.scaled_texcoords;
  const auto at = std::ranges::lower_bound(all, change.set, {}, &ScaledTexcoords::set);
  const bool is_first = at == all.end() || at->set != change.set;
  look_otherwise(material, change, is_first);
  if (is_first) {
    all.insert(at, change);
  } else {
    at->offset += at->scale * change.offset;
    at->scale *= change.scale;
  }
  return material;
}

ScaledTexcoords scaled_texcoords_of(const Material* material, std::uint32_t set) {
  if (material != nullptr) {
    for (const ScaledTexcoords& one : material->scaled_texcoords) {
      if (one.set == set) return one;
    }
  }
  return {set};
}

glm::dvec2 texture_widths(const Material* material, std::uint32_t set) {
  glm::dvec2 widths(0);
  const auto see = [&](const Texture& texture) {
    if (texture.texcoord == set) widths = glm::max(widths, glm::abs(texture.scale));
  };
  if (material != nullptr) {
    for (const std::optional<Texture>* texture : {&material->base_colour, &material->normal_map})
      if (*texture) see(**texture);
    if (material->displacement) see(material->displacement->texture);
  }
  return widths.x > 0 && widths.y > 0 ? widths : glm::abs(scaled_texcoords_of(material, set).scale);
}

}  // namespace foredraw
