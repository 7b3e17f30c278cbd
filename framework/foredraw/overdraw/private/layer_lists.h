#pragma once
// Collects what lies behind what, and lays it out for asking.

#include <foredraw/overdraw/layers.h>

namespace foredraw {

/// Lists before they are laid out.
class LayerLists {
 public:
  /// Front to back, with tie bits, two at least.
  void add(std::span<const std::uint32_t> list, std::uint32_t weight);
  /// Merges equal lists. Owners are below `owners`, at most 2^31. The same whatever the sequence of the lists was.
  ViewLayers laid_out(std::size_t owners, const OverdrawCount& always) &&;

 private:
  struct List {
    std::uint64_t front;  ///< its first two entries, to compare by
    std::size_t first;    ///< in entries_
    std::uint32_t length;
    std::uint32_t weight;
    bool has_ties;
  };
  std::span<const std::uint32_t> entries_of(const List& list) const;
  void merge_equal();

  std::vector<std::uint32_t> entries_;
  std::vector<List> lists_;
};

}  // namespace foredraw
