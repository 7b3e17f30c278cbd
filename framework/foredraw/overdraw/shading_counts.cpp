#include <foredraw/overdraw/shading_counts.h>

#include <algorithm>

namespace foredraw {

namespace {

/// Goes through a pixel's triangles front to back: one passes where all that is nearer is drawn later, and of equally
/// near ones the first that is drawn alone.
template <class Owner, class Pass>
void for_each_passing(std::span<const Owner> list, std::span<const std::uint32_t> turns, Pass pass) {
  std::uint32_t nearer = ~std::uint32_t{0};  // the earliest turn of what is nearer
  for (std::size_t begin = 0; begin < list.size();) {
    std::uint32_t first = 0;  // to be drawn of those that are equally near
    std::uint32_t earliest = ~std::uint32_t{0};
    std::size_t end = begin;
    do {
      const auto triangle = static_cast<std::uint32_t>(list[end] & static_cast<Owner>(~tie_bit<Owner>));
      if (turns[triangle] < earliest) {
        earliest = turns[triangle];
        first = triangle;
      }
      ++end;
    } while (end < list.size() && list[end] >= tie_bit<Owner>);
    if (earliest < nearer) pass(first, begin == 0);
    nearer = std::min(nearer, earliest);
    begin = end;
  }
}

}  // namespace

OverdrawDetails overdraw_details(const FragmentLayers& layers, std::span<const std::uint32_t> order) {
  const std::vector<std::uint32_t> turns = inverse_of(order, layers.owners);
  OverdrawDetails details{std::vector<std::uint64_t>(layers.owners), std::vector<std::uint64_t>(2)};
  for (const ViewLayers& view : layers.views) {
    details.pixels_by_times[1] += view.always.shaded;
    for_each_batch(view, [&](const LayerBatch& batch, const auto* list) {
      for (std::uint32_t i = 0; i < batch.lists; ++i, list += batch.length) {
        std::size_t times = 0;
        for_each_passing(std::span(list, batch.length), turns, [&](std::uint32_t triangle, bool stays) {
          ++times;
          if (!stays) details.hidden[triangle] += batch.weight;
        });
        if (times >= details.pixels_by_times.size()) details.pixels_by_times.resize(times + 1);
        details.pixels_by_times[times] += batch.weight;
      }
    });
  }
  return details;
}

}  // namespace foredraw
