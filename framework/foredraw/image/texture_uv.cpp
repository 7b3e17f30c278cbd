#include <foredraw/image/texture_uv.h>

#include <foredraw/scene/turn.h>

namespace foredraw {

std::vector<glm::dvec2> texture_uv(const VertexStream& texcoords, const Texture& texture) {
  const Turn turn = turn_by(texture.rotation);
  std::vector<glm::dvec2> places;
  for (const glm::vec3& texcoord : decode_vec3(texcoords)) {
    places.push_back(texture.offset + turned(texture.scale * glm::dvec2(texcoord), turn));
  }
  return places;
}

}  // namespace foredraw
