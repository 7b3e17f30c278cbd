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

std::int32_t nearest(double value, float least, float step, std::uint32_t bits) {
  if (!(step > 0)) return 0;
  const double most = std::ldexp(1.0, static_cast<int>(bits)) - 1;
  return static_cast<std::int32_t>(std::clamp(std::round((value - double{least}) / double{step}), 0.0, most));
}

float step_of(double length, std::uint32_t bits) {
  return static_cast<float>(length / (std::ldexp(1.0, static_cast<int>(bits)) - 1));
}

void place_on_grid(const JoinedMesh& mesh, std::uint32_t bits, VertexNumbers& numbers) {
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
    numbers.least[k] = static_cast<float>(range[k].least);
    longest = std::max(longest, range[k].most - range[k].least);
  }
  numbers.step = step_of(longest, bits);
  numbers.places.resize(3 * mesh.positions.size());
  for (const std::uint32_t vertex : mesh.indices) {
    for (int k = 0; k < 3; ++k) {
      numbers.places[std::size_t{3} * vertex + static_cast<std::size_t>(k)] =
          nearest(mesh.positions[vertex][k], numbers.least[k], numbers.step, bits);
    }
  }
}

std::int32_t whole(const VertexStream& stream, std::size_t vertex, std::size_t component) {
  const std::byte* at =
      stream.bytes.view().data() + vertex * stream.format.bytes + component * bytes_of(stream.format.component);
  const auto as = [&]<class T>(T value) {
    std::memcpy(&value, at, sizeof value);
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
  float value = 0;
  std::memcpy(&value, at, sizeof value);
  return foredraw_float_order(value);
}

/// One number of a stream's vertices.
struct Column {
  const VertexStream* stream = nullptr;
  std::uint32_t component = 0;
  std::uint32_t bits = 0;  ///< of a grid
  foredraw_component told = {};
};

Column column_of(const VertexStream& stream, std::uint32_t component, bool is_base, const NumberBits& bits) {
  Column column{&stream, component, 0, {0, 3, 0, 0}};
  if (stream.format.component != Component::float32) return column;
  column.told.form = 2;
  if (is_base && stream.semantic == "POSITION" && component < 3) column.told.axis = component;
  const bool is_unit = is_base && (stream.semantic == "NORMAL" || stream.semantic == "TANGENT");
  Range range;
  if (is_unit) {
    range.add(-1);
    range.add(1);
  }
  for (std::size_t v = 0; v < stream.count(); ++v) {
    const float value = decode_component(stream, v, component);
    if (!std::isfinite(value)) return column;
    range.add(value);
  }
  if (bits.lossless || stream.count() == 0) return column;
  column.bits = is_unit ? bits.normal_bits : stream.semantic.starts_with("TEXCOORD_") ? bits.uv_bits : bits.other_bits;
  column.told = {1, 3, static_cast<float>(range.least), step_of(range.most - range.least, column.bits)};
  return column;
}

std::vector<Column> columns_of(const VertexStreams& vertices, const NumberBits& bits) {
  std::vector<Column> columns;
  const auto add = [&](const VertexStream& stream, bool is_base) {
    for (std::uint32_t c = 0; c < stream.format.components; ++c) {
      columns.push_back(column_of(stream, c, is_base, bits));
    }
  };
  for (const VertexStream& stream : vertices.base) {
    if (bits.lossless || stream.semantic != "POSITION") add(stream, true);
  }
  for (const auto& target : vertices.morph_targets) {
    for (const VertexStream& stream : target) add(stream, false);
  }
  return columns;
}

}  // namespace

VertexNumbers vertex_numbers(const JoinedMesh& mesh, const NumberBits& bits) {
  VertexNumbers numbers;
  place_on_grid(mesh, bits.position_bits, numbers);
  std::vector<std::vector<Column>> columns;
  for (const auto& stream : mesh.streams) {
    columns.push_back(columns_of(*stream, bits));
    const auto count = static_cast<std::uint32_t>(columns.back().size());
    numbers.parts.push_back({static_cast<std::uint32_t>(numbers.components.size()), count});
    for (const Column& column : columns.back()) numbers.components.push_back(column.told);
    numbers.width = std::max(numbers.width, count);
  }
  numbers.values.resize(mesh.positions.size() * numbers.width);
  for (std::size_t s = 0; s < columns.size(); ++s) {
    for (std::size_t c = 0; c < columns[s].size(); ++c) {
      const auto& [stream, component, grid, told] = columns[s][c];
      for (std::size_t v = mesh.first_vertex[s]; v < mesh.first_vertex[s + 1]; ++v) {
        const std::size_t row = v - mesh.first_vertex[s];
        numbers.values[v * numbers.width + c] =
            told.form == 1 ? nearest(decode_component(*stream, row, component), told.least, told.step, grid)
                           : whole(*stream, row, component);
      }
    }
  }
  return numbers;
}

}  // namespace foredraw
