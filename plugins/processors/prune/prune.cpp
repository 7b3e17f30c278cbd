#include "prune.h"

#include <algorithm>

namespace foredraw {

namespace {

bool are_all(const VertexStream& stream, float value) {
  for (std::size_t v = 0; v < stream.count(); ++v) {
    for (std::size_t i = 0; i < stream.format.components; ++i) {
      if (decode_component(stream, v, i) != value) return false;
    }
  }
  return true;
}

bool has_morphed_colours(const VertexStreams& vertices) {
  return std::ranges::any_of(vertices.morph_targets, [](const auto& target) {
    return std::ranges::any_of(target, [](const VertexStream& stream) { return stream.semantic == "COLOR_0"; });
  });
}

}  // namespace

PrunedStreams prune_streams(const VertexStreams& vertices) {
  PrunedStreams result;
  const auto prune = [&](const std::string& semantic, const char* why) { result.pruned.push_back({semantic, why}); };
  // Sets of joints are numbered without a gap: only the last ones can go.
  std::size_t sets = 0;
  while (vertices.find("WEIGHTS_" + std::to_string(sets)) != nullptr) ++sets;
  while (sets > 1 && are_all(*vertices.find("WEIGHTS_" + std::to_string(sets - 1)), 0)) {
    --sets;
    prune("WEIGHTS_" + std::to_string(sets), "all weights are 0");
    prune("JOINTS_" + std::to_string(sets), "all weights are 0");
  }
  const VertexStream* colours = vertices.find("COLOR_0");
  const bool is_only = vertices.find("COLOR_1") == nullptr && !has_morphed_colours(vertices);
  if (colours != nullptr && is_only && are_all(*colours, 1)) prune("COLOR_0", "all colours are 1");
  auto left = std::make_shared<VertexStreams>(vertices);
  std::erase_if(left->base, [&](const VertexStream& stream) {
    return std::ranges::find(result.pruned, stream.semantic, &PrunedStream::semantic) != result.pruned.end();
  });
  result.vertices = std::move(left);
  return result;
}

}  // namespace foredraw
