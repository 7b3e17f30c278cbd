#pragma once
// Which fragments a mask discards.

#include <foredraw/overdraw/fragments.h>
#include <foredraw/viewing/mask.h>

namespace foredraw {

/// Parts fragments of a part with a mask into those that are on the surface and those that are in its holes.
class MaskedFragments {
 public:
  MaskedFragments(const PreparedPart& part, const Corners& corners, const Camera& camera)
      : part_(part), corners_(corners), camera_(camera) {}

  /// Of one triangle after the other: in different pixels, so that it does not matter which of them are drawn first.
  void hand_over(const Fragments& some, const TakeFragments& take_kept, const TakeFragments& take_discarded);

 private:
  const PreparedPart& part_;
  const Corners& corners_;
  const Camera& camera_;
  std::size_t triangle_ = 0;  ///< of the part, the last that was looked at
  Fragments kept_, discarded_;
};

}  // namespace foredraw
