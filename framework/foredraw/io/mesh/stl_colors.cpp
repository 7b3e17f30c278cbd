#include <foredraw/io/mesh/private/stl.h>
#include <foredraw/io/mesh/private/stl_colors.h>

#include <fmt/format.h>

namespace foredraw::mesh_files {

namespace {

constexpr std::uint16_t highest_bit = 0x8000;

std::optional<StlColor> header_color(std::string_view text) {
  constexpr std::string_view word = "COLOR=";
  const std::string_view header = text.substr(0, stl_header - 4);
  const std::size_t at = header.find(word);
  if (at == header.npos || at + word.size() + 4 > header.size()) return std::nullopt;
  StlColor color;
  for (std::size_t i = 0; i < 3; ++i) color[i] = static_cast<std::uint8_t>(header[at + word.size() + i]);
  return color;
}

/// Five bits, as 0 to 255.
std::uint8_t channel(std::uint16_t attribute, int shift) {
  return static_cast<std::uint8_t>(((attribute >> shift & 31) * 255 + 15) / 31);
}

}  // namespace

StlColors::StlColors(std::string_view text, std::size_t triangles) : text_(text), whole_(header_color(text)) {
  for (std::size_t t = 0; t < triangles; ++t) {
    const std::uint16_t value = attribute(t);
    not_zero_ += value != 0;
    unmarked_ += value != 0 && (value & highest_bit) == 0;
  }
}

std::uint16_t StlColors::attribute(std::size_t triangle) const {
  const char* at = text_.data() + stl_header + triangle * stl_record + stl_record - 2;
  return static_cast<std::uint16_t>(static_cast<unsigned char>(at[0]) | static_cast<unsigned char>(at[1]) << 8);
}

std::string StlColors::told() const {
  if (whole_) {
    return "triangles have colours, read from their attribute bytes as Materialise Magics writes them, because the "
           "header has COLOR=";
  }
  if (are_there()) {
    return fmt::format(
        "triangles have colours, read from {} attributes as VisCAM and SolidView write them, because the header has no "
        "COLOR= and the highest bit is 1 in every attribute that is not 0",
        not_zero_);
  }
  if (not_zero_ == 0) return {};
  return fmt::format(
      "the attribute bytes of {} triangles are left out: they are not colours, because the header has no COLOR= and "
      "the "
      "highest bit, which marks a colour, is 0 in {} of them",
      not_zero_, unmarked_);
}

StlColor StlColors::of(std::size_t triangle) const {
  if (!are_there()) return {};
  const std::uint16_t value = attribute(triangle);
  const bool is_marked = (value & highest_bit) != 0;
  if (!whole_)
    return is_marked ? StlColor{channel(value, 10), channel(value, 5), channel(value, 0)} : StlColor{255, 255, 255};
  // Some programs colour the whole and leave all attribute bytes 0, which would be black.
  if (is_marked || not_zero_ == 0) return *whole_;
  return {channel(value, 0), channel(value, 5), channel(value, 10)};
}

}  // namespace foredraw::mesh_files
