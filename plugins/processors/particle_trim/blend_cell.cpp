#include "blend_cell.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::processors::particle_trim {

namespace {

void add_rounded(const glm::dvec2& place, const Box& box, std::vector<Point>& points) {
  const auto inside = [](double number, std::int64_t least, std::int64_t most) {
    return std::clamp(static_cast<std::int64_t>(number), least, most);
  };
  const std::int64_t left = inside(std::floor(place.x), box.least.x, box.most.x);
  const std::int64_t right = inside(std::ceil(place.x), box.least.x, box.most.x);
  const std::int64_t up = inside(std::floor(place.y), box.least.y, box.most.y);
  const std::int64_t down = inside(std::ceil(place.y), box.least.y, box.most.y);
  points.push_back({left, up});
  if (right != left) points.push_back({right, up});
  if (down != up) points.push_back({left, down});
  if (right != left && down != up) points.push_back({right, down});
}

}  // namespace

void BlendCell::add_shown(double threshold, const Box& frame, std::vector<Point>& points) const {
  const auto is_above = [&](std::uint16_t alpha) { return alpha > threshold; };
  if (std::ranges::none_of(alphas, is_above)) return;
  constexpr double side = static_cast<double>(steps_per_texel);
  Box box{corner, corner + Point{steps_per_texel, steps_per_texel}};
  box.least = {std::max(box.least.x, frame.least.x), std::max(box.least.y, frame.least.y)};
  box.most = {std::min(box.most.x, frame.most.x), std::min(box.most.y, frame.most.y)};
  if (box.least.x >= box.most.x || box.least.y >= box.most.y) return;

  // g = a + b u + c v + d u v is above 0 where it shows; u and v in steps from the corner.
  const double f00 = alphas[0], f10 = alphas[1], f01 = alphas[2], f11 = alphas[3];
  const double a = f00 - threshold, b = (f10 - f00) / side, c = (f01 - f00) / side;
  const double d = (f11 - f10 - f01 + f00) / (side * side);
  const glm::dvec2 origin(corner.x, corner.y);
  const auto g = [&](const glm::dvec2& p) { return a + b * p.x + c * p.y + d * p.x * p.y; };
  const double left = static_cast<double>(box.least.x) - origin.x, right = static_cast<double>(box.most.x) - origin.x;
  const double up = static_cast<double>(box.least.y) - origin.y, down = static_cast<double>(box.most.y) - origin.y;
  const std::array<glm::dvec2, 4> corners{{{left, up}, {right, up}, {right, down}, {left, down}}};
  std::array<glm::dvec2, 4> crossings;
  std::size_t count = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec2 &p = corners[i], &q = corners[(i + 1) % 4];
    const double from = g(p), to = g(q);
    if (from > 0) add_rounded(origin + p, box, points);
    if ((from > 0) != (to > 0)) crossings[count++] = p + (q - p) * (from / (from - to));
  }
  if (count == 4) {  // two branches, and little that lies between them: the whole cell
    for (const glm::dvec2& p : corners) add_rounded(origin + p, box, points);
    return;
  }
  for (std::size_t i = 0; i < count; ++i) add_rounded(origin + crossings[i], box, points);
  if (count != 2) return;
  // The branch lies on one side of its tangents. Where what shows does, too, it lies within them.
  const glm::dvec2 p = crossings[0], q = crossings[1];
  const auto slope = [&](const glm::dvec2& at) { return glm::dvec2(b + d * at.y, c + d * at.x); };
  const glm::dvec2 m = slope(p), n = slope(q);
  if (!(glm::dot(m, q - p) > 0)) return;
  const double turn = m.x * n.y - m.y * n.x;
  if (turn == 0) return;
  const double mp = glm::dot(m, p), nq = glm::dot(n, q);
  const glm::dvec2 meeting((mp * n.y - nq * m.y) / turn, (m.x * nq - n.x * mp) / turn);
  add_rounded(origin + glm::clamp(meeting, glm::min(p, q), glm::max(p, q)), box, points);
}

}  // namespace foredraw::processors::particle_trim
