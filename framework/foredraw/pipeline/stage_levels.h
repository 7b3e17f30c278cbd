#pragma once
// What a stage works on: which levels of which draws, and the scene as it is at each level.

#include <foredraw/pipeline/eligible.h>
#include <foredraw/pipeline/ranges.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/subject.h>

#include <optional>
#include <vector>

namespace foredraw {

struct LevelSkip {
  DrawLevel at;
  Skip why;
};

struct SubjectLevel {
  std::uint32_t subject = 0;
  std::size_t level = 0;
  std::vector<DrawId> draws;  ///< that may be ordered anew
};

class StageLevels {
 public:
  /// The scene stays where it is, and as it is until all answers are in.
  StageLevels(const PlannedStage& stage, const Scene& scene, const ProductRows& products);

  const std::vector<DrawLevel>& levels() const { return levels_; }
  /// Of which full detail is among them.
  const std::vector<DrawId>& draws() const { return draws_; }
  /// What is left alone; levels of a draw that share a reason with the one before are not repeated.
  const std::vector<LevelSkip>& skips() const { return skips_; }
  /// Whether each of the subject's draws is left alone for a reason of its own, at full detail at least.
  bool skips_all_of(const Subject& subject) const;

  const Scene& scene_at(std::size_t level) const { return at_level_.empty() ? scene_ : at_level_[level]; }
  /// Null where no product of the scene counts on ranges there.
  const RangedScene* ranges_at(std::size_t level) const {
    return level < ranged_.size() && ranged_[level] ? &*ranged_[level] : nullptr;
  }

  /// Every subject at full detail, and at each coarser level at which it has something to order. A draw that is in
  /// several subjects belongs to the first.
  std::vector<SubjectLevel> of(const std::vector<Subject>& subjects) const;

 private:
  void choose(const PlannedStage& stage, DrawId id, const Holders& holders);

  const Scene& scene_;
  std::vector<DrawLevel> levels_;
  std::vector<DrawId> draws_;
  std::vector<LevelSkip> skips_;
  std::vector<Scene> at_level_;                     ///< [level]; empty where no draw has several
  std::vector<std::optional<RangedScene>> ranged_;  ///< [level]; empty where the scene has no products
};

}  // namespace foredraw
