#pragma once
// How EXT_meshopt_compression and KHR_meshopt_compression compress the bytes of a buffer view. Knows nothing of
// documents. Source: the extensions' appendices A (bitstreams) and B (filters). Private to io.

#include <foredraw/io/meshopt/vertex_codec.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace foredraw::gltf {

inline constexpr const char* ext_meshopt = "EXT_meshopt_compression";
inline constexpr const char* khr_meshopt = "KHR_meshopt_compression";
inline constexpr const char* meshopt_extensions[] = {ext_meshopt, khr_meshopt};

/// `count` elements of `stride` bytes each, and how they were compressed.
struct Coding {
  enum class Mode { unknown, attributes, triangles, indices };
  enum class Filter { unknown, none, octahedral, quaternion, exponential, color };

  Mode mode = Mode::unknown;
  Filter filter = Filter::none;
  std::size_t count = 0;
  std::size_t stride = 0;
  meshopt::VertexVersion version = meshopt::VertexVersion::v0;  ///< of mode attributes

  std::size_t bytes() const { return count * stride; }
};

Coding::Mode mode_of(std::string_view name);
Coding::Filter filter_of(std::string_view name);
const char* name_of(Coding::Mode mode);
const char* name_of(Coding::Filter filter);

/// "vertex codec version 2" where the stream needs a decoder that there is not; empty where there is one. A stream that
/// does not even name its codec is no such case: it is malformed.
std::string unknown_codec(Coding::Mode mode, std::span<const std::byte> stream);

/// The least number of bytes that a stream of this coding can have, so that a count can be held against the bytes there
/// are before memory is asked for. Follows from the bitstreams: version 0 of the vertex codec keeps 2 bits for each 16
/// equal bytes, version 1 a byte for each block's 4 bytes of an element, the index codecs a byte for each triangle or
/// index.
std::size_t least_stream_bytes(const Coding& coding);

/// The elements; nullopt where the stream is malformed. Mode and filter must be known, count and stride as the
/// extension wants them, and the stream of least_stream_bytes at least.
std::optional<std::vector<std::byte>> decompressed(const Coding& coding, std::span<const std::byte> stream);

/// As above, but before the filter.
std::optional<std::vector<std::byte>> unfiltered(const Coding& coding, std::span<const std::byte> stream);

/// Turns elements that came out of a codec into what they stand for, in place: each element alone. Own code, for the
/// library's takes an approximate square root whose bits depend on the processor.
void apply_filter(const Coding& coding, std::span<std::byte> elements);

/// What a filter makes into just these elements, bit for bit: the inverse of apply_filter(). Nullopt where it makes
/// some of them of nothing, and for filters COLOR and unknown ones.
std::optional<std::vector<std::byte>> before_filter(Coding::Filter filter, std::size_t stride,
                                                    std::span<const std::byte> elements);

/// What before_filter() made for filter EXPONENTIAL, of which 24 bits of each number count: those of a component that
/// is shorter so have 8 zeros below them. A sign that fills the third byte costs where values change it; with zeros
/// below, the number's own two bytes are on top, and its sign costs nothing.
std::vector<std::byte> raised_where_shorter(std::span<const std::byte> rows, std::size_t stride,
                                            meshopt::VertexVersion version);

struct Stream {
  Coding coding;
  std::vector<std::byte> bytes;
};

/// Whether two lists of elements say the same: byte for byte, but that mode TRIANGLES does not keep at which of its
/// corners a triangle starts.
bool same_elements(const Coding& coding, std::span<const std::byte> a, std::span<const std::byte> b);

/// Elements of `stride` bytes compressed in the mode of `like`, which they replace; nullopt where the mode can not hold
/// them. The stream gives the same elements again. In place of TRIANGLES it has INDICES where that is as short. Its
/// filter is the one that makes it shortest of those that lose nothing: that of `like`, where every element is one that
/// `like_stream` gives too, as after a reorder; those that have an inverse here; none.
std::optional<Stream> compressed(std::span<const std::byte> elements, std::size_t stride, const Coding& like,
                                 std::span<const std::byte> like_stream);

}  // namespace foredraw::gltf
