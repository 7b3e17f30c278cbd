#include <foredraw/collapses/wedge_shares.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

double dot(const glm::dvec3& a, const glm::dvec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
glm::dvec3 cross(const glm::dvec3& a, const glm::dvec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace

void WedgeShares::start(glm::vec3 place) {
  place_ = place;
  area_ = 0;
  faces_ = 0;
  shares_.clear();
}

void WedgeShares::add(const std::array<glm::vec3, 3>& corners, const std::array<std::uint32_t, 3>& vertices) {
  constexpr double flattest = 0.01;  // height over length; narrower ones tell rounding
  if (++faces_ > most_faces) return;
  const glm::dvec3 from(corners[0]), to = place_ - from;
  const glm::dvec3 one = glm::dvec3(corners[1]) - from, two = glm::dvec3(corners[2]) - from;
  const glm::dvec3 normal = cross(one, two);
  const double squared = dot(normal, normal);
  const double longest = flattest * std::max({dot(one, one), dot(two, two), dot(two - one, two - one)});
  if (!(squared > longest * longest) || !std::isfinite(squared)) return;
  const double of_one = dot(cross(two, normal), to) / squared, of_two = dot(cross(normal, one), to) / squared;
  const double area = std::sqrt(squared);
  add(vertices[0], area * (1 - of_one - of_two));
  add(vertices[1], area * of_one);
  add(vertices[2], area * of_two);
  area_ += area;
}

void WedgeShares::add(std::uint32_t vertex, double share) {
  const auto known = std::ranges::find(shares_, vertex, &WedgeShare::vertex);
  if (known == shares_.end()) {
    shares_.push_back({vertex, share});
  } else {
    known->share += share;
  }
}

std::span<const WedgeShare> WedgeShares::finish() {
  constexpr double most = 4;  // a regular ring has 1.8
  if (!(area_ > 0) || faces_ > most_faces) return {};
  double sum = 0;
  for (WedgeShare& one : shares_) {
    one.share /= area_;
    sum += std::abs(one.share);
  }
  return sum <= most ? std::span<const WedgeShare>(shares_) : std::span<const WedgeShare>();
}

}  // namespace foredraw
