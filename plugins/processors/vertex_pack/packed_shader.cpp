#include "packed_shader.h"

#include "shader_words.h"

#include <algorithm>
#include <bit>
#include <string_view>

namespace foredraw::processors::vertex_pack {

namespace {

constexpr std::string_view decode = R"(
PackedVertex packed_decode($u4 row) {
  PackedVertex vertex;
  vertex.position = $f3(float(int($x) + $ox) * $step, float(int($y) + $oy) * $step, float(int($z) + $oz) * $step);
  vertex.normal = $normal;
  vertex.tangent = $tangent;
  vertex.uv = $uv;
  return vertex;
}
)";

constexpr std::string_view encode_begin = R"(
uint packed_encode(PackedVertex vertex, out $u4 row) {
  bool position_is_outside = false;
  bool uv_is_outside = false;
  bool normal_is_none = false;
  bool tangent_is_none = false;
  row = $u4(0u, 0u, 0u, 0u);
)";

constexpr std::string_view encode_normal = R"(  $f3 unit = packed_unit(vertex.normal, normal_is_none);
  $u2 cell = $cell;
  $u2 code = cell;
  $f3 normal = unit;
  precise float nearest = 8.0;
  for (uint i = 0u; i < 4u; ++i) {
    $u2 at = $u2((cell.x + (i & 1u)) & $mostu, cell.y + (i >> 1u));
    $f3 corner = $corner;
    precise $f3 apart = corner - unit;
    precise float squared = apart.x * apart.x + apart.y * apart.y + apart.z * apart.z;
    if (squared < nearest) {
      nearest = squared;
      code = at;
      normal = corner;
    }
  }
)";

constexpr std::string_view encode_end =
    R"(  return (position_is_outside ? 1u : 0u) | (uv_is_outside ? 2u : 0u) | (normal_is_none ? 4u : 0u) |
         (tangent_is_none ? 8u : 0u);
}
)";

std::string number(std::uint32_t value) { return std::to_string(value) + 'u'; }
std::string number(std::int32_t value) { return value < 0 ? "(" + std::to_string(value) + ")" : std::to_string(value); }
/// By its bits, so that no digit is lost.
std::string number(float value) { return "$float(" + number(std::bit_cast<std::uint32_t>(value)) + ")"; }

/// The text of one layout, in which only the language's words are left to put in.
class LayoutText {
 public:
  explicit LayoutText(const PackedLayout& layout) : layout_(layout) {}

  std::string text() const {
    const std::vector<Word> words = {{"$x", read(FOREDRAW_PACKED_X)},    {"$y", read(FOREDRAW_PACKED_Y)},
                                     {"$z", read(FOREDRAW_PACKED_Z)},    {"$ox", number(layout_.origin[0])},
                                     {"$oy", number(layout_.origin[1])}, {"$oz", number(layout_.origin[2])},
                                     {"$step", number(layout_.step)},    {"$normal", decoded_normal()},
                                     {"$tangent", decoded_tangent()},    {"$uv", decoded_uv()}};
    return with_words(decode, words) + encode();
  }

 private:
  std::uint32_t bits(int field) const { return layout_.field[field].bits; }
  std::uint32_t normal_bits() const { return bits(FOREDRAW_PACKED_NORMAL_0); }
  std::string word(int field) const { return std::string("row.") + "xyzw"[layout_.field[field].word]; }

  std::string read(int field) const {
    return "(" + word(field) + " >> " + number(layout_.field[field].shift) + " & " +
           number(foredraw_packed_most(bits(field))) + ")";
  }

  std::string write(int field, const std::string& code) const {
    return "  " + word(field) + " |= " + code + " << " + number(layout_.field[field].shift) + ";\n";
  }

  std::string normal_of(const std::string& u, const std::string& v) const {
    const std::string codes = u + ", " + v + ", " + number(normal_bits());
    return layout_.is_spherical == 0 ? "packed_octahedral(" + codes + ")"
                                     : "packed_spherical(" + codes + ", " + per_most() + ")";
  }

  std::string per_most() const { return number(1.0f / static_cast<float>(foredraw_packed_most(normal_bits()))); }

  std::string decoded_normal() const {
    return normal_bits() == 0 ? "$f3(0.0, 0.0, 0.0)"
                              : normal_of(read(FOREDRAW_PACKED_NORMAL_0), read(FOREDRAW_PACKED_NORMAL_1));
  }

  std::string decoded_tangent() const {
    if (bits(FOREDRAW_PACKED_TANGENT) == 0) return "$f4(0.0, 0.0, 0.0, 0.0)";
    return "$f4(packed_tangent(vertex.normal, " + read(FOREDRAW_PACKED_TANGENT) + ", " +
           number(bits(FOREDRAW_PACKED_TANGENT)) + "), " + read(FOREDRAW_PACKED_SIGN) + " != 0u ? -1.0 : 1.0)";
  }

  std::string decoded_uv() const {
    if (bits(FOREDRAW_PACKED_U) == 0) return "$f2(0.0, 0.0)";
    const auto one = [&](int i) {
      return "float(int(" + read(FOREDRAW_PACKED_U + i) + ") + " + number(layout_.uv_origin[i]) + ") * " +
             number(layout_.uv_step[i]);
    };
    return "$f2(" + one(0) + ", " + one(1) + ")";
  }

  std::string write_number(int field, const std::string& value, float step, std::int32_t origin,
                           const std::string& outside) const {
    return write(field, "packed_code(" + value + ", " + number(1.0f / step) + ", " + number(origin) + ", " +
                            number(static_cast<std::int32_t>(foredraw_packed_most(bits(field)))) + ", " + outside +
                            ")");
  }

  std::string encode() const {
    std::string text(encode_begin);
    const std::string axes[] = {"x", "y", "z"};
    for (int i = 0; i < 3; ++i) {
      text += write_number(FOREDRAW_PACKED_X + i, "vertex.position." + axes[i], layout_.step, layout_.origin[i],
                           "position_is_outside");
    }
    for (int i = 0; i < 2 && bits(FOREDRAW_PACKED_U) != 0; ++i) {
      text += write_number(FOREDRAW_PACKED_U + i, "vertex.uv." + axes[i], layout_.uv_step[i], layout_.uv_origin[i],
                           "uv_is_outside");
    }
    if (normal_bits() != 0) text += encode_directions();
    return text + std::string(encode_end);
  }

  std::string encode_directions() const {
    const std::string cell = layout_.is_spherical == 0
                                 ? "packed_octahedral_cell(unit, " + number(normal_bits()) + ")"
                                 : "packed_spherical_cell(unit, " + number(normal_bits()) + ", " + per_most() + ")";
    std::string text = with_words(encode_normal, {{"$cell", cell},
                                                  {"$corner", normal_of("at.x", "at.y")},
                                                  {"$mostu", number(foredraw_packed_most(normal_bits()))}});
    text += write(FOREDRAW_PACKED_NORMAL_0, "code.x") + write(FOREDRAW_PACKED_NORMAL_1, "code.y");
    if (bits(FOREDRAW_PACKED_TANGENT) == 0) return text;
    return text +
           write(FOREDRAW_PACKED_TANGENT, "packed_tangent_code(normal, vertex.tangent.xyz, " +
                                              number(bits(FOREDRAW_PACKED_TANGENT)) + ", tangent_is_none)") +
           write(FOREDRAW_PACKED_SIGN, "(vertex.tangent.w < 0.0 ? 1u : 0u)");
  }

  const PackedLayout& layout_;
};

}  // namespace

std::vector<PackedLayout> distinct_layouts(const PackedVertices& all) {
  std::vector<PackedLayout> layouts;
  const auto add = [&](const PackedLayout& layout) {
    if (std::ranges::find(layouts, layout) == layouts.end()) layouts.push_back(layout);
  };
  for (const PackedVertices::OfDraw& draw : all.draws) add(draw.layout);
  for (const PackedVertices::OfDraw& draw : all.draws) {
    if (draw.posed) add(*draw.posed);
  }
  return layouts;
}

std::string packed_shader_text(const PackedLayout& layout, ShaderLanguage language) {
  return with_words(LayoutText(layout).text(), words_of(language));
}

}  // namespace foredraw::processors::vertex_pack
