#include "shared_vertices.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>

namespace foredraw::processors::merge_instances {

SharedVertices shared_vertices(const Scene& scene, std::span<const DrawId> draws) {
  SharedVertices result;
  std::map<const VertexStreams*, std::uint32_t> begins;
  std::vector<const VertexStreams*> sources;
  std::uint64_t count = 0;
  for (const DrawId id : draws) {
    const VertexStreams* own = scene.draws[id].levels[0].vertices.get();
    const auto [it, is_new] = begins.try_emplace(own, static_cast<std::uint32_t>(count));
    if (is_new) {
      sources.push_back(own);
      count += own->count;
      if (count > std::numeric_limits<std::uint32_t>::max()) {
        throw std::length_error(scene.draws[id].name + ": with it there are " + std::to_string(count) +
                                " merged vertices, more than 32-bit indices can address; merge fewer meshes together");
      }
    }
    result.first.push_back(it->second);
  }
  auto vertices = std::make_shared<VertexStreams>();
  vertices->count = static_cast<std::uint32_t>(count);
  for (std::size_t s = 0; !sources.empty() && s < sources[0]->base.size(); ++s) {
    std::vector<std::byte> bytes;
    for (const VertexStreams* source : sources) {
      const std::span<const std::byte> own = source->base[s].bytes.view();
      bytes.insert(bytes.end(), own.begin(), own.end());
    }
    vertices->base.push_back(
        {sources[0]->base[s].semantic, sources[0]->base[s].format, Shared<std::byte>(std::move(bytes))});
  }
  result.vertices = std::move(vertices);
  return result;
}

}  // namespace foredraw::processors::merge_instances
