#include "mesh_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace foredraw::processors::quadric_collapse {

namespace {

struct Place {
  std::array<float, 3> at{};
  std::uint32_t point = 0;
};

std::vector<Place> finite_places(std::span<const glm::vec3> points) {
  std::vector<Place> places(points.size());
  for (std::uint32_t p = 0; p < places.size(); ++p) {
    for (int k = 0; k < 3; ++k) places[p].at[k] = std::isfinite(points[p][k]) ? points[p][k] : 0.0f;
    places[p].point = p;
  }
  return places;
}

std::size_t longest_side(std::span<const Place> places) {
  constexpr float most = std::numeric_limits<float>::max();
  std::array<float, 3> low{most, most, most}, high{-most, -most, -most};
  for (const Place& place : places) {
    for (int k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], place.at[k]);
      high[k] = std::max(high[k], place.at[k]);
    }
  }
  const std::array<float, 3> length{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  return static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
}

}  // namespace

MeshPieces mesh_pieces(std::span<const glm::vec3> points, std::size_t most) {
  std::vector<Place> places = finite_places(points);
  std::vector<std::size_t> first{0, places.size()};
  for (std::size_t largest = places.size(); largest > most; largest -= largest / 2) {
    std::vector<std::size_t> halved{0};
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
      const auto part = std::span(places).first(first[i + 1]).subspan(first[i]);
      const std::size_t side = longest_side(part), half = part.size() / 2;
      std::ranges::nth_element(part, part.begin() + half, [side](const Place& a, const Place& b) {
        return a.at[side] < b.at[side] || (a.at[side] == b.at[side] && a.point < b.point);
      });
      halved.insert(halved.end(), {first[i] + half, first[i + 1]});
    }
    first = std::move(halved);
  }
  MeshPieces pieces;
  pieces.first.assign(first.begin(), first.end());
  pieces.points.resize(places.size());
  std::ranges::transform(places, pieces.points.begin(), &Place::point);
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    std::sort(pieces.points.begin() + first[i], pieces.points.begin() + first[i + 1]);
  }
  return pieces;
}

}  // namespace foredraw::processors::quadric_collapse
