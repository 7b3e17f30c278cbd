// The bytes are an odd mesh, and either a sequence of collapses or the options of who finds one. What is refused is
// refused with a reason; what runs cleanly can be cut anywhere; what quadric-collapse answers with runs cleanly.

#include "claim.h"
#include "odd_input.h"

#include <foredraw/collapses/replay.h>
#include <plugins/processors/quadric_collapse/quadric_collapse.h>

#include <cmath>

namespace foredraw {
namespace {

using testing::OddInput;

CollapseSequence any_sequence(OddInput& input, std::size_t vertices) {
  CollapseSequence sequence;
  const bool has_places = input.below(2) == 0;
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

void run(OddInput input) {
  const std::size_t vertices = 1 + input.below(60);
  std::vector<glm::vec3> positions(vertices);
  for (glm::vec3& position : positions) position = {input.number(), input.number(), input.number()};
  const std::vector<std::uint32_t> indices = testing::odd_indices(input, vertices, 3 * input.below(100));
  if (input.below(2) == 0) {
    const CollapseSequence sequence = any_sequence(input, vertices);
    const Replay replayed = replay(sequence, positions, indices);
    if (replayed.mistake.empty()) check_cuts(sequence, replayed, positions, indices);
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
  const CollapseSequence sequence = quadric_collapse(positions, indices, options, attributes, {}, posed);
  const Replay replayed = replay(sequence, positions, indices);
  claim(replayed.mistake.empty(), "quadric-collapse: " + replayed.mistake);
  check_cuts(sequence, replayed, positions, indices);
}

}  // namespace
}  // namespace foredraw

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  foredraw::run({data, size});
  return 0;
}
