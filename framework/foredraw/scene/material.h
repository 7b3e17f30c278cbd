#pragma once
#include <foredraw/base/content_hash.h>
#include <foredraw/scene/texture.h>

#include <glm/vec3.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

using MaterialId = std::uint32_t;

enum class AlphaMode : std::uint8_t { opaque, mask, blend };

/// By how much a surface is moved outwards: factor * height + offset, in the draw's units. The height is the first
/// channel of the texture, 0 to 1, as stored.
struct Displacement {
  Texture texture;
  float factor = 1;
  float offset = 0;
  friend bool operator==(const Displacement&, const Displacement&) = default;
};

/// What a material's textures need of vertices.
struct VertexNeeds {
  std::uint32_t texcoords = 0;  ///< a bit for each set of texture coordinates that a texture is looked up by
  bool has_tangents = false;    ///< a map of normals, or brushed metal, which lies along them
  friend bool operator==(const VertexNeeds&, const VertexNeeds&) = default;
};

/// What the order of triangles, the count of fragments and pictures of frames depend on; the rest stays in the file it
/// came from.
struct Material {
  std::string name;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool double_sided = false;
  float alpha = 1;                     ///< the base colour's
  glm::vec3 colour{1};                 ///< the base colour's, linear
  std::optional<Texture> base_colour;  ///< whose colour and alpha are multiplied with these
  std::optional<Texture> normal_map;
  float normal_scale = 1;  ///< of the normal map's x and y
  std::optional<Displacement> displacement;
  /// Of what light passes through below the surface, in the draw's units; none: it is a thin sheet.
  std::optional<float> thickness = {};
  std::optional<Stamp> look;  ///< of all that the file says but the name: equal ones look alike
  std::optional<Stamp> kind;  ///< of the same without its numbers: equal ones differ in factors and textures alone
  /// Which sides are drawn has to stay: light passes through, the file animates the material, or a variant of the file
  /// puts one in its place that shows other sides. Found by the reader.
  bool keeps_sides = false;
  /// The units and the texture coordinates of its draws have to stay: the file may put another material in its place or
  /// it in another one's, animates it, or says something of it that we do not know, which may hold lengths or look up
  /// textures. Found by the reader.
  bool keeps_spaces = false;
  /// A stage made it of this one: the file says of it all that it says of that, but for what differs here.
  std::optional<MaterialId> copy_of = {};
  /// What its textures, and those of materials that variants put in its place, need; nothing: it may need anything, as
  /// an extension that we do not know. Found by the reader.
  std::optional<VertexNeeds> needs = {};
  /// Of sets of texture coordinates that stages put into other units, by set: what leads back to the file's. The
  /// textures above are of the coordinates as they are now.
  std::vector<ScaledTexcoords> scaled_texcoords = {};
};

}  // namespace foredraw
