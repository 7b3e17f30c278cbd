#pragma once
// How the groups of a plane are taken apart, at each width: 16 values of so many bits each, then a byte for each of
// them whose bits are all set. A group of 8 bits is one whose values are all left to the bytes that follow.

#include <foredraw/io/meshopt/private/vertex_layout.h>

namespace foredraw::meshopt {

using SixteenBytes = std::array<Byte, group_size>;

struct GroupForm {
  // By bytes that are looked up, and by half bytes.
  alignas(16) SixteenBytes source{};  ///< of each value: which byte holds its bits; 128: none does
  alignas(16) SixteenBytes field{};   ///< its bits there; all set: its byte follows
  alignas(16) SixteenBytes value{};   ///< [half a byte]: the value whose bits are set there, wherever these are
  // By counting in the first 8 bytes.
  std::size_t bytes = 0;       ///< of the group, where no value is left to those that follow
  std::array<int, 2> folds{};  ///< after and-ing with itself shifted by these, ...
  std::uint64_t lanes = 0;     ///< ... a bit here is set for each value whose bits are
};

inline constexpr std::array<GroupForm, widths.size()> group_forms = [] {
  std::array<GroupForm, widths.size()> forms;
  for (std::size_t w = 0; w < widths.size(); ++w) {
    GroupForm& form = forms[w];
    const std::size_t width = widths[w];
    const bool packed = width > 0 && width < 8;
    const std::size_t in_byte = packed ? 8 / width : 1;
    form.bytes = 2 * width;
    if (width > 1 && packed) form.folds = {1, width == 4 ? 2 : 0};
    for (std::size_t i = 0; i < group_size; ++i) {
      const std::size_t place = i % in_byte;
      const std::size_t shift = width == 1 ? place : packed ? 8 - width * (place + 1) : 0;
      form.source[i] = packed ? static_cast<Byte>(i / in_byte) : Byte{128};
      const int mask = packed ? (1 << width) - 1 : 0;
      form.field[i] = width == 0 ? Byte{255} : static_cast<Byte>(mask << shift);
      form.value[i] = static_cast<Byte>(width == 1 ? 0 : width == 2 ? (i < 4 ? i : i / 4) : i);
      if (packed) form.lanes |= std::uint64_t{1} << (i * width);
    }
  }
  return forms;
}();

}  // namespace foredraw::meshopt
