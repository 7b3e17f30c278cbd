// Whether what an encoder that sorts as it likes gives back shows the same.
#include <foredraw/base/content_hash.h>
#include <foredraw/io/gltf/codecs/private/draco_encode.h>

#include <algorithm>
#include <array>
#include <functional>

namespace foredraw::gltf {

namespace {

using Elements = std::vector<std::span<const std::byte>>;

/// A stamp for each of `points` vertices, of all its attributes.
std::vector<Stamp> stamps_of_vertices(const Elements& attributes, const std::vector<DracoInput::Attribute>& told,
                                      std::size_t points) {
  std::vector<Stamp> stamps(points);
  std::vector<std::byte> vertex;
  for (std::size_t i = 0; i < points; ++i) {
    vertex.clear();
    for (std::size_t a = 0; a < attributes.size(); ++a) {
      const std::size_t bytes = told[a].format.bytes;
      const auto element = attributes[a].subspan(i * bytes, bytes);
      vertex.insert(vertex.end(), element.begin(), element.end());
    }
    stamps[i] = content_hash(std::span<const std::byte>(vertex));
  }
  return stamps;
}

/// A stamp for each triangle that draws something, sorted.
std::vector<Stamp> stamps_of_triangles(std::span<const std::uint32_t> indices, const Elements& attributes,
                                       const std::vector<DracoInput::Attribute>& told, std::size_t points) {
  const auto position =
      static_cast<std::size_t>(std::ranges::find(told, "POSITION", &DracoInput::Attribute::semantic) - told.begin());
  const std::size_t bytes = told[position].format.bytes;
  const auto same_place = [&](std::uint32_t a, std::uint32_t b) {
    return std::ranges::equal(attributes[position].subspan(a * bytes, bytes),
                              attributes[position].subspan(b * bytes, bytes));
  };
  const std::vector<Stamp> vertices = stamps_of_vertices(attributes, told, points);
  std::vector<Stamp> stamps;
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const std::uint32_t a = indices[i], b = indices[i + 1], c = indices[i + 2];
    if (same_place(a, b) || same_place(b, c) || same_place(c, a)) continue;
    std::array<Stamp, 3> corners{vertices[a], vertices[b], vertices[c]};
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());  // may begin at any corner
    stamps.push_back(combine(corners));
  }
  std::ranges::sort(stamps);
  return stamps;
}

}  // namespace

bool same_triangles(const DracoInput& input, const DracoMesh& decoded) {
  Elements before, after;
  for (const DracoInput::Attribute& attribute : input.attributes) before.push_back(attribute.bytes);
  for (const std::vector<std::byte>& attribute : decoded.attributes) after.emplace_back(attribute);
  return stamps_of_triangles(input.indices, before, input.attributes, input.points) ==
         stamps_of_triangles(decoded.indices, after, input.attributes, decoded.points);
}

}  // namespace foredraw::gltf
