#include <foredraw/image/texture_uv.h>

#include <foredraw/image/turn.h>

namespace foredraw {

std::vector<glm::dvec2> texture_uv(const VertexStream& texcoords, const Texture& texture) {
  const Turn turn = turn_by(texture.rotation);
  std::vector<glm::dvec2> places;
  for (const glm::vec3& texcoord : decode_vec3(texcoords)) {
    const glm::dvec2 scaled = texture.scale * glm::dvec2(texcoord);
    places.push_back(texture.offset + glm::dvec2(turn.cosine * scaled.x + turn.sine * scaled.y,
                                                 turn.cosine * scaled.y - turn.sine * scaled.x));
  }
  return places;
}

}  // namespace foredraw
