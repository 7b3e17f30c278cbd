#include <foredraw/viewing/distinct_poses.h>

#include <foredraw/base/content_hash.h>
#include <foredraw/viewing/drawn_orders.h>
#include <foredraw/viewing/posed_positions.h>

#include <map>
#include <set>

namespace foredraw {

namespace {

/// Of the positions of all parts, which way their faces turn, and the orders in which they are drawn.
Stamp looks(const Scene& scene, const Subject& subject, const Pose& pose, const PosedNodes& nodes) {
  std::vector<Stamp> stamps = {orders_stamp(scene, subject, pose)};
  if (!subject.is_placed()) return stamps[0];
  for (const SubjectPart& part : subject.parts) {
    stamps.push_back(content_hash(std::span<const glm::vec3>(posed_positions(scene, part, nodes))));
    stamps.push_back({0, is_mirrored(part, nodes)});
  }
  return combine(stamps);
}

}  // namespace

std::vector<DistinctPoses> distinct_poses(const Scene& scene, std::span<const Subject> subjects, const Poses& poses,
                                          const Executor& executor) {
  const std::size_t count = poses.poses.size();
  std::vector<std::vector<Stamp>> stamps(count, std::vector<Stamp>(subjects.size()));  // [pose][subject]
  if (count > 1) {
    executor.for_each(count, [&](std::size_t pose) {
      const PosedNodes nodes = posed_nodes(scene, poses.poses[pose]);
      for (std::size_t i = 0; i < subjects.size(); ++i) {
        stamps[pose][i] = looks(scene, subjects[i], poses.poses[pose], nodes);
      }
    });
  }
  std::vector<DistinctPoses> distinct(subjects.size());
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    std::map<Stamp, std::size_t> seen;
    distinct[i].weights.resize(count);
    for (std::size_t pose = 0; pose < count; ++pose) {
      const std::size_t first = seen.emplace(stamps[pose][i], pose).first->second;
      distinct[i].first_alike.push_back(first);
      distinct[i].weights[first] += poses.poses[pose].weight;
    }
  }
  return distinct;
}

std::size_t count_different(std::span<const DistinctPoses> subjects) {
  std::set<std::size_t> different;
  for (const DistinctPoses& subject : subjects)
    different.insert(subject.first_alike.begin(), subject.first_alike.end());
  return different.size();
}

std::string poses_text(std::size_t poses, std::size_t different) {
  const std::string all = std::to_string(poses) + " poses";
  return different == poses ? all : all + " (" + std::to_string(different) + " different)";
}

}  // namespace foredraw
