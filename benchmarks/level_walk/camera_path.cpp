#include "camera_path.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vec2.hpp>

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

double length_of(const glm::dvec3& vector) { return std::sqrt(glm::dot(vector, vector)); }

glm::dvec3 towards(const glm::dvec3& from, const glm::dvec3& to, double distance) {
  return from + (to - from) * (distance / length_of(to - from));
}

/// The way as many short pieces.
std::vector<glm::dvec3> fine_way(const CameraPath& path) {
  constexpr int pieces = 64;  // of a corner
  const auto& corners = path.corners;
  std::vector<glm::dvec3> way = {corners.front()};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const glm::dvec3 in = towards(corners[i], corners[i - 1], path.rounding);
    const glm::dvec3 out = towards(corners[i], corners[i + 1], path.rounding);
    for (int k = 0; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces, s = 1 - t;
      way.push_back(s * s * in + 2 * s * t * corners[i] + t * t * out);
    }
  }
  way.push_back(corners.back());
  return way;
}

/// Where a way is after a distance; beyond its end it goes on straight.
class Way {
 public:
  explicit Way(std::vector<glm::dvec3> points) : points_(std::move(points)) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      ends_.push_back((i == 1 ? 0 : ends_.back()) + length_of(points_[i] - points_[i - 1]));
    }
  }

  double length() const { return ends_.back(); }

  glm::dvec3 at(double distance) const {
    const auto found = std::ranges::lower_bound(ends_, distance);
    const auto piece = static_cast<std::size_t>(std::min(found - ends_.begin(), std::ssize(ends_) - 1));
    const double start = piece == 0 ? 0 : ends_[piece - 1];
    return towards(points_[piece], points_[piece + 1], distance - start);
  }

 private:
  std::vector<glm::dvec3> points_;
  std::vector<double> ends_;  ///< [piece] how far it is to its end
};

/// The turn about +Y and then about the camera's own +X that brings its -Z to a direction; it is not upright.
glm::dquat looking(const glm::dvec3& direction) {
  const double level = std::sqrt(direction.x * direction.x + direction.z * direction.z), length = length_of(direction);
  // Half the angle of a turn, from its whole cosine.
  const auto half_turn = [](double cosine, double sine) {
    const double half_cosine = std::sqrt(std::max(0.0, (1 + cosine) / 2));
    const double half_sine = std::sqrt(std::max(0.0, (1 - cosine) / 2));
    return glm::dvec2(half_cosine, sine < 0 ? -half_sine : half_sine);
  };
  const glm::dvec2 yaw = half_turn(-direction.z / level, -direction.x);
  const glm::dvec2 pitch = half_turn(level / length, direction.y);
  return glm::dquat(yaw.x, 0, yaw.y, 0) * glm::dquat(pitch.x, pitch.y, 0, 0);
}

}  // namespace

std::vector<glm::dvec3> places_on(const CameraPath& path, std::size_t steps) {
  const Way way(fine_way(path));
  std::vector<glm::dvec3> places;
  for (std::size_t i = 0; i <= steps; ++i) {
    places.push_back(way.at(way.length() * static_cast<double>(i) / static_cast<double>(steps)));
  }
  return places;
}

void add_walk(GltfDocument& to, const CameraPath& path, const std::function<double(const glm::dvec3&)>& height) {
  const auto steps = static_cast<std::size_t>(30 * path.seconds);
  const Way way(fine_way(path));
  const auto raised = [&](glm::dvec3 place) {
    if (height) place.y += height(place);
    return place;
  };
  std::vector<float> times, places, turns;
  glm::dquat last(1, 0, 0, 0);
  for (std::size_t i = 0; i <= steps; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(steps), distance = way.length() * part;
    const glm::dvec3 place = raised(way.at(distance));
    glm::dquat turn = looking(raised(way.at(distance + path.ahead)) - place);
    if (glm::dot(turn, last) < 0) turn = -turn;
    last = turn;
    times.push_back(static_cast<float>(path.seconds * part));
    for (int k = 0; k < 3; ++k) places.push_back(static_cast<float>(place[k]));
    for (const double value : {turn.x, turn.y, turn.z, turn.w}) turns.push_back(static_cast<float>(value));
  }
  const std::size_t camera = to.add(
      "cameras",
      {{"type", "perspective"},
       {"perspective", {{"aspectRatio", 16.0 / 9}, {"yfov", 1.0471975511965976}, {"znear", 0.05}, {"zfar", 1000}}}});
  const std::vector<float> place(places.begin(), places.begin() + 3), turn(turns.begin(), turns.begin() + 4);
  const std::size_t node =
      to.add("nodes", {{"name", "camera"}, {"camera", camera}, {"translation", place}, {"rotation", turn}});
  to.json["scene"] = 0;
  to.json["scenes"][0]["nodes"].push_back(node);
  const std::size_t input = to.add_bounded(times, "SCALAR");
  const auto sampler = [&](std::size_t output) {
    return GltfDocument::Json{{"input", input}, {"interpolation", "LINEAR"}, {"output", output}};
  };
  const auto channel = [&](int number, const char* what) {
    return GltfDocument::Json{{"sampler", number}, {"target", {{"node", node}, {"path", what}}}};
  };
  to.add("animations",
         {{"name", "walk"},
          {"samplers", {sampler(to.add_values<float>(places, "VEC3")), sampler(to.add_values<float>(turns, "VEC4"))}},
          {"channels", {channel(0, "translation"), channel(1, "rotation")}}});
}

}  // namespace foredraw::bench
