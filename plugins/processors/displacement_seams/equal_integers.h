#pragma once
#include <foredraw/analysis/seam_points.h>

#include <atomic>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw::processors::displacement_seams {

/// Heights at points in whole numbers, while texels change by single steps.
///
/// Texels that are rounded one by one leave one point of ten unequal, and no target fits where dozens of sides lie in
/// the same four texels. So none is set beforehand: the side whose texels most others share dictates the height, and
/// the others follow, by the step of one texel that leaves the fewest points unequal. Where that stands still, points
/// that are unequal count more and more, until others give way (P. Morris: The Breakout Method for Escaping from Local
/// Minima, AAAI 1993). Corners count more than others from the beginning.
class IntegerHeights {
 public:
  /// `texels`: their places in the map, ascending, all that the points lie in; `values`: theirs.
  IntegerHeights(const SeamPoints& points, const foredraw_height_map& map, std::span<const std::uint32_t> texels,
                 std::vector<std::uint16_t> values, std::uint32_t bits);

  /// Goes over all points that are unequal, until there are none, at most so many times. Ends with the fewest that
  /// there were.
  void settle(int most_passes, const std::atomic<bool>* cancel = nullptr);

  /// A point that need not be equal any more.
  void release(std::size_t point);

  std::size_t unequal_count() const { return unequal_count_; }
  bool is_unequal(std::size_t point) const { return is_unequal_[point]; }
  const std::vector<std::uint16_t>& values() const { return values_; }

 private:
  struct Footprint {
    std::uint32_t point = 0;
    std::uint32_t count = 0;
    std::uint32_t texels[4]{};
    std::uint32_t weights[4]{};
    std::uint32_t sum = 0;  ///< as displaced_height.h has it
  };
  struct Touch {
    std::uint32_t footprint, weight;
  };
  struct Step {
    std::uint32_t texel = 0;
    std::int32_t by = 0;
    Step back() const { return {texel, -by}; }
  };

  std::uint32_t height(const Footprint& footprint) const { return footprint.sum >> shift_; }
  void judge(std::uint32_t point);
  void apply(Step step);
  std::vector<std::uint32_t> heights_near(std::uint32_t point) const;
  void let_follow(std::uint32_t point);
  Step best_step(const Footprint& footprint, std::uint32_t wanted);
  std::vector<Step> bring_to(std::uint32_t point, std::uint32_t wanted);
  void undo(const std::vector<Step>& steps);
  void return_to(const std::vector<std::uint16_t>& values);

  std::uint32_t shift_;
  std::vector<std::uint16_t> values_;
  std::vector<std::size_t> starts_;  ///< [point] its footprints, and the end of the last
  std::vector<Footprint> footprints_;
  std::vector<std::size_t> touch_starts_;  ///< [texel], and the end of the last
  std::vector<Touch> touches_;
  std::vector<std::uint32_t> shared_;  ///< [footprint] how many touch its texels
  std::vector<bool> is_unequal_, is_released_;
  std::vector<std::uint32_t> worth_;  ///< [point] what it costs if it is unequal
  std::size_t unequal_count_ = 0;
  std::uint64_t cost_ = 0;  ///< of those that are unequal
};

}  // namespace foredraw::processors::displacement_seams
