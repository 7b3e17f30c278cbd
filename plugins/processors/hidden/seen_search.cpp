#include "seen_search.h"

#include "contained.h"
#include "seen_in_pictures.h"

#include <foredraw/base/random.h>
#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <set>
#include <utility>

namespace foredraw::processors::hidden {

namespace {

constexpr int rings = 2;
constexpr std::size_t first_pictures = 12;
constexpr std::size_t first_rays = 16;
constexpr std::size_t places_inside = 64;  // that pictures are taken from

Flags inverted(Flags flags) {
  for (std::uint8_t& flag : flags) flag = flag == 0;
  return flags;
}

}  // namespace

Flags not_finite(std::span<const RasterPart> parts) {
  Flags flags;
  for (const RasterPart& part : parts) {
    for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3) {
      const auto is_finite_corner = [&](std::uint32_t v) { return is_finite(part.positions[v]); };
      flags.push_back(!std::ranges::all_of(part.indices.subspan(i, 3), is_finite_corner));
    }
  }
  return flags;
}

SeenSearch::SeenSearch(const Connected& surface, Flags seen, const HiddenOptions& options, const BetweenSteps& between,
                       const Executor& executor)
    : surface_(surface),
      seen_(std::move(seen)),
      proved_(seen_.size(), 0),
      options_(options),
      between_(between),
      executor_(executor) {}

Flags SeenSearch::hidden() const {
  return inverted(options_.unit == Unit::component ? surface_.with_components(seen_)
                                                   : surface_.with_rings(seen_, rings));
}

bool SeenSearch::hides_any() const { return std::ranges::count(hidden(), 1) > 0; }

/// Of a component that is seen nobody asks for more; but rings are drawn around all that is seen.
Flags SeenSearch::open() const { return options_.unit == Unit::component ? hidden() : inverted(seen_); }

bool SeenSearch::is_any_of(const Sight& sight, const Flags& flags) const {
  return std::ranges::any_of(sight.triangles, [&](std::uint32_t t) { return flags[t] != 0; });
}

/// Only of what stays together whatever moves, and is seen from outside.
void SeenSearch::add_proved(const Sight& sight) {
  const Flags asked = hidden();
  if (!sight.is_rigid || !sight.cameras.boxes.empty() || !is_any_of(sight, asked)) return;
  const Flags proved = inside_closed(sight, surface_, asked);
  for (std::size_t t = 0; t < proved_.size(); ++t) proved_[t] |= proved[t];
}

void SeenSearch::look(const Sight& sight, std::span<const View> views, std::size_t rays, std::uint64_t seed) {
  add_by_pictures(sight, views);
  add_proved(sight);
  add_by_rays(sight, rays, seed);
}

/// Ever more at once: what the first ones show need not be looked for by the others.
void SeenSearch::add_by_pictures(const Sight& sight, std::span<const View> views) {
  if (!is_any_of(sight, open()) || !sight.cameras.boxes.empty()) return;
  const Pictures pictures(sight);
  std::size_t at_once = first_pictures;
  while (!views.empty()) {
    between_();
    const Flags asked = open();
    if (!is_any_of(sight, asked)) return;
    const auto some = views.first(std::min(at_once, views.size()));
    pictures.add_seen(some, options_.size, asked, seen_, executor_);
    views = views.subspan(some.size());
    at_once *= 2;
  }
}

Flags SeenSearch::open_to_rays() const {
  Flags flags = open();
  for (std::size_t t = 0; t < flags.size(); ++t) flags[t] &= proved_[t] == 0;
  return flags;
}

/// What is seen through a gap lies together, and is seen along much the same way.
void SeenSearch::add_neighbours(const Sight& sight, const Rays& tree, std::vector<WayOut> ways, std::uint64_t seed) {
  constexpr std::size_t none = ~std::size_t{0};
  const auto corners = surface_.corners();
  while (!ways.empty()) {
    between_();
    std::vector<std::size_t> way_at(surface_.vertices(), none);
    for (std::size_t w = 0; w < ways.size(); ++w) {
      for (std::size_t c = 0; c < 3; ++c) way_at[corners[3 * std::size_t{sight.triangles[ways[w].number]} + c]] = w;
    }
    const Flags asked = open_to_rays();
    std::vector<WayOut> next;
    for (std::uint32_t number = 0; number < sight.triangles.size(); ++number) {
      const std::size_t triangle = sight.triangles[number];
      if (asked[triangle] == 0) continue;
      std::set<std::size_t> near;
      for (std::size_t c = 0; c < 3; ++c) near.insert(way_at[corners[3 * triangle + c]]);
      for (const std::size_t w : near) {
        if (w != none) next.push_back({number, ways[w].direction});
      }
    }
    ways = tree.add_seen_along(next, seed, seen_, executor_);
  }
}

void SeenSearch::add_by_rays(const Sight& sight, std::size_t rays, std::uint64_t seed) {
  if (!is_any_of(sight, open_to_rays())) return;
  const Rays tree(sight);
  const bool is_inside = !sight.cameras.boxes.empty();
  if (is_inside) {
    const std::size_t places = std::max(places_inside, std::min(sight.cameras.boxes.size(), 4 * places_inside));
    tree.add_seen_around(places, std::max(16, options_.size / 4), derive_seed(seed, 0, 1), open_to_rays(), seen_,
                         executor_);
  }
  std::size_t count = std::min(first_rays, rays);
  for (std::size_t first = 0; first < rays; first += count, count = std::min(3 * first, rays - first)) {
    between_();
    const Flags asked = open_to_rays();
    if (!is_any_of(sight, asked)) return;
    std::vector<WayOut> ways = tree.add_seen({first, count, seed}, asked, seen_, executor_);
    if (!is_inside) add_neighbours(sight, tree, std::move(ways), seed);
  }
}

Pixels SeenSearch::check(const Sight& sight, std::span<const View> views, std::uint64_t seed) {
  between_();
  const Flags asked = hidden();
  if (!is_any_of(sight, asked)) return {};
  if (sight.cameras.boxes.empty()) {
    return Pictures(sight).add_seen(views, options_.size, asked, seen_, executor_);
  }
  const auto places = static_cast<std::size_t>((options_.checks + 5) / 6);
  return Rays(sight).add_seen_around(places, std::max(16, options_.size / 4), seed, asked, seen_, executor_);
}

}  // namespace foredraw::processors::hidden
