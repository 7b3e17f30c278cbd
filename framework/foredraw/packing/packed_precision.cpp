#include <foredraw/packing/packed_precision.h>

#include <foredraw/geometry/finite.h>
#include <foredraw/scene/scaled_texcoords.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foredraw {

namespace {

constexpr double degrees = 180 / std::numbers::pi;
constexpr double rounding = 1e-6;  // radians that floats may add to an angle

double normal_bound(const PackedLayout& layout) {
  const auto bits = static_cast<int>(layout.field[FOREDRAW_PACKED_NORMAL_0].bits);
  if (bits == 0) return 0;
  const double beside = 1 + std::ldexp(1.0, bits - 22);  // parts of a cell
  if (layout.is_spherical == 0) return 2 * std::numbers::sqrt2 / (std::ldexp(1.0, bits) - 2) * beside + rounding;
  const double around = std::numbers::pi / std::ldexp(1.0, bits);
  const double down = std::numbers::pi / 2 / (std::ldexp(1.0, bits) - 1);
  return std::sqrt(around * around + down * down) * beside + rounding;
}

double tangent_bound(const PackedLayout& layout, double skew) {
  const auto bits = static_cast<int>(layout.field[FOREDRAW_PACKED_TANGENT].bits);
  if (bits == 0) return 0;
  const double out = skew / degrees + normal_bound(layout);
  const double in = 4 / std::ldexp(1.0, bits) * (1 + std::ldexp(1.0, bits - 22));
  return std::sqrt(out * out + in * in) + rounding;
}

double uv_bound(const PackedLayout& layout, int axis) {
  const std::uint32_t bits = layout.field[FOREDRAW_PACKED_U + axis].bits;
  if (bits == 0) return 0;
  const double first = layout.uv_origin[axis], last = first + foredraw_packed_most(bits);
  const double largest = std::max(std::abs(first), std::abs(last)) + 1;
  return (0.5 + 3 * largest * 0x1p-24) * static_cast<double>(layout.uv_step[axis]);
}

/// A stream's elements as a vertex has them; null where there is no such stream, or the layout has no such field.
const VertexStream* packed_stream(const VertexStreams& vertices, const char* semantic, std::uint8_t components,
                                  std::uint32_t bits) {
  const VertexStream* stream = bits == 0 ? nullptr : vertices.find(semantic);
  return stream != nullptr && stream->format.components >= components && stream->count() >= vertices.count ? stream
                                                                                                           : nullptr;
}

glm::dvec3 element(const VertexStream& stream, std::size_t vertex, std::size_t components) {
  glm::dvec3 value(0);
  for (std::size_t c = 0; c < components; ++c) {
    value[static_cast<int>(c)] = static_cast<double>(decode_component(stream, vertex, c));
  }
  return value;
}

/// As runtime/packed_vertex.h asks.
bool is_direction(const glm::dvec3& v) {
  const double squared = glm::dot(v, v);
  return squared > 1.1e-36 && squared < 0.9e36;
}

double angle(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

PackedBounds packed_bounds(const PackedLayout& layout, double skew) {
  constexpr double half_diagonal = 0.8660254037844388;  // sqrt(3) / 2, rounded up
  return {half_diagonal * static_cast<double>(layout.step), normal_bound(layout) * degrees,
          tangent_bound(layout, skew) * degrees, uv_bound(layout, 0), uv_bound(layout, 1)};
}

double packed_uv_widths(const Scene& scene, DrawId draw) {
  const glm::dvec2 widths = texture_widths(scene.material_of(scene.draws[draw]), 0);
  return std::max(widths.x, widths.y);
}

PackedErrors packed_errors(const VertexStreams& vertices, const PackedLayout& layout,
                           std::span<const std::uint32_t> rows) {
  PackedErrors errors;
  const auto bits = [&](int field) { return layout.field[field].bits; };
  const VertexStream* positions = packed_stream(vertices, "POSITION", 3, 1);
  const VertexStream* normals = packed_stream(vertices, "NORMAL", 3, bits(FOREDRAW_PACKED_NORMAL_0));
  const VertexStream* tangents = packed_stream(vertices, "TANGENT", 4, bits(FOREDRAW_PACKED_TANGENT));
  const VertexStream* uvs = packed_stream(vertices, "TEXCOORD_0", 2, bits(FOREDRAW_PACKED_U));
  const auto add = [](double& most, double error) { most = std::max(most, error); };
  for (std::size_t v = 0; v < std::min<std::size_t>(vertices.count, rows.size() / 4); ++v) {
    foredraw_packed_vertex decoded;
    foredraw_packed_decode(&layout, rows.data() + 4 * v, &decoded);
    const auto of = [](const float* values) { return glm::dvec3(values[0], values[1], values[2]); };
    const glm::dvec3 position = positions == nullptr ? glm::dvec3(0) : element(*positions, v, 3);
    const glm::dvec3 uv = uvs == nullptr ? glm::dvec3(0) : element(*uvs, v, 2);
    errors.not_finite += is_finite(position) && is_finite(uv) ? 0 : 1;
    if (positions != nullptr) add(errors.most.position, glm::length(position - of(decoded.position)));
    if (uvs != nullptr) {
      add(errors.most.u, std::abs(uv.x - static_cast<double>(decoded.uv[0])));
      add(errors.most.v, std::abs(uv.y - static_cast<double>(decoded.uv[1])));
    }
    if (normals == nullptr) continue;
    const glm::dvec3 normal = element(*normals, v, 3);
    bool has_directions = is_direction(normal);
    if (has_directions) add(errors.most.normal, angle(normal, of(decoded.normal)) * degrees);
    if (tangents != nullptr) {
      const glm::dvec3 tangent = element(*tangents, v, 3);
      has_directions = has_directions && is_direction(tangent);
      const double out = has_directions ? std::abs(90 - angle(normal, tangent) * degrees) : 0;
      has_directions = has_directions && out < 89;
      if (has_directions) {
        add(errors.skew, out);
        add(errors.most.tangent, angle(tangent, of(decoded.tangent)) * degrees);
      }
      errors.handedness += (decode_component(*tangents, v, 3) < 0) != (decoded.tangent[3] < 0);
    }
    errors.no_direction += has_directions ? 0 : 1;
  }
  return errors;
}

std::string broken_promise(const VertexStreams& vertices, const PackedLayout& layout,
                           std::span<const std::uint32_t> rows) {
  if (foredraw_packed_is_layout(&layout) == 0) return "has a layout whose fields or numbers are out of range";
  if (rows.size() != std::size_t{4} * vertices.count) return "does not have four words for each vertex";
  const PackedErrors errors = packed_errors(vertices, layout, rows);
  const PackedBounds bounds = packed_bounds(layout, errors.skew);
  if (errors.not_finite > 0) return "has a position or texture coordinate that is not finite";
  if (errors.most.position > bounds.position)
    return "has a position that is farther off than half a cell of its lattice";
  if (errors.most.normal > bounds.normal) return "has a normal that is farther off than its bits allow";
  if (errors.most.tangent > bounds.tangent) return "has a tangent that is farther off than its bits allow";
  if (errors.most.u > bounds.u || errors.most.v > bounds.v) {
    return "has a texture coordinate that is farther off than half a step";
  }
  if (errors.handedness > 0) return "has a tangent whose handedness differs";
  return {};
}

}  // namespace foredraw
