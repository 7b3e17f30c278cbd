#pragma once
// The colours of a binary STL, which are what some programs make of the two attribute bytes behind each triangle.
// Private to io.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace foredraw::mesh_files {

using StlColor = std::array<std::uint8_t, 3>;  // red, green, blue

/// Two conventions exist, and a file says which one it follows:
/// - Materialise Magics: the header has "COLOR=" and four bytes, the colour of the whole. A triangle whose highest bit
///   is 0 has its own: from the lowest bit on, five bits of red, of green, of blue.
/// - VisCAM and SolidView: a triangle whose highest bit is 1 has a colour: five bits of blue, of green, of red. The
///   others are white, and have attribute bytes of 0.
/// Without "COLOR=", a single attribute that is not 0 and lacks the highest bit says that the file follows neither.
/// Then none of them is a colour: a program that keeps something else there sets the highest bit in some, by chance.
class StlColors {
 public:
  /// `text` holds `triangles` whole records.
  StlColors(std::string_view text, std::size_t triangles);

  bool are_there() const { return whole_ || (unmarked_ == 0 && not_zero_ > 0); }
  /// What became of the attribute bytes, and by which rule; empty where all are 0 and the header has no colour.
  std::string told() const;
  /// Where there are none, all are equal.
  StlColor of(std::size_t triangle) const;

 private:
  std::uint16_t attribute(std::size_t triangle) const;

  std::string_view text_;
  std::optional<StlColor> whole_;  ///< the header's
  std::size_t not_zero_ = 0;       ///< attributes that are not 0
  std::size_t unmarked_ = 0;       ///< of these, those whose highest bit is 0
};

}  // namespace foredraw::mesh_files
