#pragma once
// Rooms in a square and the doors between them.

#include <cstdint>
#include <vector>

namespace foredraw::bench {

constexpr double room = 6;  ///< from the middle of a wall to the middle of the next, metres
constexpr double room_height = 3;
constexpr double wall = 0.2;  ///< how thick
constexpr double door = 1.2;  ///< how wide, in the middle of a wall
constexpr double door_height = 2.1;

/// Of at least 2 x 2 rooms. Room (i, j) lies between x = 6 i and 6 (i + 1), z = 6 j and 6 (j + 1). Of the walls between
/// rooms most have a door, the others are chosen by the seed; all walls that the walk crosses have one. Outer walls
/// have none.
class BuildingPlan {
 public:
  BuildingPlan(std::uint64_t side, std::uint64_t seed);

  std::uint64_t side() const { return side_; }

  /// Whether the wall at the left (x = 6 i) or in front (z = 6 j) of a room has a door; i and j up to side().
  bool has_door_left(std::uint64_t i, std::uint64_t j) const { return i > 0 && i < side_ && left_[j * side_ + i]; }
  bool has_door_front(std::uint64_t i, std::uint64_t j) const { return j > 0 && j < side_ && front_[j * side_ + i]; }

  struct Room {
    std::uint64_t i, j;
  };

  /// Rooms that the walk goes through, from door to door.
  const std::vector<Room>& walk() const { return walk_; }

 private:
  void open(const Room& from, const Room& to);

  std::uint64_t side_;
  std::vector<bool> left_, front_;
  std::vector<Room> walk_;
};

}  // namespace foredraw::bench
