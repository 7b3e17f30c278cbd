#pragma once
// A stream that was read to its end, and whether it shows what a mesh is.

#include "vertex_numbers.h"

#include <foredraw/runtime/progressive_stream.h>

#include <optional>
#include <span>
#include <string>

namespace foredraw {

/// A reader with memory of its own.
class StreamMesh {
 public:
  /// Nothing where the bytes are no stream, or only a part of one.
  static std::optional<StreamMesh> read(std::span<const std::byte> bytes);

  const foredraw_split_mesh& mesh() const { return stream_.coding.mesh; }
  const foredraw_stream_header& header() const { return stream_.header; }
  NumberGrid grid() const;
  const std::vector<std::uint32_t>& chunk_end() const { return chunk_end_; }  ///< [chunk] bytes up to its end

 private:
  foredraw_stream stream_ = {};
  std::vector<std::uint32_t> memory_, chunk_end_;
};

/// As the rest of a sentence; empty: draw by draw the triangles are the same, begun at any corner, with the same
/// numbers. Triangles without area count for nothing.
std::string difference(const StreamMesh& stream, const JoinedMesh& mesh);

}  // namespace foredraw
