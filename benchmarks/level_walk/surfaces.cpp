#include "surfaces.h"

#include <foredraw/io/image/picture.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::bench {

namespace {

using Json = GltfDocument::Json;

constexpr int side = 256;

std::uint8_t eight_bits(double value) {
  return static_cast<std::uint8_t>(std::floor(255 * std::clamp(value, 0.0, 1.0) + 0.5));
}

/// [texel] Heights, row by row.
std::vector<double> heights_of(const Pattern& pattern) {
  std::vector<double> heights;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) heights.push_back(pattern({(x + 0.5) / side, (y + 0.5) / side}));
  }
  return heights;
}

double height_at(const std::vector<double>& heights, int x, int y) {
  return heights[static_cast<std::size_t>((y + side) % side * side + (x + side) % side)];
}

template <class ColourAt>
std::vector<std::byte> picture(const ColourAt& colour_at) {
  images::Picture made(side, side, {0, 0, 0});
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) {
      const glm::dvec3 colour = colour_at(x, y);
      made.fill(x, y, 1, 1, {eight_bits(colour.x), eight_bits(colour.y), eight_bits(colour.z)});
    }
  }
  return made.as_png();
}

std::vector<std::byte> colour_picture(const std::vector<double>& heights, const Surface& surface) {
  return picture(
      [&](int x, int y) { return surface.dark + height_at(heights, x, y) * (surface.light - surface.dark); });
}

/// x along u, y against v, as glTF has them.
std::vector<std::byte> normal_picture(const std::vector<double>& heights, double bump) {
  return picture([&](int x, int y) {
    const double right = height_at(heights, x + 1, y) - height_at(heights, x - 1, y);
    const double down = height_at(heights, x, y + 1) - height_at(heights, x, y - 1);
    const glm::dvec3 normal(-bump * right, bump * down, 1);
    const double length = std::sqrt(normal.x * normal.x + normal.y * normal.y + 1);
    return 0.5 + 0.5 * normal / length;
  });
}

std::size_t add_texture(GltfDocument& to, std::span<const std::byte> png, const std::string& name) {
  const std::size_t image = to.add_image(png, {{"name", name}, {"mimeType", "image/png"}});
  const std::size_t sampler =
      to.add_once("samplers", {{"magFilter", 9729}, {"minFilter", 9987}, {"wrapS", 10497}, {"wrapT", 10497}});
  return to.add_once("textures", {{"sampler", sampler}, {"source", image}});
}

/// Of three decimal places, which are short to write.
Json rounded(const glm::dvec3& colour) {
  Json numbers = Json::array();
  for (int i = 0; i < 3; ++i) numbers.push_back(std::floor(1000 * colour[i] + 0.5) / 1000);
  numbers.push_back(1);
  return numbers;
}

template <class Vector>
std::span<const float> numbers_of(const std::vector<Vector>& values) {
  return {&values[0][0], values.size() * sizeof(Vector) / sizeof(float)};
}

}  // namespace

std::size_t add_surface(GltfDocument& to, const Surface& surface) {
  Json material = {{"name", surface.name}};
  Json& factors = material["pbrMetallicRoughness"];
  factors = {{"metallicFactor", surface.metallic}, {"roughnessFactor", surface.roughness}};
  if (surface.pattern) {
    const std::vector<double> heights = heights_of(surface.pattern);
    const std::size_t texture = add_texture(to, colour_picture(heights, surface), surface.name);
    factors["baseColorTexture"] = {{"index", texture}};
    if (surface.bump > 0) {
      const std::size_t normals = add_texture(to, normal_picture(heights, surface.bump), surface.name + " normals");
      material["normalTexture"] = {{"index", normals}};
    }
  } else {
    factors["baseColorFactor"] = rounded(surface.light);
  }
  if (surface.is_double_sided) material["doubleSided"] = true;
  return to.add("materials", std::move(material));
}

Json add_primitive(GltfDocument& to, const SurfaceMesh& mesh, std::size_t material) {
  constexpr int of_vertices = 34962, of_indices = 34963;
  const Json& made_of = to.json["materials"].at(material);
  const bool has_texture = made_of["pbrMetallicRoughness"].contains("baseColorTexture");
  const bool has_normal_map = made_of.contains("normalTexture");
  Json attributes;
  attributes["POSITION"] = to.add_bounded(numbers_of(mesh.places), "VEC3", of_vertices);
  attributes["NORMAL"] = to.add_values(numbers_of(mesh.normals), "VEC3", of_vertices);
  if (has_normal_map) attributes["TANGENT"] = to.add_values(numbers_of(mesh.tangents), "VEC4", of_vertices);
  if (has_texture) attributes["TEXCOORD_0"] = to.add_values(numbers_of(mesh.uvs), "VEC2", of_vertices);
  std::size_t indices;
  if (mesh.places.size() < std::numeric_limits<std::uint16_t>::max()) {
    const std::vector<std::uint16_t> narrow(mesh.indices.begin(), mesh.indices.end());
    indices = to.add_values(std::span<const std::uint16_t>(narrow), "SCALAR", of_indices);
  } else {
    indices = to.add_values(std::span<const std::uint32_t>(mesh.indices), "SCALAR", of_indices);
  }
  return {{"attributes", std::move(attributes)}, {"indices", indices}, {"material", material}};
}

}  // namespace foredraw::bench
