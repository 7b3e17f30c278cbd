#include "vertex_pack.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/processors/vertex_pack/pack_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::vertex_pack::HWY_NAMESPACE {

using Mask = hn::Mask<Floats>;

/// Rows as they are put together, and which vertices they do not hold as they were.
struct WrittenRows {
  const foredraw_packed_layout& layout;
  Word words[4];
  Mask position_outside, uv_outside, no_normal, no_tangent;

  HWY_INLINE explicit WrittenRows(const foredraw_packed_layout& of) : layout(of) {
    for (Word& word : words) word = hn::Zero(Words());
    position_outside = uv_outside = no_normal = no_tangent = hn::FirstN(Floats(), 0);
  }

  HWY_INLINE void write(int which, Whole code) {
    const foredraw_packed_field& field = layout.field[which];
    const Word shifted = hn::ShiftLeftSame(hn::BitCast(Words(), code), static_cast<int>(field.shift));
    words[field.word] = hn::Or(words[field.word], shifted);
  }
  HWY_INLINE void write_number(int which, Number value, float step, std::int32_t origin, Mask& is_outside) {
    const Number least = number(-33554432.0f), scaled = hn::Mul(value, number(1.0f / step));
    const Number at = hn::Min(hn::IfThenElse(hn::Ge(scaled, least), scaled, least), number(33554432.0f));
    const Whole most = whole(static_cast<std::int32_t>(foredraw_packed_most(layout.field[which].bits)));
    const Whole code = hn::Sub(hn::NearestInt(at), whole(origin)), zero = hn::Zero(Ints());
    const auto outside = hn::Or(hn::Lt(code, zero), hn::Gt(code, most));
    is_outside = hn::Or(is_outside, hn::RebindMask(Floats(), outside));
    write(which, hn::Min(hn::Max(code, zero), most));
  }
};

/// Where a unit vector lies on the octahedron's square, in cells from its lower edge on.
HWY_INLINE Whole cell(Number value, Number folded, Number size, std::int32_t half) {
  const Number at = hn::IfThenElse(hn::Lt(value, hn::Zero(Floats())), hn::Sub(size, folded), hn::Add(size, folded));
  return hn::Min(hn::Max(hn::ConvertTo(Ints(), at), hn::Zero(Ints())), whole(2 * half - 1));
}

/// Writes the nearest one of the cell's corners, and answers with what it decodes to.
HWY_INLINE Three write_normal(WrittenRows& rows, const Three& unit) {
  const std::int32_t half = (1 << (rows.layout.field[FOREDRAW_PACKED_NORMAL_0].bits - 1)) - 1;
  const Number size = number(static_cast<float>(half));
  const Number x = hn::Abs(unit.x), y = hn::Abs(unit.y);
  const Number scale = hn::Mul(size, reciprocal(hn::Add(hn::Add(x, y), hn::Abs(unit.z))));
  const Number u = hn::Mul(x, scale), v = hn::Mul(y, scale);
  const Mask is_below = hn::Lt(unit.z, hn::Zero(Floats()));
  const Whole first = hn::Sub(cell(unit.x, hn::IfThenElse(is_below, hn::Sub(size, v), u), size, half), whole(half));
  const Whole second = hn::Sub(cell(unit.y, hn::IfThenElse(is_below, hn::Sub(size, u), v), size, half), whole(half));
  Whole best[2] = {first, second};
  Three decoded{};
  Number nearest = number(8);
  for (int i = 0; i < 4; ++i) {
    const Whole across = hn::Add(first, whole(i & 1)), up = hn::Add(second, whole(i >> 1));
    const Three corner = octahedral(across, up, whole(half));
    const Number dx = hn::Sub(corner.x, unit.x), dy = hn::Sub(corner.y, unit.y), dz = hn::Sub(corner.z, unit.z);
    const Number squared = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz));
    const Mask is_nearer = hn::Lt(squared, nearest);
    const auto is_nearer_whole = hn::RebindMask(Ints(), is_nearer);
    nearest = hn::IfThenElse(is_nearer, squared, nearest);
    best[0] = hn::IfThenElse(is_nearer_whole, across, best[0]);
    best[1] = hn::IfThenElse(is_nearer_whole, up, best[1]);
    decoded.x = hn::IfThenElse(is_nearer, corner.x, decoded.x);
    decoded.y = hn::IfThenElse(is_nearer, corner.y, decoded.y);
    decoded.z = hn::IfThenElse(is_nearer, corner.z, decoded.z);
  }
  rows.write(FOREDRAW_PACKED_NORMAL_0, hn::Add(best[0], whole(half)));
  rows.write(FOREDRAW_PACKED_NORMAL_1, hn::Add(best[1], whole(half)));
  return decoded;
}

HWY_INLINE Number squared_length(const Three& v) {
  return hn::Add(hn::Add(hn::Mul(v.x, v.x), hn::Mul(v.y, v.y)), hn::Mul(v.z, v.z));
}

HWY_INLINE Mask is_direction(Number squared) {
  return hn::And(hn::Gt(squared, number(1e-36f)), hn::Lt(squared, number(1e36f)));
}

HWY_INLINE Three unit_of(const Three& from, Mask& is_none) {
  const Number squared = squared_length(from), zero = hn::Zero(Floats());
  const Mask holds = is_direction(squared);
  is_none = hn::Or(is_none, hn::Not(holds));
  const Number per_length = rsqrt(hn::IfThenElse(holds, squared, number(1)));
  return {hn::IfThenElse(holds, hn::Mul(from.x, per_length), zero),
          hn::IfThenElse(holds, hn::Mul(from.y, per_length), zero),
          hn::IfThenElse(holds, hn::Mul(from.z, per_length), number(1))};
}

HWY_INLINE void write_tangent(WrittenRows& rows, const Three& normal, const Three& tangent, Number handedness) {
  const Number zero = hn::Zero(Floats());
  const std::uint32_t bits = rows.layout.field[FOREDRAW_PACKED_TANGENT].bits;
  const Mask is_x = hn::Gt(hn::Abs(normal.x), hn::Abs(normal.z));
  const Number p = hn::IfThenElse(is_x, normal.z, normal.x), q = normal.y;
  const Number r = hn::IfThenElse(is_x, normal.x, normal.z);
  const Number first = hn::IfThenElse(is_x, tangent.z, tangent.x), middle = tangent.y;
  const Number last = hn::IfThenElse(is_x, tangent.x, tangent.z);
  const Number c = hn::Sub(hn::Mul(last, q), hn::Mul(middle, r));
  const Number s = hn::Sub(hn::Mul(first, hn::Add(hn::Mul(q, q), hn::Mul(r, r))),
                           hn::Add(hn::Mul(middle, hn::Mul(p, q)), hn::Mul(last, hn::Mul(p, r))));
  const Number across = hn::Abs(s), sum = hn::Add(hn::Abs(c), across);
  const Number squared = squared_length({first, middle, last});
  const Mask holds = hn::And(is_direction(squared), hn::Gt(hn::Mul(sum, sum), hn::Mul(squared, number(1e-10f))));
  rows.no_tangent = hn::Or(rows.no_tangent, hn::Not(holds));
  Number part = hn::Mul(across, reciprocal(hn::IfThenElse(holds, sum, number(1))));
  part = hn::IfThenElse(hn::Lt(c, zero), hn::Sub(number(2), part), part);
  part = hn::IfThenElse(hn::Lt(s, zero), hn::Sub(number(4), part), part);
  const Number at = hn::IfThenElseZero(holds, hn::Mul(part, number(static_cast<float>(1 << (bits - 2)))));
  const Whole code = hn::And(hn::NearestInt(at), whole(static_cast<std::int32_t>(foredraw_packed_most(bits))));
  rows.write(FOREDRAW_PACKED_TANGENT, code);
  const auto is_left = hn::RebindMask(Ints(), hn::Lt(handedness, zero));
  rows.write(FOREDRAW_PACKED_SIGN, hn::IfThenElseZero(is_left, whole(1)));
}

/// As many vertices as a register has lanes. Null pointers: that is not there.
HWY_INLINE void pack_some(WrittenRows& rows, const float* positions, const float* normals, const float* tangents,
                          const float* uvs, std::uint32_t* to) {
  const Floats f;
  const foredraw_packed_layout& layout = rows.layout;
  for (Word& word : rows.words) word = hn::Zero(Words());
  if (positions != nullptr) {
    Number axis[3];
    hn::LoadInterleaved3(f, positions, axis[0], axis[1], axis[2]);
    for (int i = 0; i < 3; ++i) {
      rows.write_number(FOREDRAW_PACKED_X + i, axis[i], layout.step, layout.origin[i], rows.position_outside);
    }
  }
  if (uvs != nullptr) {
    Number uv[2];
    hn::LoadInterleaved2(f, uvs, uv[0], uv[1]);
    for (int i = 0; i < 2; ++i) {
      rows.write_number(FOREDRAW_PACKED_U + i, uv[i], layout.uv_step[i], layout.uv_origin[i], rows.uv_outside);
    }
  }
  if (normals != nullptr) {
    Three normal;
    hn::LoadInterleaved3(f, normals, normal.x, normal.y, normal.z);
    const Three decoded = write_normal(rows, unit_of(normal, rows.no_normal));
    if (tangents != nullptr) {
      Three tangent;
      Number handedness;
      hn::LoadInterleaved4(f, tangents, tangent.x, tangent.y, tangent.z, handedness);
      write_tangent(rows, decoded, tangent, handedness);
    }
  }
  hn::StoreInterleaved4(rows.words[0], rows.words[1], rows.words[2], rows.words[3], Words(), to);
}

HWY_ATTR std::uint32_t pack(const foredraw_packed_layout& layout, std::size_t count, const float* positions,
                            const float* normals, const float* tangents, const float* uvs, std::uint32_t* to) {
  const std::size_t lanes = hn::Lanes(Floats());
  const auto at = [](const float* values, std::size_t offset) { return values == nullptr ? nullptr : values + offset; };
  WrittenRows rows(layout);
  std::size_t v = 0;
  for (; v + lanes <= count; v += lanes) {
    pack_some(rows, at(positions, 3 * v), at(normals, 3 * v), at(tangents, 4 * v), at(uvs, 2 * v), to + 4 * v);
  }
  if (const std::size_t rest = count - v; rest > 0) {  // with the last vertex again and again
    std::array<float, 32> some[4];
    std::array<std::uint32_t, 32> words;
    const auto padded = [&](const float* values, std::size_t components, std::array<float, 32>& of) HWY_ATTR {
      if (values == nullptr) return static_cast<const float*>(nullptr);
      for (std::size_t i = 0; i < lanes; ++i) {
        std::copy_n(values + components * (v + std::min(i, rest - 1)), components, of.begin() + components * i);
      }
      return static_cast<const float*>(of.data());
    };
    pack_some(rows, padded(positions, 3, some[0]), padded(normals, 3, some[1]), padded(tangents, 4, some[2]),
              padded(uvs, 2, some[3]), words.data());
    std::copy_n(words.begin(), 4 * rest, to + 4 * v);
  }
  const Floats f;
  std::uint32_t told = hn::AllFalse(f, rows.position_outside) ? 0 : FOREDRAW_PACKED_POSITION_OUTSIDE;
  if (!hn::AllFalse(f, rows.uv_outside)) told |= FOREDRAW_PACKED_UV_OUTSIDE;
  if (!hn::AllFalse(f, rows.no_normal)) told |= FOREDRAW_PACKED_NO_NORMAL;
  if (!hn::AllFalse(f, rows.no_tangent)) told |= FOREDRAW_PACKED_NO_TANGENT;
  return told;
}

}  // namespace foredraw::processors::vertex_pack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

namespace processors::vertex_pack {

HWY_EXPORT(pack);

}  // namespace processors::vertex_pack

namespace {

template <class Values>
const float* given(const PackedLayout& layout, const Values& values, int field) {
  return layout.field[field].bits == 0 || values.empty() ? nullptr : &values[0][0];
}

/// Without the fields of what is not there.
foredraw_packed_layout without_missing(const PackedLayout& layout, const PlainVertices& from) {
  foredraw_packed_layout some = layout;
  const auto leave_out = [&](int first, int count) {
    for (int i = first; i < first + count; ++i) some.field[i].bits = 0;
  };
  if (from.positions.empty()) leave_out(FOREDRAW_PACKED_X, 3);
  if (from.normals.empty()) leave_out(FOREDRAW_PACKED_NORMAL_0, 4);
  if (from.tangents.empty()) leave_out(FOREDRAW_PACKED_TANGENT, 2);
  if (from.uvs.empty()) leave_out(FOREDRAW_PACKED_U, 2);
  return some;
}

/// With the layout's own functions, one by one.
std::uint32_t pack_spherical(const PackedLayout& layout, const PlainVertices& from, std::span<std::uint32_t> rows) {
  const foredraw_packed_layout some = without_missing(layout, from);
  std::uint32_t told = 0;
  for (std::size_t v = 0; v < rows.size() / 4; ++v) {
    foredraw_packed_vertex vertex{};
    const auto copy = [&](const auto& values, float* to) {
      for (int i = 0; !values.empty() && i < static_cast<int>(values[0].length()); ++i) to[i] = values[v][i];
    };
    copy(from.positions, vertex.position);
    copy(from.normals, vertex.normal);
    copy(from.tangents, vertex.tangent);
    copy(from.uvs, vertex.uv);
    told |= foredraw_packed_encode(&some, &vertex, rows.data() + 4 * v);
  }
  return from.positions.empty() ? told & ~FOREDRAW_PACKED_POSITION_OUTSIDE : told;
}

}  // namespace

std::uint32_t pack_vertices(const PackedLayout& layout, const PlainVertices& from, std::span<std::uint32_t> rows) {
  if (layout.is_spherical != 0) return pack_spherical(layout, from, rows);
  return HWY_DYNAMIC_DISPATCH(processors::vertex_pack::pack)(
      layout, rows.size() / 4, given(layout, from.positions, FOREDRAW_PACKED_X),
      given(layout, from.normals, FOREDRAW_PACKED_NORMAL_0), given(layout, from.tangents, FOREDRAW_PACKED_TANGENT),
      given(layout, from.uvs, FOREDRAW_PACKED_U), rows.data());
}

}  // namespace foredraw
#endif
