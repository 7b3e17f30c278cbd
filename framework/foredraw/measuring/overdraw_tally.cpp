#include <foredraw/measuring/overdraw_tally.h>

namespace foredraw {

namespace {

void add(std::vector<OverdrawCount>& sum, std::span<const OverdrawCount> counts) {
  sum.resize(counts.size());
  for (std::size_t view = 0; view < counts.size(); ++view) sum[view] += counts[view];
}

}  // namespace

void OverdrawTally::add(std::span<const OverdrawCount> pictures, double weight) {
  views.resize(pictures.size());
  for (std::size_t view = 0; view < pictures.size(); ++view) {
    const OverdrawCount& picture = pictures[view];
    views[view].add(picture, weight);
    hidden += weight * static_cast<double>(picture.shaded - picture.visible);
    ties += weight * static_cast<double>(picture.ties);
    discarded += weight * static_cast<double>(picture.discarded);
    if (is_worse(picture, worst)) worst = picture;
  }
}

OverdrawTallies::OverdrawTallies(const SubjectsInPoses& looked, std::size_t views)
    : draws(looked.scene.draws.size()), subjects(looked.subjects.size()), non_finite(looked.subjects.size()) {
  const std::size_t count = looked.poses.poses.size();
  poses.assign(count, std::vector<ViewTally>(count <= most_told_poses ? views : 1));
}

void OverdrawTallies::add(const SubjectsInPoses& looked, std::size_t subject, std::size_t pose,
                          const OverdrawCounts& counts, std::span<const View> views) {
  const double weight = looked.distinct[subject].weights[pose];
  std::map<DrawId, std::vector<OverdrawCount>> of_draws;
  std::vector<OverdrawCount> whole(views.size());
  for (std::size_t part = 0; part < counts.size(); ++part) {
    foredraw::add(of_draws[looked.subjects[subject].parts[part].draw], counts[part]);
    foredraw::add(whole, counts[part]);
  }
  for (const auto& [draw, pictures] : of_draws) draws[draw][subject].add(pictures, weight);
  subjects[subject].add(whole, weight);
  for (std::size_t p = pose; p < poses.size(); ++p) {
    if (looked.distinct[subject].first_alike[p] != pose) continue;
    for (std::size_t view = 0; view < views.size(); ++view) {
      poses[p][view % poses[p].size()].add(whole[view], views[view].weight);
    }
  }
}

}  // namespace foredraw
