// imported-poses-bench SCENE REFEREE...: how far a scene that was imported lies from what another reader makes of its
// file. REFEREE is what ufbx_poses.c wrote. One line of JSON for each pair of files.
#include <foredraw/io/scene_file.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/posed_positions.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace {

using namespace foredraw;
using Triangles = std::vector<glm::vec3>;  ///< three corners each

struct RefereePose {
  std::string clip;
  std::int32_t number = -1;  ///< of the clip; -1: at rest
  double seconds = 0;
  Triangles triangles;
};

std::vector<RefereePose> read_referee(const char* path) {
  std::ifstream from(path, std::ios::binary);
  const auto get = [&](void* to, std::size_t bytes) {
    if (!from.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes))) throw std::runtime_error("too short");
  };
  std::uint32_t count = 0;
  get(&count, sizeof count);
  std::vector<RefereePose> poses(count);
  for (RefereePose& pose : poses) {
    std::uint32_t length = 0;
    std::uint64_t triangles = 0;
    get(&length, sizeof length);
    pose.clip.resize(length);
    get(pose.clip.data(), length);
    get(&pose.number, sizeof pose.number);
    get(&pose.seconds, sizeof pose.seconds);
    get(&triangles, sizeof triangles);
    pose.triangles.resize(3 * triangles);
    get(pose.triangles.data(), pose.triangles.size() * sizeof(glm::vec3));
  }
  return poses;
}

Triangles drawn(const Scene& scene, const Pose& pose) {
  const PosedNodes nodes = posed_nodes(scene, pose);
  Triangles all;
  for (const Subject& subject : subjects_of(scene, SubjectUnit::scene)) {
    for (const SubjectPart& part : subject.parts) {
      const Draw& draw = scene.draws[part.draw];
      if (!part.node || draw.topology != Topology::triangles || draw.levels.empty()) continue;
      const std::vector<glm::vec3> positions = posed_positions(scene, part, nodes);
      if (draw.levels[0].orders.empty()) continue;
      for (const std::uint32_t vertex : draw.levels[0].orders[0].indices.view()) all.push_back(positions[vertex]);
    }
  }
  return all;
}

/// Points in a tree that is split at its middle in turn by each axis.
class Near {
 public:
  explicit Near(std::vector<glm::vec3> points) : points_(std::move(points)) { build(0, points_.size(), 0); }

  float squared_distance(const glm::vec3& to) const {
    float best = std::numeric_limits<float>::max();
    look(0, points_.size(), 0, to, best);
    return best;
  }

 private:
  void build(std::size_t begin, std::size_t end, int axis) {
    if (end - begin < 2) return;
    const std::size_t middle = (begin + end) / 2;
    const auto at = [&](std::size_t i) { return points_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    build(begin, middle, (axis + 1) % 3);
    build(middle + 1, end, (axis + 1) % 3);
  }

  void look(std::size_t begin, std::size_t end, int axis, const glm::vec3& to, float& best) const {
    if (begin >= end) return;
    const std::size_t middle = (begin + end) / 2;
    const glm::vec3 away = points_[middle] - to;
    best = std::min(best, glm::dot(away, away));
    const float across = to[axis] - points_[middle][axis];
    const bool is_left = across < 0;
    look(is_left ? begin : middle + 1, is_left ? middle : end, (axis + 1) % 3, to, best);
    if (across * across < best) look(is_left ? middle + 1 : begin, is_left ? end : middle, (axis + 1) % 3, to, best);
  }

  std::vector<glm::vec3> points_;
};

float farthest(const Triangles& from, const Triangles& to) {
  if (from.empty() || to.empty()) return from.empty() == to.empty() ? 0 : std::numeric_limits<float>::infinity();
  const Near near(to);
  float most = 0;
  for (const glm::vec3& point : from) most = std::max(most, near.squared_distance(point));
  return std::sqrt(most);
}

double area(const Triangles& triangles) {
  double sum = 0;
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const glm::dvec3 a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
    sum += glm::length(glm::cross(b - a, c - a)) / 2;
  }
  return sum;
}

/// Signed, so that triangles that are turned round show.
double volume(const Triangles& triangles) {
  double sum = 0;
  const glm::dvec3 from = triangles.empty() ? glm::dvec3(0) : glm::dvec3(triangles[0]);
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    const glm::dvec3 a = triangles[i], b = triangles[i + 1], c = triangles[i + 2];
    sum += glm::dot(a - from, glm::cross(b - from, c - from)) / 6;
  }
  return sum;
}

double diagonal(const Triangles& triangles) {
  glm::vec3 low(std::numeric_limits<float>::max()), high(std::numeric_limits<float>::lowest());
  for (const glm::vec3& point : triangles) low = glm::min(low, point), high = glm::max(high, point);
  return triangles.empty() ? 1 : std::max(1e-30, static_cast<double>(glm::length(high - low)));
}

/// By its name where one alone has it, else by its number.
std::optional<AnimationId> clip_of(const Scene& scene, const RefereePose& pose) {
  std::optional<AnimationId> found;
  std::size_t count = 0;
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    if (scene.animations[i].name == pose.clip) found = static_cast<AnimationId>(i), ++count;
  }
  if (count == 1) return found;
  const auto number = static_cast<std::size_t>(pose.number);
  return number < scene.animations.size() ? std::optional(static_cast<AnimationId>(number)) : std::nullopt;
}

int compare(const char* path, const char* referee) {
  Diagnostics diagnostics;
  const auto file = read_scene(path, diagnostics, {});
  if (!file) {
    std::fputs(to_text(diagnostics).c_str(), stderr);
    return 1;
  }
  double at_rest = 0, in_motion = 0, areas = 0, volumes = 0;
  std::size_t poses = 0, without_clip = 0, ours = 0, theirs = 0;
  std::string worst;
  for (const RefereePose& pose : read_referee(referee)) {
    Pose wanted;
    if (pose.number >= 0) {
      wanted.clip = clip_of(file->scene, pose);
      wanted.time = pose.seconds;
      if (!wanted.clip) {
        ++without_clip;
        continue;
      }
    }
    const Triangles made = drawn(file->scene, wanted);
    const double size = diagonal(pose.triangles);
    const double error = std::max(farthest(made, pose.triangles), farthest(pose.triangles, made)) / size;
    ++poses;
    if (pose.number < 0) {
      ours = made.size() / 3;
      theirs = pose.triangles.size() / 3;
      at_rest = error;
    } else if (error > in_motion) {
      in_motion = error;
      worst = fmt::format("{}@{:.3f}", pose.clip, pose.seconds);
    }
    areas = std::max(areas, std::abs(area(made) / std::max(1e-30, area(pose.triangles)) - 1));
    volumes = std::max(volumes, std::abs(volume(made) - volume(pose.triangles)) / (size * size * size));
  }
  const nlohmann::json line{{"triangles", ours},
                            {"expected", theirs},
                            {"clips", file->scene.animations.size()},
                            {"poses", poses},
                            {"poses_without_clip", without_clip},
                            {"at_rest", at_rest},
                            {"in_motion", in_motion},
                            {"worst", worst},
                            {"area", areas},
                            {"volume", volumes}};
  std::puts(line.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace).c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("imported-poses-bench SCENE REFEREE\n", stderr), 2;
  try {
    return compare(argv[1], argv[2]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[2], error.what());
    return 1;
  }
}
