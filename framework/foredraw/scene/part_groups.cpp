#include <foredraw/scene/part_groups.h>

#include <foredraw/scene/walk.h>

#include <algorithm>

namespace foredraw {

namespace {

constexpr std::size_t no_subject = ~std::size_t{0};

/// Collects runs, one behind the other, until something that stays ends them.
class RunsInARow {
 public:
  explicit RunsInARow(std::vector<PartGroup>& groups) : groups_(groups) {}

  void add(std::uint32_t first, std::uint32_t end) {
    if (group_.offsets.empty()) group_.offsets.push_back(first);
    group_.offsets.push_back(end);
  }

  void finish() {
    if (group_.offsets.size() > 2) groups_.push_back(group_);
    group_.offsets.clear();
  }

 private:
  std::vector<PartGroup>& groups_;
  PartGroup group_;
};

/// The parts at and below each node: [first, end).
struct Runs {
  std::vector<std::uint32_t> first, end;
};

Runs runs_below(const Scene& scene, std::span<const NodeId> walk, std::span<const SubjectPart> parts) {
  Runs below{std::vector<std::uint32_t>(scene.nodes.size(), 0), std::vector<std::uint32_t>(scene.nodes.size(), 0)};
  std::uint32_t part = 0;
  for (const NodeId node : walk) {
    below.first[node] = part;
    while (part < parts.size() && parts[part].node == node) ++part;
    below.end[node] = part;
  }
  for (auto node = walk.rbegin(); node != walk.rend(); ++node) {
    for (const NodeId child : scene.nodes[*node].children) {
      below.end[*node] = std::max(below.end[*node], below.end[child]);
    }
  }
  return below;
}

/// The roots that the scene names: the others have no place that could be another one.
std::vector<NodeId> named_roots(const Scene& scene) {
  std::vector<char> is_named(scene.nodes.size(), 0);
  for (const NodeId node : scene.roots) is_named[node] = 1;
  std::vector<NodeId> roots = roots_of(scene);
  std::erase_if(roots, [&](NodeId node) { return is_named[node] == 0; });
  return roots;
}

/// The things that have a rank change places among themselves, so that their ranks rise.
template <class Thing, class RankOf>
void sort_ranked(std::vector<Thing>& things, RankOf rank_of) {
  std::vector<Thing> ranked;
  std::ranges::copy_if(things, std::back_inserter(ranked),
                       [&](const Thing& thing) { return rank_of(thing).has_value(); });
  std::ranges::stable_sort(ranked, {}, rank_of);
  auto next = ranked.begin();
  for (Thing& thing : things) {
    if (rank_of(thing)) thing = *next++;
  }
}

}  // namespace

PartGroups::PartGroups(const Scene& scene, std::span<const Subject> subjects,
                       const std::function<bool(DrawId)>& may_move)
    : scene_(scene),
      subjects_(subjects),
      walk_(walk(scene)),
      first_subject_(scene.draws.size(), no_subject),
      placed_subject_(scene.nodes.size(), no_subject) {
  for (DrawId draw = 0; draw < scene.draws.size(); ++draw) is_fixed_.push_back(may_move(draw) ? 0 : 1);
  for (const Node& node : scene.nodes) {
    if (!node.mesh || !node.keeps_mesh) continue;
    for (const DrawId draw : scene.meshes[*node.mesh].draws) is_fixed_[draw] = 1;
  }
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    for (const auto& [draw, node] : subjects[s].parts) {
      first_subject_[draw] = std::min(first_subject_[draw], s);
      if (node) placed_subject_[*node] = s;
    }
  }
}

/// [node] whether anything at or below it stays where it is.
std::vector<char> PartGroups::fences_for(std::size_t subject) const {
  std::vector<char> is_fence(scene_.nodes.size(), 0);
  for (auto n = walk_.rbegin(); n != walk_.rend(); ++n) {
    const Node& node = scene_.nodes[*n];
    const bool is_others = placed_subject_[*n] != no_subject && placed_subject_[*n] != subject;
    bool stays = node.keeps_mesh || is_others;
    if (node.mesh) {
      for (const DrawId draw : scene_.meshes[*node.mesh].draws) stays = stays || is_fixed(draw, subject);
    }
    for (const NodeId child : node.children) stays = stays || is_fence[child] != 0;
    is_fence[*n] = stays ? 1 : 0;
  }
  return is_fence;
}

/// Of one mesh.
void PartGroups::add_draws(std::size_t subject, std::uint32_t first, std::uint32_t end,
                           std::vector<PartGroup>& groups) const {
  RunsInARow runs(groups);
  for (std::uint32_t part = first; part < end; ++part) {
    const DrawId draw = subjects_[subject].parts[part].draw;
    if (is_fixed(draw, subject)) {
      runs.finish();
    } else {
      runs.add(part, part + 1);
    }
  }
  runs.finish();
}

std::vector<PartGroup> PartGroups::of(std::size_t subject) const {
  std::vector<PartGroup> groups;
  const std::vector<SubjectPart>& parts = subjects_[subject].parts;
  if (parts.size() < 2) return groups;
  if (parts.front().node == parts.back().node) {
    add_draws(subject, 0, static_cast<std::uint32_t>(parts.size()), groups);
    return groups;
  }
  std::vector<std::uint32_t> shown(scene_.meshes.size(), 0);
  const Runs below = runs_below(scene_, walk_, parts);
  const std::vector<char> is_fence = fences_for(subject);
  for (NodeId node = 0; node < scene_.nodes.size(); ++node) {
    if (placed_subject_[node] == subject) ++shown[*scene_.nodes[node].mesh];
  }
  const auto add_siblings = [&](std::span<const NodeId> siblings) {
    RunsInARow runs(groups);
    for (const NodeId node : siblings) {
      if (is_fence[node] != 0) {
        runs.finish();
      } else if (below.first[node] < below.end[node]) {
        runs.add(below.first[node], below.end[node]);
      }
    }
    runs.finish();
  };
  for (auto n = walk_.rbegin(); n != walk_.rend(); ++n) {
    const Node& node = scene_.nodes[*n];
    if (placed_subject_[*n] == subject && shown[*node.mesh] == 1) {
      const auto draws = static_cast<std::uint32_t>(scene_.meshes[*node.mesh].draws.size());
      add_draws(subject, below.first[*n], below.first[*n] + draws, groups);
    }
    add_siblings(node.children);
  }
  add_siblings(named_roots(scene_));
  return groups;
}

std::vector<PartGroup> free_groups(const Subject& subject, std::vector<DrawId> draws) {
  std::ranges::sort(draws);
  std::vector<PartGroup> groups;
  RunsInARow runs(groups);
  for (std::uint32_t part = 0; part < subject.parts.size(); ++part) {
    if (std::ranges::binary_search(draws, subject.parts[part].draw)) {
      runs.add(part, part + 1);
    } else {
      runs.finish();
    }
  }
  runs.finish();
  return groups;
}

bool is_allowed(std::span<const std::uint32_t> sequence, std::span<const PartGroup> groups) {
  // Undone from the outermost group inwards, so that each group is found where it was.
  std::vector<std::uint32_t> undone(sequence.begin(), sequence.end());
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    const std::vector<std::uint32_t>& offsets = group->offsets;
    const auto run_of = [&](std::uint32_t part) { return std::ranges::upper_bound(offsets, part) - offsets.begin(); };
    if (offsets.back() > undone.size()) return false;
    const auto first = undone.begin() + offsets.front();
    const auto end = undone.begin() + offsets.back();
    std::size_t runs = 1;
    for (auto part = first; part != end; ++part) {
      if (part != first && run_of(*part) != run_of(*(part - 1))) ++runs;
    }
    if (runs != group->count()) return false;  // one was torn, or parts came in from outside
    std::stable_sort(first, end, [&](std::uint32_t a, std::uint32_t b) { return run_of(a) < run_of(b); });
  }
  for (std::uint32_t part = 0; part < undone.size(); ++part) {
    if (undone[part] != part) return false;
  }
  return true;
}

void put_in_sequence(Scene& scene, std::span<const std::vector<SubjectPart>> subjects) {
  using Rank = std::optional<std::uint32_t>;
  std::vector<Rank> of_draw(scene.draws.size());
  const std::vector<NodeId> walked = walk(scene);
  for (const std::vector<SubjectPart>& parts : subjects) {
    std::vector<Rank> of_node(parts.front().node ? scene.nodes.size() : 0);
    for (std::uint32_t rank = 0; rank < parts.size(); ++rank) {
      const auto& [draw, node] = parts[rank];
      if (!of_draw[draw]) of_draw[draw] = rank;
      if (node && !of_node[*node]) of_node[*node] = rank;
    }
    if (of_node.empty()) continue;
    for (auto n = walked.rbegin(); n != walked.rend(); ++n) {
      std::vector<NodeId>& children = scene.nodes[*n].children;
      for (const NodeId child : children) {
        if (of_node[child]) of_node[*n] = std::min(of_node[*n].value_or(*of_node[child]), *of_node[child]);
      }
      sort_ranked(children, [&](NodeId child) { return of_node[child]; });
    }
    sort_ranked(scene.roots, [&](NodeId root) { return of_node[root]; });
  }
  for (Mesh& mesh : scene.meshes) sort_ranked(mesh.draws, [&](DrawId draw) { return of_draw[draw]; });
}

}  // namespace foredraw
