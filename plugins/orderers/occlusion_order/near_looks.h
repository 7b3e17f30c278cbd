#pragma once
// Which looks stand for a look's surroundings: an engine's camera is between the looks that orders are made from.

#include <foredraw/overdraw/subject_layers.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

struct NearLook {
  std::uint32_t look = 0;
  std::int64_t weight = 0;  ///< 256 of the look itself, less the farther away
};

class NearLooks {
 public:
  /// Of the same pose, from directions a few views away. O(looks * looks of a pose).
  explicit NearLooks(const SubjectLayers& subject);

  /// Of a look, itself among them.
  std::span<const NearLook> of(std::size_t look) const {
    return {near_.data() + first_[look], first_[look + 1] - first_[look]};
  }

 private:
  std::vector<std::size_t> first_{0};
  std::vector<NearLook> near_;
};

}  // namespace foredraw
