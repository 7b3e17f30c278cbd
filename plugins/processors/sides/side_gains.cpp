#include "side_gains.h"

#include "all_sides.h"

#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/subject_geometry.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace foredraw::processors::sides {

namespace {

using Counts = std::vector<std::atomic<std::uint32_t>>;  // sums are the same whoever adds first

/// [side of AllSides] fragments in pictures of some sides.
struct InFront {
  explicit InFront(std::size_t sides) : all(sides), hiding(sides) {}

  Counts all;     ///< nothing lies before them
  Counts hiding;  ///< and something behind
};

/// A picture of some sides.
struct Picture {
  explicit Picture(std::size_t pixels) : nearest(pixels), layers(pixels, 0) {}

  NearestSides nearest;
  std::vector<std::uint32_t> layers;  ///< [pixel] fragments

  void add(std::uint32_t pixel, std::uint32_t depth, std::uint32_t side) {
    nearest.add(pixel, depth, side);
    ++layers[pixel];
  }

  void count(InFront& to) const {
    for (std::size_t pixel = 0; pixel < layers.size(); ++pixel) {
      if (layers[pixel] == 0) continue;
      to.all[nearest.sides[pixel]].fetch_add(1, std::memory_order_relaxed);
      if (layers[pixel] > 1) to.hiding[nearest.sides[pixel]].fetch_add(1, std::memory_order_relaxed);
    }
  }
};

/// Of the sides of a subject.
struct SideFragments {
  explicit SideFragments(std::size_t sides) : all(sides), among_all(sides), among_wanted(sides) {}

  Counts all;
  InFront among_all, among_wanted;
};

void count_fragments(const AllSides& sides, const std::vector<std::uint8_t>& is_wanted, const View& view, int size,
                     SideFragments& counts) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  Picture all(pixels), wanted(pixels);
  const Camera camera(view, size);
  Rasteriser rasteriser;
  for (const PreparedPart& part : sides.parts()) {
    rasteriser.draw(part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        const std::uint32_t side = some.triangles[i];
        counts.all[side].fetch_add(1, std::memory_order_relaxed);
        all.add(some.pixels[i], some.depths[i], side);
        if (is_wanted[side] != 0) wanted.add(some.pixels[i], some.depths[i], side);
      }
    });
  }
  all.count(counts.among_all);
  wanted.count(counts.among_wanted);
}

/// Of a triangle.
struct HidingAndHidden {
  std::array<double, 2> hiding{}, hidden{};  ///< [front, back]

  double lost() const { return 0.5 * (std::min(hiding[0], hidden[1]) + std::min(hiding[1], hidden[0])); }
};

}  // namespace

SideGains side_gains(const Scene& scene, const std::map<DrawId, std::vector<Side>>& wanted, const Views& views,
                     const Poses& poses, SubjectUnit unit, Analyses& analyses, const Executor& executor) {
  SideGains gains;
  std::map<DrawId, std::vector<HidingAndHidden>> counts;
  for (const auto& [id, sides] : wanted) counts[id].resize(sides.size());
  for (const Subject& subject : subjects_of(scene, unit)) {
    if (std::ranges::none_of(subject.parts, [&](const SubjectPart& part) { return wanted.contains(part.draw); })) {
      continue;
    }
    const std::size_t different = subject.is_placed() ? std::min(poses.poses.size(), views.views.size()) : 1;
    for (std::size_t pose = 0; pose < different; ++pose) {
      const PosedNodes nodes = subject.is_placed() ? posed_nodes(scene, poses.poses[pose]) : PosedNodes();
      const SubjectGeometry drawn =
          subject_geometry(scene, subject, Faces::material, nodes, analyses, ShownSurface::stored);
      const AllSides sides(drawn.parts);
      const std::vector<std::uint8_t> is_wanted = sides.among(sides_of_parts(subject, drawn.parts, wanted));
      SideFragments found(sides.count());
      const std::size_t looks = (views.views.size() - pose + different - 1) / different;
      executor.for_each(looks, [&](std::size_t look) {
        count_fragments(sides, is_wanted, views.views[pose + look * different], views.size, found);
      });
      for (std::uint32_t number = 0; number < sides.count(); ++number) {
        gains.visible += found.among_all.all[number];
        const AllSides::Place place = sides.place_of(number);
        const auto draw = wanted.find(subject.parts[place.part].draw);
        if (draw == wanted.end()) continue;
        const InFront& in_front = draw->second[place.triangle] == both ? found.among_wanted : found.among_all;
        HidingAndHidden& sum = counts[draw->first][place.triangle];
        const std::size_t at = place.side == front ? 0 : 1;
        sum.hiding[at] += in_front.hiding[number];
        sum.hidden[at] += static_cast<double>(found.all[number]) - in_front.all[number];
      }
    }
  }
  for (const auto& [id, triangles] : counts) {
    for (const HidingAndHidden& triangle : triangles) gains.of[id].push_back(triangle.lost());
  }
  return gains;
}

}  // namespace foredraw::processors::sides
