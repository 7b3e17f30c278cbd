#pragma once
// The vertex codec of EXT_meshopt_compression and KHR_meshopt_compression, versions 0 and 1: elements of equal size as
// bytes that are short where elements that follow each other are alike. Source: appendix A of the extensions, mode 0.
// Knows nothing of files.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace foredraw::meshopt {

enum class VertexVersion {
  v0,  ///< of both extensions
  v1,  ///< of KHR_meshopt_compression: shorter
};

/// What a stream says of itself in its first byte; nullopt where it is no stream of this codec, or of a later version.
std::optional<VertexVersion> vertex_version(std::span<const std::byte> stream);

/// The least number of bytes that a stream of `count` elements can have: what the blocks' headers and the tail take.
/// `stride` as below.
std::size_t least_vertex_bytes(std::size_t count, std::size_t stride, VertexVersion version);

/// Fills `elements`, of `stride` bytes each (a multiple of 4, 4 to 256), from a stream of just so many. False where the
/// stream is malformed; then the elements hold anything. Reads and writes nothing beyond the spans, whatever they hold.
bool decode_vertices(std::span<const std::byte> stream, std::size_t stride, std::span<std::byte> elements);

/// The stream of these elements. Of all streams of this version that stand for them it is one of the shortest: no other
/// choice of modes takes fewer bytes. The same at every width of vector registers.
std::vector<std::byte> encode_vertices(std::span<const std::byte> elements, std::size_t stride, VertexVersion version);

}  // namespace foredraw::meshopt
