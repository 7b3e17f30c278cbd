#include "seen_in_pictures.h"

#include <foredraw/overdraw/fragments.h>

#include <algorithm>

namespace foredraw::processors::hidden {

namespace {

constexpr std::uint32_t nothing_there = ~std::uint32_t{0};

/// The part with some of its triangles alone.
template <class IsKept>
PreparedPart part_of(const PreparedPart& whole, IsKept is_kept) {
  PreparedPart part;
  part.culls_back_faces = whole.culls_back_faces;
  for (std::size_t t = 0; t < whole.triangle_count(); ++t) {
    if (!is_kept(whole.numbers[t])) continue;
    for (std::size_t c = 0; c < 3; ++c) part.corners[c].push_back(whole.corners[c][t]);
    part.numbers.push_back(whole.numbers[t]);
  }
  if (part.numbers.empty()) return part;
  part.positions = whole.positions;
  const std::size_t padded =
      (part.numbers.size() + PreparedPart::padding - 1) / PreparedPart::padding * PreparedPart::padding;
  for (auto& corner : part.corners) corner.resize(padded, 0);
  part.numbers.resize(padded, 0);
  return part;
}

struct OfPicture {
  Pixels pixels;
  std::vector<std::uint32_t> seen;  ///< each once
};

/// First how near the nearest thing is that hides others, then what of those asked for is no farther.
OfPicture look(std::span<const PreparedPart* const> hiding, std::span<const PreparedPart> asked, const View& view,
               int size, std::size_t triangles) {
  const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  std::vector<std::uint32_t> nearest(pixels, nothing_there);
  const Camera camera(view, size);
  Rasteriser rasteriser;
  for (const PreparedPart* part : hiding) {
    rasteriser.draw(*part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        std::uint32_t& there = nearest[some.pixels[i]];
        there = std::min(there, some.depths[i]);
      }
    });
  }
  Flags is_seen(triangles, 0), shows_asked(pixels, 0);
  OfPicture picture;
  for (const PreparedPart& part : asked) {
    rasteriser.draw(part, camera, [&](const Fragments& some) {
      for (std::size_t i = 0; i < some.count; ++i) {
        if (some.depths[i] > nearest[some.pixels[i]]) continue;
        shows_asked[some.pixels[i]] = 1;
        if (is_seen[some.triangles[i]] != 0) continue;
        is_seen[some.triangles[i]] = 1;
        picture.seen.push_back(some.triangles[i]);
      }
    });
  }
  for (std::size_t pixel = 0; pixel < pixels; ++pixel) {
    picture.pixels.asked += shows_asked[pixel];
    picture.pixels.shown += shows_asked[pixel] != 0 || nearest[pixel] != nothing_there;
  }
  return picture;
}

}  // namespace

Pictures::Pictures(const Sight& sight) : sight_(sight), parts_(prepared(sight.parts)) {}

Pixels Pictures::add_seen(std::span<const View> views, int size, const Flags& asked, Flags& seen,
                          const Executor& executor) const {
  std::vector<const PreparedPart*> hiding;
  std::vector<PreparedPart> some;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (parts_[p].numbers.empty()) continue;
    if (sight_.hides[p] != 0) hiding.push_back(&parts_[p]);
    PreparedPart part = part_of(parts_[p], [&](std::uint32_t number) { return asked[sight_.triangles[number]] != 0; });
    if (!part.numbers.empty()) some.push_back(std::move(part));
  }
  if (some.empty()) return {};
  std::vector<OfPicture> pictures(views.size());
  executor.for_each(views.size(),
                    [&](std::size_t v) { pictures[v] = look(hiding, some, views[v], size, sight_.triangles.size()); });
  Pixels sum;
  for (const OfPicture& picture : pictures) {
    sum += picture.pixels;
    for (const std::uint32_t number : picture.seen) seen[sight_.triangles[number]] = 1;
  }
  return sum;
}

}  // namespace foredraw::processors::hidden
