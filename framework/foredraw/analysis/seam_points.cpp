#include <foredraw/analysis/seam_points.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::uint32_t most_factor = 64;
constexpr double texels_apart = 1.5;

double squared_length(const EdgeSide& side, glm::uvec2 size) {
  const double x = (static_cast<double>(side.uv[1].x) - static_cast<double>(side.uv[0].x)) * size.x;
  const double y = (static_cast<double>(side.uv[1].y) - static_cast<double>(side.uv[0].y)) * size.y;
  return x * x + y * y;
}

glm::ivec2 place_of(glm::vec2 uv, const foredraw_height_map& map) {
  return {foredraw_height_place(uv.x, map.width), foredraw_height_place(uv.y, map.height)};
}

glm::ivec2 place_between(const EdgeSide& side, std::uint32_t step, std::uint32_t factor,
                         const foredraw_height_map& map) {
  const std::uint32_t weights[3] = {65536 - 65536 / factor * step, 65536 / factor * step, 0};
  const glm::ivec2 from = place_of(side.uv[0], map), to = place_of(side.uv[1], map);
  const std::int32_t x[3] = {from.x, to.x, 0}, y[3] = {from.y, to.y, 0};
  return {foredraw_height_between(x, weights), foredraw_height_between(y, weights)};
}

}  // namespace

std::vector<std::uint32_t> seam_factors(const SeamEdges& seams, glm::uvec2 size) {
  std::vector<std::uint32_t> factors;
  for (const SharedEdge& edge : seams.edges) {
    std::uint32_t factor = edge.kind == EdgeKind::seam ? most_factor : 0;
    for (const EdgeSide& side : seams.sides_of(edge)) {
      const double length = squared_length(side, size);
      const auto is_too_close = [&] { return length < texels_apart * texels_apart * factor * factor; };
      while (factor > 1 && is_too_close()) factor /= 2;
    }
    factors.push_back(factor);
  }
  return factors;
}

SeamPoints seam_points(const SeamEdges& seams, std::span<const std::uint32_t> factors, const foredraw_height_map& map) {
  SeamPoints all;
  all.factors.assign(factors.begin(), factors.end());
  const auto first_place = [&] { return static_cast<std::uint32_t>(all.places.size()); };
  for (const UvCorner& corner : seams.corners) {
    all.points.push_back({SeamPoint::no_edge, 0, first_place(), corner.uv_count});
    for (const glm::vec2 uv : seams.uvs_of(corner)) all.places.push_back(place_of(uv, map));
  }
  for (std::uint32_t e = 0; e < seams.edges.size(); ++e) {
    for (std::uint32_t step = 1; step < factors[e]; ++step) {
      all.points.push_back({e, step, first_place(), seams.edges[e].side_count});
      for (const EdgeSide& side : seams.sides_of(seams.edges[e])) {
        all.places.push_back(place_between(side, step, factors[e], map));
      }
    }
  }
  return all;
}

std::vector<bool> unequal_points(const SeamPoints& points, const foredraw_height_map& map, std::uint32_t bits) {
  std::vector<bool> is_unequal;
  for (const SeamPoint& point : points.points) {
    const auto height = [&](glm::ivec2 place) { return foredraw_displaced_height(&map, place.x, place.y, bits); };
    const auto places = points.places_of(point);
    is_unequal.push_back(std::ranges::any_of(
        places, [&, first = height(places[0])](glm::ivec2 place) { return height(place) != first; }));
  }
  return is_unequal;
}

std::vector<std::uint32_t> exact_factors(const SeamEdges& seams, const SeamPoints& points,
                                         const std::vector<bool>& is_unequal) {
  std::vector<std::uint32_t> exact = points.factors;
  for (std::size_t p = seams.corners.size(); p < points.points.size(); ++p) {
    if (!is_unequal[p]) continue;
    const SeamPoint& point = points.points[p];
    // A step is one of the smaller factors while it is a multiple of what they leave out.
    std::uint32_t& factor = exact[point.edge];
    while (factor > 1 && point.step % (points.factors[point.edge] / factor) == 0) factor /= 2;
  }
  const auto is_torn = [&](std::uint32_t point) {
    const auto corner = std::ranges::lower_bound(seams.corners, point, {}, &UvCorner::point);
    return corner != seams.corners.end() && corner->point == point && is_unequal[corner - seams.corners.begin()];
  };
  for (std::size_t e = 0; e < exact.size(); ++e) {
    if (exact[e] > 0 && (is_torn(seams.edges[e].points[0]) || is_torn(seams.edges[e].points[1]))) exact[e] = 0;
  }
  return exact;
}

}  // namespace foredraw
