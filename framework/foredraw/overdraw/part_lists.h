#pragma once
// What parts lie behind what, pixel by pixel, as those who sort parts ask it: a part once in a list, by its nearest
// fragment, for what a part hides of itself no sequence changes.

#include <foredraw/overdraw/layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Lists of two parts or more, nearest first. Equal lists are one with the sum of their weights.
struct PartLists {
  std::uint32_t parts = 0;
  std::vector<std::uint32_t> first = {0};  ///< list l is [first[l], first[l + 1]) of `layers`
  std::vector<std::uint32_t> layers;
  std::vector<std::int64_t> weights;  ///< [list]

  std::size_t count() const { return weights.size(); }
  std::span<const std::uint32_t> list(std::size_t l) const { return {&layers[first[l]], first[l + 1] - first[l]}; }
};

/// Of the layers' views, a pixel of view v as heavy as weights[v] says; 0 leaves the view out. `part_of`: [owner] its
/// part, below `parts`. Of fragments that are equally near, the first in the list stands for all. O(n log n) of what
/// the layers hold.
PartLists part_lists(const Layers& layers, std::span<const std::uint32_t> part_of, std::uint32_t parts,
                     std::span<const std::int64_t> weights);

/// Of a single view.
PartLists part_lists(const ViewLayers& view, std::span<const std::uint32_t> part_of, std::uint32_t parts);

/// Of all of these together, of as many parts each; a pixel of lists[i] as heavy as weights[i] says, 0 leaves it out.
PartLists joined(std::span<const PartLists> lists, std::span<const std::int64_t> weights);

/// What drawing the parts in this sequence, [rank] = part, shades of the lists: a part passes where it comes before
/// all parts that are nearer.
std::int64_t fragments_shaded(const PartLists& lists, std::span<const std::uint32_t> sequence);

}  // namespace foredraw
