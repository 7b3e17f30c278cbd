#include "wire_streams.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw::wiring {

namespace {

constexpr Format row_of_wire{Component::float32, 4, false, 16}, row_of_axis{Component::float32, 4, false, 16};

template <class Row>
VertexStream stream_of(std::string_view semantic, const Format& format, const std::vector<Row>& rows) {
  const auto bytes = std::as_bytes(std::span(rows));
  return {std::string(semantic), format, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

bool is_ours(const VertexStream& stream) {
  return stream.semantic == wire_semantic || stream.semantic == wire_axis_semantic;
}

const VertexStream* find(const VertexStreams& vertices, std::string_view semantic, const Format& format) {
  const VertexStream* stream = vertices.find(semantic);
  return stream != nullptr && stream->format == format && stream->count() == vertices.count ? stream : nullptr;
}

VertexStream with_copies(const VertexStream& stream, std::span<const std::uint32_t> vertices) {
  const std::size_t size = stream.format.bytes;
  const auto before = stream.bytes.view();
  std::vector<std::byte> bytes(before.begin(), before.end());
  bytes.reserve(before.size() + vertices.size() * size);
  for (const std::uint32_t v : vertices) {
    const auto one = before.subspan(v * size, size);
    bytes.insert(bytes.end(), one.begin(), one.end());
  }
  return {stream.semantic, stream.format, Shared(std::move(bytes))};
}

}  // namespace

std::shared_ptr<const VertexStreams> without_wire_streams(const VertexStreams& vertices) {
  auto changed = std::make_shared<VertexStreams>(vertices);
  std::erase_if(changed->base, is_ours);
  return changed;
}

std::shared_ptr<const VertexStreams> with_wire_streams(const VertexStreams& vertices, const FoundWires& found,
                                                       std::size_t first, std::span<const CopiedVertex> copies) {
  std::vector<glm::vec4> wires(vertices.count), axes(vertices.count);
  for (std::size_t v = 0; v < vertices.count; ++v) {
    wires[v] = glm::vec4(found.to_centre[first + v], found.half_width[first + v]);
    axes[v] = glm::vec4(found.axis[first + v], found.is_flat[first + v] ? 1 : 0);
  }
  auto changed = std::make_shared<VertexStreams>(vertices);
  std::erase_if(changed->base, is_ours);
  std::vector<std::uint32_t> copied;
  for (const auto& [vertex, number] : copies) {
    const FoundWires::Copy& copy = found.copies[number];
    copied.push_back(vertex);
    wires.emplace_back(copy.to_centre, copy.half_width);
    axes.emplace_back(copy.axis, 1);
  }
  if (!copied.empty()) {
    for (VertexStream& stream : changed->base) stream = with_copies(stream, copied);
    changed->count += static_cast<std::uint32_t>(copied.size());
  }
  changed->base.push_back(stream_of(wire_semantic, row_of_wire, wires));
  changed->base.push_back(stream_of(wire_axis_semantic, row_of_axis, axes));
  return changed;
}

std::optional<std::vector<glm::vec4>> wire_rows(const VertexStreams& vertices) {
  const VertexStream* wire = find(vertices, wire_semantic, row_of_wire);
  const VertexStream* axis = find(vertices, wire_axis_semantic, row_of_axis);
  if (wire == nullptr || axis == nullptr) return std::nullopt;
  std::vector<glm::vec4> rows(vertices.count);
  std::vector<float> axes(4 * std::size_t{vertices.count});
  std::memcpy(rows.data(), wire->bytes.view().data(), wire->bytes.size());
  std::memcpy(axes.data(), axis->bytes.view().data(), axis->bytes.size());
  const auto is_number = [](float value) { return std::isfinite(value); };
  const bool are_numbers = std::ranges::all_of(axes, is_number) && std::ranges::all_of(rows, [&](const glm::vec4& row) {
                             return is_number(row.x) && is_number(row.y) && is_number(row.z) && is_number(row.w);
                           });
  if (!are_numbers) return std::nullopt;
  return rows;
}

}  // namespace foredraw::wiring
