#pragma once
// A sequence of parts in which one run of a group is moved at a time, and what that saves.

#include <foredraw/overdraw/part_lists.h>
#include <foredraw/scene/part_groups.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The lists that a part is in: those of part p are [first[p], first[p + 1]) of `lists`, rising.
struct ListsOfParts {
  explicit ListsOfParts(const PartLists& all);
  std::span<const std::uint32_t> of(std::uint32_t part) const {
    return {&lists[first[part]], first[part + 1] - first[part]};
  }

  std::vector<std::uint32_t> first;
  std::vector<std::uint32_t> lists;
};

class RunMoves {
 public:
  /// Lists are only referred to.
  RunMoves(const PartLists& lists, const ListsOfParts& lists_of, std::vector<std::uint32_t> sequence);

  const std::vector<std::uint32_t>& sequence() const { return sequence_; }

  /// Moves the run to where least is shaded, everything else left where it is. Answers with what that saves.
  std::int64_t improve(const PartGroup& group, std::uint32_t run);

  /// Brings runs back before those that they stood before at first, where that costs nothing.
  void settle(const PartGroup& group);

 private:
  /// The group's runs as they are drawn.
  std::vector<std::uint32_t> runs_of(const PartGroup& group) const;
  void put(const PartGroup& group, std::span<const std::uint32_t> runs);
  void find_changes(std::uint32_t first_part, std::uint32_t end_part);
  void find_changes_in(std::uint32_t list, std::uint32_t first_part, std::uint32_t end_part);
  void add_change(std::uint32_t part, std::int64_t change);
  std::int64_t change_at(const PartGroup& group, std::uint32_t run) const;

  const PartLists& lists_;
  const ListsOfParts& lists_of_;
  std::vector<std::uint32_t> sequence_;    // [rank] = part
  std::vector<std::uint32_t> ranks_;       // [part]
  std::vector<std::int64_t> change_;       // [part] of what is shaded, as the run moves backwards past the part
  std::vector<std::uint32_t> changed_;     // parts whose change may not be 0
  std::vector<std::uint32_t> last_asked_;  // [list] number of the question that it answered last
  std::uint32_t question_ = 0;
};

}  // namespace foredraw
