#pragma once
// The product that progressive-stream makes: meshes that can be sent piece by piece.

#include <foredraw/scene/product_row.h>

namespace foredraw {

/// Of draws that lie in one space: what runtime/progressive_stream.h reads.
struct StreamedDraws {
  std::vector<DrawId> draws;
  Shared<std::byte> bytes;
  friend bool operator==(const StreamedDraws&, const StreamedDraws&) = default;
};

struct ProgressiveStreams {
  static constexpr std::string_view product = "progressive-streams";
  std::vector<StreamedDraws> meshes;  ///< a draw is in one of them at most
  friend bool operator==(const ProgressiveStreams&, const ProgressiveStreams&) = default;
};

/// How ProgressiveStreams are read, written, proved and told. Proved is that a stream, read to its end, has the
/// triangles that the draws have, with the same numbers for places and attributes.
std::shared_ptr<const ProductRow> stream_product();

}  // namespace foredraw
