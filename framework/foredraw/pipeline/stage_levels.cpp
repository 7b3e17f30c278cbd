#include <foredraw/pipeline/stage_levels.h>

#include <algorithm>
#include <utility>

namespace foredraw {

StageLevels::StageLevels(const PlannedStage& stage, const Scene& scene, const ProductRows& products) : scene_(scene) {
  const std::size_t most = most_levels(scene);
  const Holders holders = holders_of_draws(scene, products);
  for (DrawId id = 0; id < scene.draws.size(); ++id) choose(stage, id, holders);
  for (std::size_t level = 0; most > 1 && level < most; ++level) at_level_.push_back(at_level(scene, level));
  for (std::size_t level = 0; !scene.products.empty() && level < most; ++level) {
    ranged_.push_back(RangedScene::of(scene_at(level), scene, level, products));
  }
}

void StageLevels::choose(const PlannedStage& stage, DrawId id, const Holders& holders) {
  std::string told;
  for (std::size_t level = 0; level < scene_.draws[id].levels.size(); ++level) {
    auto skip = why_not(stage, scene_, id, traits_of(scene_.draws[id], level), holders);
    if (!skip) {
      levels_.push_back({id, level});
      if (level == 0) draws_.push_back(id);
    } else if (std::exchange(told, skip->reason) != skip->reason) {
      skips_.push_back({{id, level}, std::move(*skip)});
    }
  }
}

bool StageLevels::skips_all_of(const Subject& subject) const {
  return std::ranges::all_of(subject.parts, [&](const SubjectPart& part) {
    return std::ranges::binary_search(skips_, part.draw, {}, [](const LevelSkip& skip) { return skip.at.draw; });
  });
}

std::vector<SubjectLevel> StageLevels::of(const std::vector<Subject>& subjects) const {
  std::vector<SubjectLevel> parts;
  for (std::size_t level = 0; level < std::max<std::size_t>(at_level_.size(), 1); ++level) {
    std::vector<bool> is_free(scene_.draws.size(), false);
    for (const DrawLevel& chosen : levels_) is_free[chosen.draw] = is_free[chosen.draw] || chosen.level == level;
    for (std::uint32_t i = 0; i < subjects.size(); ++i) {
      SubjectLevel part{i, level, {}};
      for (const SubjectPart& of_subject : subjects[i].parts) {
        if (is_free[of_subject.draw]) part.draws.push_back(of_subject.draw);
        is_free[of_subject.draw] = false;
      }
      if (level == 0 || !part.draws.empty()) parts.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace foredraw
