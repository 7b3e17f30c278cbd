#pragma once
#include <foredraw/scene/vertex_streams.h>

namespace foredraw {

/// All bytes of each vertex, over every base stream and morph target, in one row: what has to be equal for two vertices
/// to be the same.
class VertexRows {
 public:
  explicit VertexRows(const VertexStreams& vertices);

  std::size_t size() const { return count_; }
  std::span<const std::byte> operator[](std::size_t vertex) const {
    return std::span(bytes_).subspan(vertex * row_, row_);
  }

 private:
  std::size_t count_;
  std::size_t row_ = 0;
  std::vector<std::byte> bytes_;
};

}  // namespace foredraw
