#include <foredraw/analysis/vertex_rows.h>

namespace foredraw {

VertexRows::VertexRows(const VertexStreams& vertices) : count_(vertices.count) {
  const std::vector<const VertexStream*> streams = vertices.all();
  for (const VertexStream* stream : streams) row_ += stream->format.bytes;
  bytes_.resize(count_ * row_);
  std::size_t at = 0;
  for (const VertexStream* stream : streams) {
    const std::size_t width = stream->format.bytes;
    const std::byte* from = stream->bytes.view().data();
    for (std::size_t v = 0; v < count_; ++v) std::memcpy(bytes_.data() + v * row_ + at, from + v * width, width);
    at += width;
  }
}

}  // namespace foredraw
