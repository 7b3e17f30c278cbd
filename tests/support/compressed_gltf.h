#pragma once
// Files with EXT_meshopt_compression or KHR_meshopt_compression, made from plain ones by libmeshoptimizer's encoders.

#include "support/gltf_builder.h"

#include <map>

namespace foredraw::testing {

struct CompressionChoice {
  enum class Plain {
    none,      ///< a fallback buffer without bytes
    data_uri,  ///< a fallback buffer that holds the plain bytes
    beside,    ///< plain bytes and streams in one buffer
  };

  std::string extension = "EXT_meshopt_compression";
  Plain plain = Plain::none;
  bool triangles = true;                       ///< for indices: mode TRIANGLES, else INDICES
  std::map<std::size_t, std::string> filters;  ///< by buffer view. The plain bytes become what the filter gives
};

/// Every view that accessors use is compressed, all in one buffer 0; images stay plain. Views whose elements are no
/// multiple of 4 bytes long, and no indices, stay plain too.
GltfBuilder compressed(const GltfBuilder& plain, const CompressionChoice& choice = {});

/// The same for the bytes of a .glb with one buffer.
GltfBuilder builder_of(std::span<const std::byte> glb);

}  // namespace foredraw::testing
