#pragma once
// A quick search for what is hidden of small scenes.

#include "hidden_shapes.h"
#include "plugins/processors/hidden/hidden_search.h"
#include "plugins/processors/hidden/standing_parts.h"

#include <algorithm>

namespace foredraw::testing {

using processors::hidden::HiddenSearchOptions;

inline HiddenSearchOptions searched() {
  HiddenSearchOptions options;
  options.views = 80;
  options.size = 128;
  options.rays = 128;
  options.checks = 30;
  return options;
}

/// [draw] how many of its triangles are hidden, where it may be asked at all.
inline std::vector<std::size_t> hidden_of(const Scene& scene, const HiddenSearchOptions& options = searched()) {
  std::vector<DrawId> asked;
  const std::vector<std::string> why = processors::hidden::why_they_stay(scene, options.subjects);
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    if (why[id].empty()) asked.push_back(id);
  }
  const auto found = processors::hidden::find_hidden(
      scene, asked, options, [] {}, Executor(2));
  std::vector<std::size_t> counts(scene.draws.size(), 0);
  for (const auto& [id, flags] : found.hidden) counts[id] = static_cast<std::size_t>(std::ranges::count(flags, 1));
  return counts;
}

inline HiddenSearchOptions as_scene(HiddenSearchOptions options = searched()) {
  options.subjects = SubjectUnit::scene;
  return options;
}

/// A clip that carries the node away.
inline void add_clip(Scene& scene, NodeId node, glm::vec3 to) {
  AnimationChannel channel;
  channel.node = node;
  channel.times = Shared(std::vector<float>{0, 1});
  channel.values = Shared(std::vector<float>{0, 0, 0, to.x, to.y, to.z});
  Animation clip;
  clip.channels.push_back(channel);
  scene.animations.push_back(clip);
}

using Counts = std::vector<std::size_t>;
inline const Counts inner_goes{0, 12}, all_stay{0, 0};

}  // namespace foredraw::testing
