#include "vertex_numbers.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

namespace foredraw {

namespace {

struct Range {
  double least = std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();

  void add(double value) {
    least = std::min(least, value);
    most = std::max(most, value);
  }
};

float step_of(double length, std::uint32_t bits) {
  return static_cast<float>(length / (std::ldexp(1.0, static_cast<int>(bits)) - 1));
}

/// From 0 on, as far as the bits go.
std::int32_t nearest(double value, float least, float step, std::uint32_t bits) {
  if (!(step > 0) || !std::isfinite(value)) return 0;
  const double most = std::ldexp(1.0, static_cast<int>(bits)) - 1;
  return static_cast<std::int32_t>(std::clamp(std::round((value - double{least}) / double{step}), 0.0, most));
}

/// The component as it is stored; floats by their order.
std::int32_t stored(const VertexStream& stream, std::size_t vertex, std::size_t component) {
  const std::byte* at =
      stream.bytes.view().data() + vertex * stream.format.bytes + component * bytes_of(stream.format.component);
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
    if constexpr (std::is_same_v<T, float>) return foredraw_float_order(value);
    return static_cast<std::int32_t>(value);
  };
  switch (stream.format.component) {
    case Component::int8: return as(std::int8_t{});
    case Component::uint8: return as(std::uint8_t{});
    case Component::int16: return as(std::int16_t{});
    case Component::uint16: return as(std::uint16_t{});
    case Component::uint32: return as(std::uint32_t{});
    case Component::float32: break;
  }
  return as(float{});
}

/// One number of a stream's vertices.
struct Column {
  const VertexStream* stream = nullptr;
  std::uint32_t component = 0;
  std::optional<std::size_t> target;  ///< which morph target's
};

/// Places are told apart from other numbers; exact positions stand among these too.
std::vector<Column> columns_of(const VertexStreams& vertices, bool has_positions) {
  std::vector<Column> columns;
  const auto add = [&](const VertexStream& stream, std::optional<std::size_t> target) {
    for (std::uint32_t c = 0; c < stream.format.components; ++c) columns.push_back({&stream, c, target});
  };
  for (const VertexStream& stream : vertices.base) {
    if (has_positions || stream.semantic != "POSITION") add(stream, std::nullopt);
  }
  for (std::size_t t = 0; t < vertices.morph_targets.size(); ++t) {
    for (const VertexStream& stream : vertices.morph_targets[t]) add(stream, t);
  }
  return columns;
}

constexpr std::uint32_t most_bits = 24;

foredraw_component component_of(const Column& column, const NumberBits& bits) {
  const VertexStream& stream = *column.stream;
  constexpr std::uint32_t no_axis = 3;
  if (stream.format.component != Component::float32) return {0, no_axis, 0, 0};
  const bool is_base = !column.target.has_value();
  const foredraw_component exact{
      2, is_base && stream.semantic == "POSITION" ? std::min(column.component, no_axis) : no_axis, 0, 0};
  const bool is_unit = is_base && (stream.semantic == "NORMAL" || stream.semantic == "TANGENT");
  Range range;
  if (is_unit || stream.count() == 0) {
    range.add(-1);
    range.add(1);
  }
  for (std::size_t v = 0; v < stream.count(); ++v) {
    const float value = decode_component(stream, v, column.component);
    if (!std::isfinite(value)) return exact;
    range.add(value);
  }
  if (bits.lossless) return exact;
  const std::uint32_t wanted = is_unit                                    ? bits.normal_bits
                               : stream.semantic.starts_with("TEXCOORD_") ? bits.uv_bits
                                                                          : bits.other_bits;
  return {1, no_axis, static_cast<float>(range.least), step_of(range.most - range.least, wanted)};
}

}  // namespace

NumberGrid number_grid(const JoinedMesh& mesh, const NumberBits& bits) {
  NumberGrid grid;
  grid.bits = bits.position_bits;
  Range range[3];
  for (const std::uint32_t vertex : mesh.indices) {
    for (int k = 0; k < 3; ++k) {
      const float at = mesh.positions[vertex][k];
      if (!std::isfinite(at)) throw std::runtime_error("a position is not a finite number; repair the mesh first");
      range[k].add(at);
    }
  }
  double longest = 0;
  for (int k = 0; k < 3 && !mesh.indices.empty(); ++k) {
    grid.least[k] = static_cast<float>(range[k].least);
    longest = std::max(longest, range[k].most - range[k].least);
  }
  grid.step = step_of(longest, grid.bits);
  for (const auto& stream : mesh.streams) {
    const std::vector<Column> columns = columns_of(*stream, bits.lossless);
    const auto count = static_cast<std::uint32_t>(columns.size());
    grid.parts.push_back({static_cast<std::uint32_t>(grid.components.size()), count});
    for (const Column& column : columns) grid.components.push_back(component_of(column, bits));
    grid.width = std::max(grid.width, count);
  }
  return grid;
}

std::optional<VertexNumbers> vertex_numbers(const JoinedMesh& mesh, const NumberGrid& grid) {
  if (grid.parts.size() != mesh.streams.size()) return std::nullopt;
  VertexNumbers numbers;
  numbers.places.resize(3 * mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    for (int k = 0; k < 3; ++k) {
      numbers.places[3 * v + static_cast<std::size_t>(k)] =
          nearest(mesh.positions[v][k], grid.least[k], grid.step, grid.bits);
    }
  }
  numbers.values.resize(mesh.positions.size() * grid.width);
  for (std::size_t s = 0; s < grid.parts.size(); ++s) {
    const foredraw_part& part = grid.parts[s];
    std::vector<Column> columns = columns_of(*mesh.streams[s], false);
    if (columns.size() != part.count) columns = columns_of(*mesh.streams[s], true);
    if (columns.size() != part.count) return std::nullopt;
    for (std::size_t c = 0; c < columns.size(); ++c) {
      const foredraw_component& component = grid.components[part.first + c];
      const VertexStream& stream = *columns[c].stream;
      if ((component.form == 0) != (stream.format.component != Component::float32)) return std::nullopt;
      for (std::size_t v = mesh.first_vertex[s]; v < mesh.first_vertex[s + 1]; ++v) {
        const std::size_t row = v - mesh.first_vertex[s];
        numbers.values[v * grid.width + c] = component.form == 1
                                                 ? nearest(decode_component(stream, row, columns[c].component),
                                                           component.least, component.step, most_bits)
                                                 : stored(stream, row, columns[c].component);
      }
    }
  }
  return numbers;
}

std::vector<std::string> number_names(const VertexStreams& vertices, const foredraw_part& part) {
  std::vector<Column> columns = columns_of(vertices, false);
  if (columns.size() != part.count) columns = columns_of(vertices, true);
  std::vector<std::string> names;
  for (const Column& column : columns) {
    names.push_back((column.target ? "target " + std::to_string(*column.target) + ' ' : std::string()) +
                    column.stream->semantic);
  }
  return names;
}

}  // namespace foredraw
