#pragma once
// Heights of seams that a scene stores, as the runtime's functions and shaders read them.

#include <foredraw/displaced/seam_heights.h>
#include <foredraw/runtime/seam_table.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// It refers to the draw's streams, which have to outlive it.
class StoredSeams {
 public:
  explicit StoredSeams(const DrawSeams& of);

  foredraw_seam_table table() const;
  std::span<const foredraw_seam_side> sides() const { return sides_; }
  /// Whether every side and height that is named is there, and no height besides; `triangles`: the draw's.
  bool is_sound(std::size_t triangles) const;

 private:
  std::span<const std::uint16_t> heights_;
  std::span<const std::uint8_t> parts_log2_;
  std::span<const foredraw_seam_side> sides_;
  std::vector<std::uint32_t> firsts_;
};

/// The buffer that evaluation shaders read, 32 bits a word: the numbers of sides and edges; of each side its number and
/// its edge, as foredraw_seam_side has them; of each edge 8 times the number of its first height, and its log2 of
/// parts; heights, two a word, the first one in the lower bits.
std::vector<std::uint32_t> seam_words(const StoredSeams& seams);

}  // namespace foredraw
