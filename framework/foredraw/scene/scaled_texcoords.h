#pragma once
// Texture coordinates in other units: what materials have to say for their textures to lie where they lay.

#include <foredraw/scene/material.h>

namespace foredraw {

/// The material for draws whose coordinates of that set are other ones by now, of which those that they had are
/// change.offset + change.scale * these. Its textures of the set lie where they lay, and scaled_texcoords leads from
/// the new ones to the file's. It looks otherwise than before to whoever compares stamps.
Material with_scaled_texcoords(Material material, const ScaledTexcoords& change);

/// The same of one texture. One of another set stays.
Texture with_scaled_texcoords(Texture texture, const ScaledTexcoords& change);

/// What leads from the coordinates of a set as they are to the file's: offset 0 and scale 1 where they are the same, as
/// without a material.
ScaledTexcoords scaled_texcoords_of(const Material* material, std::uint32_t set);

/// How many widths of a texture 1 of a set's coordinates is, along u and v: of the texture that runs the fastest, of
/// those that a Material holds; without one, as in the file, where 1 is a whole texture.
glm::dvec2 texture_widths(const Material* material, std::uint32_t set);

}  // namespace foredraw
