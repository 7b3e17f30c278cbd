#pragma once
// Which parts of a subject may be drawn in another sequence, as far as a file can hold it: the draws of a mesh may
// change places, and so may what hangs below the children of a node, or below the roots of the scene. No number
// changes.

#include <foredraw/scene/subject.h>

#include <functional>
#include <span>
#include <vector>

namespace foredraw {

/// Runs of a subject's parts that may change places: run i is [offsets[i], offsets[i + 1]). A run stays together; other
/// groups may lie within it.
struct PartGroup {
  std::vector<std::uint32_t> offsets;

  std::size_t count() const { return offsets.size() - 1; }
  friend bool operator==(const PartGroup&, const PartGroup&) = default;
};

/// The groups of a scene's subjects.
class PartGroups {
 public:
  /// A draw that may not move stays where it is, and nothing passes it. A draw of several subjects moves in the first.
  PartGroups(const Scene& scene, std::span<const Subject> subjects, const std::function<bool(DrawId)>& may_move);

  /// Groups within a run come before the group that the run belongs to. What the file says more of stays, and so does
  /// what belongs to another subject that nodes show. Where several nodes of the subject show a mesh, its draws keep
  /// their sequence: each node would want its own. O(parts) where one node shows them or none, else O(nodes + parts).
  std::vector<PartGroup> of(std::size_t subject) const;

 private:
  bool is_fixed(DrawId draw, std::size_t subject) const {
    return is_fixed_[draw] != 0 || first_subject_[draw] < subject;
  }
  std::vector<char> fences_for(std::size_t subject) const;
  void add_draws(std::size_t subject, std::uint32_t first, std::uint32_t end, std::vector<PartGroup>& groups) const;

  const Scene& scene_;
  std::span<const Subject> subjects_;
  std::vector<NodeId> walk_;
  std::vector<char> is_fixed_;               ///< [draw]
  std::vector<std::size_t> first_subject_;   ///< [draw] that it belongs to
  std::vector<std::size_t> placed_subject_;  ///< [node] that it shows a part of
};

/// Which parts may change places where no file has to hold their sequence: those of these draws. All others stay
/// where they are, and nothing passes them.
std::vector<PartGroup> free_groups(const Subject& subject, std::vector<DrawId> draws);

/// Whether the parts come in this sequence, [rank] = part, where nothing but runs of groups changed places. Groups
/// within a run come before the group that the run belongs to. O(parts in groups * log runs).
bool is_allowed(std::span<const std::uint32_t> sequence, std::span<const PartGroup> groups);

/// Brings the draws of meshes, the children of nodes and the roots of the scene into the sequences in which subjects'
/// parts shall be drawn: [subject][rank], each allowed by the subject's groups.
void put_in_sequence(Scene& scene, std::span<const std::vector<SubjectPart>> subjects);

}  // namespace foredraw
