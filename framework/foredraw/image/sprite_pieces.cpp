#include <foredraw/image/sprite_pieces.h>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace foredraw {

namespace {

/// The corner's position and texture coordinates.
using Place = std::array<float, 5>;

std::vector<Place> places_of(const VertexStreams& vertices, std::uint32_t texcoord) {
  const VertexStream* positions = vertices.find("POSITION");
  const VertexStream* texcoords = vertices.find("TEXCOORD_" + std::to_string(texcoord));
  if (positions == nullptr || texcoords == nullptr) return {};
  const std::vector<glm::vec3> p = decode_vec3(*positions), t = decode_vec3(*texcoords);
  std::vector<Place> places(std::min(p.size(), t.size()));
  for (std::size_t v = 0; v < places.size(); ++v) {
    places[v] = {p[v].x, p[v].y, p[v].z, t[v].x, t[v].y};
    for (float& number : places[v]) number += 0.0f;  // -0 becomes 0
  }
  return places;
}

/// [vertex] = the first one at the same place. None is at a place that is not finite but itself.
std::vector<std::uint32_t> first_at(const std::vector<Place>& places) {
  std::vector<std::uint32_t> order(places.size()), first(places.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto bits = [&](std::uint32_t v) { return places[v]; };
  std::ranges::stable_sort(
      order, [&](std::uint32_t a, std::uint32_t b) { return std::ranges::lexicographical_compare(bits(a), bits(b)); });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_new = i == 0 || places[order[i]] != places[order[i - 1]];
    first[order[i]] = is_new ? order[i] : first[order[i - 1]];
  }
  return first;
}

using Triangle = std::array<std::uint32_t, 3>;

/// Vertices that hang together.
class Groups {
 public:
  explicit Groups(std::size_t vertices) : parent_(vertices) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t root(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(std::uint32_t root, std::uint32_t to_root) { parent_[root] = to_root; }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Whether more than so many triangles hang together by the numbers of their vertices alone. Then they are of one
/// piece, wherever vertices lie; most meshes show it at once.
bool has_larger_piece(const Level& level, std::size_t most) {
  Groups groups(level.vertices->count);
  std::vector<std::size_t> triangles(level.vertices->count, 0);  // of the group of a root
  const auto indices = level.orders[0].indices.view();
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const std::uint32_t root = groups.root(indices[i]);
    for (std::size_t c = 1; c < 3; ++c) {
      const std::uint32_t other = groups.root(indices[i + c]);
      if (other == root) continue;
      groups.join(other, root);
      triangles[root] += triangles[other];
    }
    if (++triangles[root] > most) return true;
  }
  return false;
}

/// The edges that one triangle alone has, chained; empty where they make no single chain.
std::vector<std::uint32_t> outline_of(const std::vector<Triangle>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  }
  std::map<std::uint32_t, std::uint32_t> next;
  for (const auto& [edge, count] : edges) {
    if (count > 1) return {};
    if (edges.contains({edge.second, edge.first})) continue;
    if (!next.emplace(edge.first, edge.second).second) return {};
  }
  std::vector<std::uint32_t> outline;
  if (next.empty()) return outline;
  const std::uint32_t start = next.begin()->first;
  std::uint32_t at = start;
  do {
    outline.push_back(at);
    const auto found = next.find(at);
    if (found == next.end() || outline.size() > next.size()) return {};
    at = found->second;
  } while (at != start);
  if (outline.size() != next.size()) outline.clear();
  return outline;
}

bool is_quad(const std::vector<Place>& places, const SpritePiece& piece) {
  if (piece.triangles.size() != 2 || piece.outline.size() != 4) return false;
  const auto corner = [&](std::size_t i) -> const Place& { return places[piece.outline[i]]; };
  // The fourth corner is where three of them put it, to a part in ten thousand of the sides.
  for (std::size_t first = 0; first < 5; first += 3) {
    const std::size_t end = first == 0 ? 3 : 5;
    float off = 0, side = 0;
    for (std::size_t k = first; k < end; ++k) {
      off = std::max(off, std::abs(corner(0)[k] - corner(1)[k] + corner(2)[k] - corner(3)[k]));
      side = std::max({side, std::abs(corner(0)[k] - corner(2)[k]), std::abs(corner(1)[k] - corner(3)[k])});
    }
    if (!(side > 0) || !(off <= 1e-4f * side)) return false;
  }
  const auto differ = [&](std::size_t a, std::size_t b, std::size_t k) {
    return std::abs(corner(a)[k] - corner(b)[k]) > 1e-6f;
  };
  const auto upright = [&](std::size_t u, std::size_t v) {
    return differ(0, 1, u) && !differ(0, 1, v) && differ(1, 2, v) && !differ(1, 2, u);
  };
  return upright(3, 4) || upright(4, 3);
}

constexpr std::size_t most_vertices = 16;  // of a piece, so that it has two triangles less

/// Whether positions run evenly with texture coordinates: those of three corners say where all others are.
bool is_even(const std::vector<Place>& places, const SpritePiece& piece) {
  if (piece.outline.size() < 3 || piece.outline.size() > most_vertices ||
      piece.triangles.size() + 2 != piece.outline.size()) {
    return false;
  }
  const auto uv = [&](std::uint32_t vertex) { return glm::dvec2(places[vertex][3], places[vertex][4]); };
  const auto position = [&](std::uint32_t vertex) {
    return glm::dvec3(places[vertex][0], places[vertex][1], places[vertex][2]);
  };
  // The three that span most of the image.
  std::array<std::uint32_t, 3> corner{};
  double most = 0;
  const auto turn = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  for (std::size_t i = 0; i < piece.outline.size(); ++i) {
    for (std::size_t j = i + 1; j < piece.outline.size(); ++j) {
      for (std::size_t k = j + 1; k < piece.outline.size(); ++k) {
        const std::array<std::uint32_t, 3> three{piece.outline[i], piece.outline[j], piece.outline[k]};
        const double area = std::abs(turn(uv(three[1]) - uv(three[0]), uv(three[2]) - uv(three[0])));
        if (area > most) most = area, corner = three;
      }
    }
  }
  if (!(most > 0)) return false;
  const glm::dvec2 p = uv(corner[1]) - uv(corner[0]), q = uv(corner[2]) - uv(corner[0]);
  const glm::dvec3 along_p = position(corner[1]) - position(corner[0]),
                   along_q = position(corner[2]) - position(corner[0]);
  const double size = glm::length(along_p) + glm::length(along_q);
  return std::ranges::all_of(piece.outline, [&](std::uint32_t vertex) {
    const glm::dvec2 from = uv(vertex) - uv(corner[0]);
    const glm::dvec3 expected =
        position(corner[0]) + along_p * (turn(from, q) / turn(p, q)) + along_q * (turn(p, from) / turn(p, q));
    return glm::distance(expected, position(vertex)) <= 1e-4 * size;
  });
}

template <class Holds>
bool are_all(const Draw& draw, std::uint32_t texcoord, std::size_t most_triangles, Holds&& holds) {
  if (draw.topology != Topology::triangles || has_larger_piece(draw.full(), most_triangles)) return false;
  const std::vector<SpritePiece> pieces = sprite_pieces(draw, texcoord);
  if (pieces.empty()) return false;
  const std::vector<Place> places = places_of(*draw.full().vertices, texcoord);
  return std::ranges::all_of(pieces, [&](const SpritePiece& piece) { return holds(places, piece); });
}

}  // namespace

std::vector<SpritePiece> sprite_pieces(const Draw& draw, std::uint32_t texcoord) {
  if (draw.topology != Topology::triangles) return {};
  const Level& level = draw.full();
  const std::vector<Place> places = places_of(*level.vertices, texcoord);
  if (places.size() < level.vertices->count || places.empty()) return {};
  const std::vector<std::uint32_t> first = first_at(places);
  const auto indices = level.orders[0].indices.view();
  const std::size_t count = indices.size() / 3;

  Groups groups(places.size());
  const auto triangle = [&](std::size_t t) -> Triangle {
    return {first[indices[3 * t]], first[indices[3 * t + 1]], first[indices[3 * t + 2]]};
  };
  for (std::size_t t = 0; t < count; ++t) {
    const Triangle corners = triangle(t);
    for (std::size_t i = 1; i < 3; ++i) groups.join(groups.root(corners[i]), groups.root(corners[0]));
  }
  std::vector<SpritePiece> pieces;
  std::vector<std::uint32_t> piece_of(places.size(), ~std::uint32_t{0});
  for (std::size_t t = 0; t < count; ++t) {
    std::uint32_t& number = piece_of[groups.root(triangle(t)[0])];
    if (number == ~std::uint32_t{0}) {
      number = static_cast<std::uint32_t>(pieces.size());
      pieces.emplace_back();
    }
    pieces[number].triangles.push_back(static_cast<std::uint32_t>(t));
  }
  for (SpritePiece& piece : pieces) {
    std::vector<Triangle> triangles;
    for (const std::uint32_t t : piece.triangles) triangles.push_back(triangle(t));
    piece.outline = outline_of(triangles);
  }
  return pieces;
}

bool is_made_of_quads(const Draw& draw, std::uint32_t texcoord) { return are_all(draw, texcoord, 2, is_quad); }

bool is_made_of_sprites(const Draw& draw, std::uint32_t texcoord) {
  return are_all(draw, texcoord, most_vertices - 2, is_even);
}

}  // namespace foredraw
