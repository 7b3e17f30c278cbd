#include "wire_streams.h"

#include <foredraw/geometry/finite.h>

#include <glm/vec2.hpp>

#include <algorithm>
#include <string>

namespace foredraw::processors::wire_radius {

namespace {

constexpr Format of_four{Component::float32, 4, false, 16}, of_two{Component::float32, 2, false, 8};

template <class Row>
VertexStream stream_of(std::string_view semantic, const Format& format, const std::vector<Row>& rows) {
  const auto bytes = std::as_bytes(std::span(rows));
  return {std::string(semantic), format, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

std::string texcoord(std::uint32_t set) { return "TEXCOORD_" + std::to_string(set); }

bool is_ours(const VertexStream& stream) {
  return stream.semantic == wire_semantic || stream.semantic == wire_axis_semantic;
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

std::shared_ptr<const VertexStreams> without_wire_streams(const VertexStreams& vertices,
                                                          std::optional<std::uint32_t> texcoords) {
  auto changed = std::make_shared<VertexStreams>(vertices);
  std::erase_if(changed->base, is_ours);
  for (std::uint32_t i = 0; i < 4 && texcoords; ++i) {
    std::erase_if(changed->base, [&](const VertexStream& of) { return of.semantic == texcoord(*texcoords + i); });
  }
  return changed;
}

std::uint32_t first_free_texcoord(const VertexStreams& vertices) {
  constexpr std::uint32_t most = 1000;
  for (std::uint32_t set = most; set > 0; --set) {
    if (vertices.find(texcoord(set - 1)) != nullptr) return set;
  }
  return 0;
}

std::shared_ptr<const VertexStreams> with_wire_streams(const VertexStreams& vertices, const FoundWires& found,
                                                       std::size_t first, std::span<const CopiedVertex> copies,
                                                       std::optional<std::uint32_t> texcoords) {
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
  if (!texcoords) {
    changed->base.push_back(stream_of(wire_semantic, of_four, wires));
    changed->base.push_back(stream_of(wire_axis_semantic, of_four, axes));
    return changed;
  }
  std::uint32_t set = *texcoords;
  for (const std::vector<glm::vec4>* rows : {&wires, &axes}) {
    for (const int c : {0, 2}) {
      std::vector<glm::vec2> pairs;
      pairs.reserve(rows->size());
      for (const glm::vec4& row : *rows) pairs.emplace_back(row[c], row[c + 1]);
      changed->base.push_back(stream_of(texcoord(set++), of_two, pairs));
    }
  }
  return changed;
}

std::optional<std::vector<glm::vec4>> wire_rows(const VertexStreams& vertices, std::optional<std::uint32_t> texcoords) {
  auto of = decoded_wires(vertices, texcoords);
  const auto are_numbers = [](const glm::vec4& row) { return is_finite(row); };
  if (!of || !std::ranges::all_of(of->wires, are_numbers) || !std::ranges::all_of(of->axes, are_numbers)) {
    return std::nullopt;
  }
  return std::move(of->wires);
}

}  // namespace foredraw::processors::wire_radius
