#include "side_gains.h"

#include "all_sides.h"

#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/subject_geometry.h>

#include <algorithm>
#include <atomic>

namespace foredraw::sides {

namespace {

/// [side of AllSides] its fragments.
struct SideFragments {
  explicit SideFragments(std::size_t sides) : all(sides), in_front(sides) {}

  using Counts = std::vector<std::atomic<std::uint32_t>>;  // sums are the same whoever adds first
  Counts all, in_front;
};

void count_fragments(const AllSides& sides, const View& view, int size, SideFragments& counts) {
  constexpr std::uint32_t far = ~std::uint32_t{0};
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<std::uint32_t> depths(pixels, far), nearest(pixels);
  const Camera camera(view, size);
  Rasteriser rasteriser;
  for (const PreparedPart& part : sides.parts()) {
    rasteriser.draw(part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        const std::uint32_t pixel = some.pixels[i], side = some.triangles[i];
        counts.all[side].fetch_add(1, std::memory_order_relaxed);
        if (some.depths[i] >= depths[pixel]) continue;
        depths[pixel] = some.depths[i];
        nearest[pixel] = side;
      }
    });
  }
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    if (depths[pixel] != far) counts.in_front[nearest[pixel]].fetch_add(1, std::memory_order_relaxed);
  }
}

struct InFrontAndBehind {
  double front[2] = {}, back[2] = {};

  double lost() const { return 0.5 * (std::min(front[0], back[1]) + std::min(back[0], front[1])); }
};

}  // namespace

SideGains side_gains(const Scene& scene, std::span<const DrawId> asked, const Views& views, const Poses& poses,
                     SubjectUnit unit, Analyses& analyses, const Executor& executor) {
  SideGains gains;
  std::map<DrawId, std::vector<InFrontAndBehind>> counts;
  for (const DrawId id : asked) counts[id].resize(scene.draws[id].full().stream().triangle_count());
  for (const Subject& subject : subjects_of(scene, unit)) {
    if (std::ranges::none_of(subject.parts, [&](const SubjectPart& part) { return counts.contains(part.draw); })) {
      continue;
    }
    const std::size_t different = subject.is_placed() ? std::min(poses.poses.size(), views.views.size()) : 1;
    for (std::size_t pose = 0; pose < different; ++pose) {
      const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene, poses.poses[pose]) : PosedNodes();
      const SubjectGeometry drawn = subject_geometry(scene, subject, Faces::material, nodes, analyses);
      const AllSides sides(drawn.parts);
      SideFragments found(sides.count());
      const std::size_t looks = (views.views.size() - pose + different - 1) / different;
      executor.for_each(looks, [&](std::size_t look) {
        count_fragments(sides, views.views[pose + look * different], views.size, found);
      });
      for (std::uint32_t number = 0; number < sides.count(); ++number) {
        const AllSides::Place place = sides.place_of(number);
        const double in_front = found.in_front[number];
        gains.visible += in_front;
        const auto draw = counts.find(subject.parts[place.part].draw);
        if (draw == counts.end()) continue;
        InFrontAndBehind& sum = draw->second[place.triangle];
        double(&side)[2] = place.side == front ? sum.front : sum.back;
        side[0] += in_front;
        side[1] += found.all[number] - in_front;
      }
    }
  }
  for (const auto& [id, triangles] : counts) {
    for (const InFrontAndBehind& triangle : triangles) gains.of[id].push_back(triangle.lost());
  }
  return gains;
}

}  // namespace foredraw::sides
