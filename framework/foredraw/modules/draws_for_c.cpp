#include <foredraw/modules/draws_for_c.h>

namespace foredraw {

namespace {

std::uint32_t number_of(Component component) {
  switch (component) {
    case Component::int8: return FOREDRAW_INT8;
    case Component::uint8: return FOREDRAW_UINT8;
    case Component::int16: return FOREDRAW_INT16;
    case Component::uint16: return FOREDRAW_UINT16;
    case Component::uint32: return FOREDRAW_UINT32;
    case Component::float32: return FOREDRAW_FLOAT32;
  }
  return 0;
}

}  // namespace

std::vector<foredraw_stream> streams_for_c(const VertexStreams& vertices) {
  std::vector<foredraw_stream> streams;
  for (const VertexStream& stream : vertices.base) {
    if (stream.semantic == "POSITION") continue;
    const Format& format = stream.format;
    streams.push_back({stream.semantic.c_str(), stream.bytes.view().data(), format.bytes, number_of(format.component),
                       format.components, format.normalized});
  }
  return streams;
}

foredraw_draw draw_for_c(const VertexStreams& vertices, std::span<const std::uint32_t> indices, const float* positions,
                         const std::vector<foredraw_stream>& streams, const Clusters* clusters) {
  return {.size = sizeof(foredraw_draw),
          .vertex_count = vertices.count,
          .triangle_count = indices.size() / 3,
          .name = "",
          .indices = indices.data(),
          .positions = positions,
          .stream_count = static_cast<std::uint32_t>(streams.size()),
          .streams = streams.data(),
          .cluster_count = clusters == nullptr ? 0 : static_cast<std::uint32_t>(clusters->count()),
          .cluster_offsets = clusters == nullptr ? nullptr : clusters->offsets.data()};
}

}  // namespace foredraw
