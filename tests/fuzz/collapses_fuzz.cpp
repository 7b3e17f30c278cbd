// The bytes are an odd mesh, and either a sequence of collapses or the options of who finds one. What is refused is
// refused with a reason; what runs cleanly can be cut anywhere; what quadric-collapse answers with runs cleanly.
// Numbers that vertices carry come along: solved for or blended, they lie between those that there were.

#include "claim.h"
#include "odd_input.h"

#include <foredraw/collapses/cut.h>
#include <foredraw/collapses/level_vertices.h>
#include <foredraw/scene/draw.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace foredraw {
namespace {

using testing::OddInput;

CollapseSequence any_sequence(OddInput& input, std::size_t vertices) {
  CollapseSequence sequence;
  const std::size_t kind = input.below(4);
  const bool has_places = kind % 2 == 0;
  sequence.solves = kind >= 2;
  float error = 0;
  while (input.left() > 0 && sequence.collapses.size() < 64) {
    const auto vertex = [&] { return static_cast<std::uint32_t>(input.below(vertices + 1)); };
    const std::uint8_t how = input.byte();
    error += static_cast<float>(how % 3);
    sequence.first_pair.push_back(static_cast<std::uint32_t>(sequence.pairs.size()));
    const std::uint32_t removed = vertex(), kept = vertex();
    sequence.collapses.push_back(
        {removed, kept, how < 250 ? 0.5f : input.number(), how < 250 ? error : input.number()});
    sequence.pairs.push_back({removed, kept});
    for (int i = how % 4; i > 2; --i) sequence.pairs.push_back({vertex(), vertex()});
    for (int k = 0; has_places && k < 3; ++k) sequence.places.push_back(how < 253 ? float(k) : input.number());
  }
  sequence.first_pair.push_back(static_cast<std::uint32_t>(sequence.pairs.size()));
  return sequence;
}

void check_cuts(const CollapseSequence& sequence, const Replay& run, std::span<const glm::vec3> positions,
                std::span<const std::uint32_t> indices) {
  claim(run.triangles.size() == sequence.collapses.size() + 1, "a number of triangles is missing");
  for (std::size_t n = 0; n <= sequence.collapses.size(); ++n) {
    const Collapsed cut = collapsed(sequence, n, positions, indices);
    claim(cut.indices.size() == std::size_t{3} * run.triangles[n] && cut.origin.size() == run.triangles[n],
          "a cut has other triangles than the replay");
    for (const std::uint32_t vertex : cut.indices)
      claim(vertex < positions.size() && cut.vertex[vertex] == vertex, "a corner has a vertex that is gone");
  }
}

VertexStream stream_of(const char* semantic, std::size_t width, std::span<const float> values) {
  const auto bytes = std::as_bytes(values);
  return {semantic,
          Format{Component::float32, static_cast<std::uint8_t>(width), false, static_cast<std::uint16_t>(4 * width)},
          Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// One draw, whose vertices carry numbers, directions, and a morph target.
JoinedMesh mesh_of(const std::vector<glm::vec3>& positions, const std::vector<std::uint32_t>& indices,
                   std::size_t width, const std::vector<float>& values) {
  const std::span<const float> coordinates(&positions.front().x, 3 * positions.size());
  VertexStreams streams;
  streams.count = static_cast<std::uint32_t>(positions.size());
  streams.base = {stream_of("POSITION", 3, coordinates), stream_of("NORMAL", 3, coordinates)};
  if (width > 0) streams.base.push_back(stream_of("_NUMBERS", width, values));
  streams.morph_targets = {{stream_of("POSITION", 3, coordinates)}};
  JoinedMesh mesh;
  mesh.positions = positions;
  mesh.indices = indices;
  mesh.part.resize(positions.size());
  mesh.first_vertex = {0, streams.count};
  mesh.first_index = {0, static_cast<std::uint32_t>(indices.size())};
  mesh.streams = {std::make_shared<const VertexStreams>(std::move(streams))};
  mesh.stream_of = {0};
  return mesh;
}

/// Each component of what a vertex has left lies between those that there were. Nothing is known where one is no
/// number.
void check_between(const VertexStream& made, const VertexStream& was) {
  for (std::size_t c = 0; c < was.format.components; ++c) {
    float least = INFINITY, most = -INFINITY;
    for (std::size_t v = 0; v < was.count(); ++v) {
      const float value = decode_component(was, v, c);
      if (!std::isfinite(value)) return;
      least = std::min(least, value), most = std::max(most, value);
    }
    const float slack = 1e-6f * std::max(std::abs(least), std::abs(most));
    for (std::size_t v = 0; v < made.count(); ++v) {
      const float value = decode_component(made, v, c);
      claim(value >= least - slack && value <= most + slack, made.semantic + " lies beyond what there was");
    }
  }
}

void check_directions(const VertexStream& made, const VertexStream& was) {
  for (std::size_t v = 0; v < was.count(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(decode_component(was, v, c))) return;
    }
  }
  for (std::size_t v = 0; v < made.count(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      claim(std::isfinite(decode_component(made, v, c)), "a direction is no number any more");
    }
  }
}

/// At the end and on the way there.
void check_levels(const CollapseSequence& sequence, const JoinedMesh& mesh) {
  const std::size_t all = sequence.collapses.size();
  for (const std::size_t n : {std::size_t{0}, all / 3, all}) {
    const Collapsed after = collapsed(sequence, n, mesh);
    const LevelVertices level = level_vertices(sequence, n, after, mesh).front();
    for (const std::uint32_t vertex : after.indices) {
      claim(level.number[vertex] < level.vertices->count, "a vertex of the level is missing");
    }
    const VertexStreams& was = *mesh.streams.front();
    if (n == 0) {
      for (std::size_t v = 0; v < was.count; ++v) {
        if (level.number[v] == no_vertex) continue;
        for (std::size_t s = 1; s < was.base.size(); ++s) {
          const std::size_t bytes = was.base[s].format.bytes;
          claim(std::memcmp(level.vertices->base[s].bytes.view().data() + level.number[v] * bytes,
                            was.base[s].bytes.view().data() + v * bytes, bytes) == 0,
                "what nothing changed is another");
        }
      }
    }
    check_directions(level.vertices->base[1], was.base[1]);
    if (was.base.size() > 2) check_between(level.vertices->base[2], was.base[2]);
    check_between(level.vertices->morph_targets[0][0], was.morph_targets[0][0]);
  }
}

void run(OddInput input) {
  const std::size_t vertices = 1 + input.below(60);
  std::vector<glm::vec3> positions(vertices);
  for (glm::vec3& position : positions) position = {input.number(), input.number(), input.number()};
  const std::vector<std::uint32_t> indices = testing::odd_indices(input, vertices, 3 * input.below(100));
  if (input.below(2) == 0) {
    const CollapseSequence sequence = any_sequence(input, vertices);
    const Replay replayed = replay(sequence, positions, indices);
    if (!replayed.mistake.empty()) return;
    check_cuts(sequence, replayed, positions, indices);
    std::vector<float> numbers;
    for (const glm::vec3& p : positions) numbers.insert(numbers.end(), {p.y, p.x * 0.5f});
    check_levels(sequence, mesh_of(positions, indices, 2, numbers));
    return;
  }
  QuadricCollapseOptions options;
  options.placement = input.below(2) == 0 ? CollapsePlacement::optimal : CollapsePlacement::endpoint;
  options.memory = input.byte() / 255.0;
  options.deviation = input.byte() / 255.0;
  options.border = input.byte();
  options.least = input.below(20);
  options.parts = input.byte() / 255.0;
  AttributeRows attributes{input.below(4), {}};
  for (std::size_t i = 0; i < attributes.width * vertices; ++i) {
    const float value = input.number();
    attributes.values.push_back(std::isfinite(value) ? value : 0);
  }
  PosedVertices posed{std::vector<double>(input.below(3), 0.5), {}};
  posed.maps.resize(posed.poses() * vertices);
  for (glm::dmat4x3& map : posed.maps) {
    for (int i = 0; i < 12; ++i) {
      const float value = input.number();
      map[i / 3][i % 3] = std::isfinite(value) ? value : 0;
    }
  }
  const std::size_t kind = input.below(8);
  options.solves = kind % 2 == 0;
  if (attributes.width == 3 && kind >= 4) attributes.directions = {{0, 1}};
  if (attributes.width > 0 && attributes.directions.empty()) attributes.blended = input.below(attributes.width + 1);
  const CollapseSequence sequence = quadric_collapse(positions, indices, options, attributes, {}, posed);
  const Replay replayed = replay(sequence, positions, indices);
  claim(replayed.mistake.empty(), "quadric-collapse: " + replayed.mistake);
  check_cuts(sequence, replayed, positions, indices);
  check_levels(sequence, mesh_of(positions, indices, attributes.width, attributes.values));
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foredraw::run({data, size});
  return 0;
}
