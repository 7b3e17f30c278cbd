#include "needed_sides.h"

#include <foredraw/overdraw/fragments.h>

#include <algorithm>

namespace foredraw::processors::sides {

namespace {

/// One picture, drawn whole and drawn of the kept sides alone.
struct TwoPictures {
  NearestSides whole;
  std::vector<std::uint32_t> kept;  ///< [pixel] depth
};

TwoPictures draw_both(std::span<const PreparedPart> parts, const std::vector<std::uint8_t>& is_kept, const View& view,
                      int size) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  TwoPictures pictures{NearestSides(pixels), std::vector(pixels, NearestSides::nothing)};
  const Camera camera(view, size);
  Rasteriser rasteriser;
  for (const PreparedPart& part : parts) {
    rasteriser.draw(part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        const std::uint32_t pixel = some.pixels[i], depth = some.depths[i], side = some.triangles[i];
        pictures.whole.add(pixel, depth, side);
        if (is_kept[side] != 0) pictures.kept[pixel] = std::min(pictures.kept[pixel], depth);
      }
    });
  }
  return pictures;
}

}  // namespace

Needed add_needed_by_pictures(const AllSides& all, SidesOfParts& kept, const Views& views, const Executor& executor) {
  const std::vector<std::uint8_t> is_kept = all.among(kept);
  struct OfView {
    Needed needed;
    std::vector<std::uint32_t> sides, backs;
  };
  std::vector<OfView> of_views(views.views.size());
  executor.for_each(views.views.size(), [&](std::size_t v) {
    const TwoPictures pictures = draw_both(all.parts(), is_kept, views.views[v], views.size);
    OfView& of_view = of_views[v];
    for (std::size_t pixel = 0; pixel < pictures.kept.size(); ++pixel) {
      const std::uint32_t nearest = pictures.whole.sides[pixel];
      if (nearest == NearestSides::nothing) continue;
      ++of_view.needed.shown;
      if (nearest >= all.first_back() && is_kept[nearest] != 0) of_view.backs.push_back(nearest);
      if (pictures.kept[pixel] - pictures.whole.depths[pixel] <= most_steps_apart) continue;
      ++of_view.needed.pixels;
      of_view.sides.push_back(nearest);
    }
    for (std::vector<std::uint32_t>* sides : {&of_view.sides, &of_view.backs}) {
      std::ranges::sort(*sides);
      sides->erase(std::unique(sides->begin(), sides->end()), sides->end());
    }
  });
  Needed sum;
  for (std::size_t v = 0; v < of_views.size(); ++v) {
    sum.pixels += of_views[v].needed.pixels;
    sum.shown += of_views[v].needed.shown;
    const auto see = [&](std::uint32_t number) {
      const AllSides::Place place = all.place_of(number);
      sum.seen.push_back({static_cast<std::uint32_t>(place.part), static_cast<std::uint32_t>(place.triangle),
                          place.side, views.views[v].direction});
    };
    for (const std::uint32_t number : of_views[v].sides) {
      see(number);
      Side& sides = kept[sum.seen.back().part][sum.seen.back().triangle];
      sides = static_cast<Side>(sides | sum.seen.back().side);
    }
    for (const std::uint32_t number : of_views[v].backs) see(number);
  }
  return sum;
}

}  // namespace foredraw::processors::sides
