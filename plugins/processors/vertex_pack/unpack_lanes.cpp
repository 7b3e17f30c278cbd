#include "vertex_pack.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "plugins/processors/vertex_pack/unpack_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "lanes.h"

#include <algorithm>
#include <array>

HWY_BEFORE_NAMESPACE();
namespace foredraw::processors::vertex_pack::HWY_NAMESPACE {

/// The rows' words as they are taken apart.
struct ReadRows {
  const foredraw_packed_layout& layout;
  Word words[4];

  HWY_INLINE Word read(int which) const {
    const foredraw_packed_field& field = layout.field[which];
    const Word shifted = hn::ShiftRightSame(words[field.word], static_cast<int>(field.shift));
    return hn::And(shifted, hn::Set(Words(), foredraw_packed_most(field.bits)));
  }
  HWY_INLINE Number read_number(int which, std::int32_t origin, float step) const {
    const Whole at = hn::Add(hn::BitCast(Ints(), read(which)), whole(origin));
    return hn::Mul(hn::ConvertTo(Floats(), at), number(step));
  }
};

HWY_INLINE Three normal_of(const ReadRows& rows) {
  const Whole half = whole((1 << (rows.layout.field[FOREDRAW_PACKED_NORMAL_0].bits - 1)) - 1);
  return octahedral(hn::Sub(hn::BitCast(Ints(), rows.read(FOREDRAW_PACKED_NORMAL_0)), half),
                    hn::Sub(hn::BitCast(Ints(), rows.read(FOREDRAW_PACKED_NORMAL_1)), half), half);
}

HWY_INLINE Whole wave(Whole code, std::int32_t quarter) {
  const Whole turn = hn::And(code, whole(4 * quarter - 1));
  return hn::Sub(hn::Abs(hn::Sub(turn, whole(2 * quarter))), whole(quarter));
}

HWY_INLINE Three tangent_of(const Three& normal, Word code, std::uint32_t bits) {
  const Floats f;
  const std::int32_t quarter = 1 << (bits - 2);
  const Whole at = hn::BitCast(Ints(), code);
  const Whole along = wave(at, quarter), across = wave(hn::Sub(at, whole(quarter)), quarter);
  const auto is_x = hn::Gt(hn::Abs(normal.x), hn::Abs(normal.z));
  const Number p = hn::IfThenElse(is_x, normal.z, normal.x), q = normal.y;
  const Number r = hn::IfThenElse(is_x, normal.x, normal.z);
  const Number squared = hn::Add(hn::Mul(q, q), hn::Mul(r, r));
  const Whole length = hn::Add(hn::Mul(along, along), hn::Mul(across, across));
  const Number per_length = rsqrt(hn::Mul(hn::ConvertTo(f, length), squared));
  const Number c = hn::Mul(hn::ConvertTo(f, along), per_length), s = hn::Mul(hn::ConvertTo(f, across), per_length);
  const Number first = hn::Mul(s, squared), last = hn::Sub(hn::Mul(c, q), hn::Mul(s, hn::Mul(p, r)));
  const Number middle = hn::Sub(hn::Sub(hn::Zero(f), hn::Mul(c, r)), hn::Mul(s, hn::Mul(p, q)));
  return {hn::IfThenElse(is_x, last, first), middle, hn::IfThenElse(is_x, first, last)};
}

/// As many vertices as a register has lanes. Null pointers: that is not wanted.
HWY_INLINE void unpack_some(const foredraw_packed_layout& layout, const std::uint32_t* from, float* positions,
                            float* normals, float* tangents, float* uvs) {
  const Floats f;
  const Words u;
  ReadRows rows{layout, {}};
  hn::LoadInterleaved4(u, from, rows.words[0], rows.words[1], rows.words[2], rows.words[3]);
  if (positions != nullptr) {
    hn::StoreInterleaved3(rows.read_number(FOREDRAW_PACKED_X, layout.origin[0], layout.step),
                          rows.read_number(FOREDRAW_PACKED_Y, layout.origin[1], layout.step),
                          rows.read_number(FOREDRAW_PACKED_Z, layout.origin[2], layout.step), f, positions);
  }
  if (uvs != nullptr) {
    hn::StoreInterleaved2(rows.read_number(FOREDRAW_PACKED_U, layout.uv_origin[0], layout.uv_step[0]),
                          rows.read_number(FOREDRAW_PACKED_V, layout.uv_origin[1], layout.uv_step[1]), f, uvs);
  }
  if (normals == nullptr && tangents == nullptr) return;
  const Three normal = normal_of(rows);
  if (normals != nullptr) hn::StoreInterleaved3(normal.x, normal.y, normal.z, f, normals);
  if (tangents == nullptr) return;
  const Three tangent =
      tangent_of(normal, rows.read(FOREDRAW_PACKED_TANGENT), layout.field[FOREDRAW_PACKED_TANGENT].bits);
  const auto is_left = hn::Ne(rows.read(FOREDRAW_PACKED_SIGN), hn::Zero(u));
  const Number sign = hn::IfThenElse(hn::RebindMask(f, is_left), number(-1), number(1));
  hn::StoreInterleaved4(tangent.x, tangent.y, tangent.z, sign, f, tangents);
}

HWY_ATTR void unpack(const foredraw_packed_layout& layout, const std::uint32_t* rows, std::size_t count,
                     float* positions, float* normals, float* tangents, float* uvs) {
  const std::size_t lanes = hn::Lanes(Floats());
  const auto at = [](float* values, std::size_t offset) { return values == nullptr ? nullptr : values + offset; };
  std::size_t v = 0;
  for (; v + lanes <= count; v += lanes) {
    unpack_some(layout, rows + 4 * v, at(positions, 3 * v), at(normals, 3 * v), at(tangents, 4 * v), at(uvs, 2 * v));
  }
  if (v == count) return;
  const std::size_t rest = count - v;
  std::array<std::uint32_t, 32> padded{};
  std::array<float, 32> some[4];
  std::copy_n(rows + 4 * v, 4 * rest, padded.begin());
  const auto room = [](float* values, std::array<float, 32>& of) { return values == nullptr ? nullptr : of.data(); };
  unpack_some(layout, padded.data(), room(positions, some[0]), room(normals, some[1]), room(tangents, some[2]),
              room(uvs, some[3]));
  const auto copy = [&](const std::array<float, 32>& of, float* values, std::size_t components) {
    if (values != nullptr) std::copy_n(of.begin(), components * rest, values + components * v);
  };
  copy(some[0], positions, 3);
  copy(some[1], normals, 3);
  copy(some[2], tangents, 4);
  copy(some[3], uvs, 2);
}

}  // namespace foredraw::processors::vertex_pack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foredraw {

namespace processors::vertex_pack {

HWY_EXPORT(unpack);

/// With the layout's own functions, one by one.
void unpack_spherical(const PackedLayout& layout, std::span<const std::uint32_t> rows, const UnpackedVertices& to) {
  for (std::size_t v = 0; v < rows.size() / 4; ++v) {
    foredraw_packed_vertex vertex;
    foredraw_packed_decode(&layout, rows.data() + 4 * v, &vertex);
    const auto& [p, n, t, uv] = vertex;
    if (!to.positions.empty()) to.positions[v] = {p[0], p[1], p[2]};
    if (!to.normals.empty()) to.normals[v] = {n[0], n[1], n[2]};
    if (!to.tangents.empty()) to.tangents[v] = {t[0], t[1], t[2], t[3]};
    if (!to.uvs.empty()) to.uvs[v] = {uv[0], uv[1]};
  }
}

}  // namespace processors::vertex_pack

void unpack_vertices(const PackedLayout& layout, std::span<const std::uint32_t> rows, const UnpackedVertices& to) {
  if (layout.is_spherical != 0) return processors::vertex_pack::unpack_spherical(layout, rows, to);
  const auto wanted = [&](auto values, int field) -> float* {
    if (layout.field[field].bits != 0) return values.empty() ? nullptr : &values[0][0];
    std::ranges::fill(values, typename decltype(values)::element_type(0));
    return nullptr;
  };
  HWY_DYNAMIC_DISPATCH(processors::vertex_pack::unpack)
  (layout, rows.data(), rows.size() / 4, wanted(to.positions, FOREDRAW_PACKED_X),
   wanted(to.normals, FOREDRAW_PACKED_NORMAL_0), wanted(to.tangents, FOREDRAW_PACKED_TANGENT),
   wanted(to.uvs, FOREDRAW_PACKED_U));
}

}  // namespace foredraw
#endif
