#pragma once
// Vertices numbered by first use, so that they are fetched from memory in sequence.

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// The order of the vertices ([new] = old) by first use over all index streams in turn. Vertices that none uses come
/// last, in their old sequence. Every index must be below `vertex_count`. O(indices + vertices).
std::vector<std::uint32_t> vertex_fetch(std::span<const std::span<const std::uint32_t>> index_streams,
                                        std::size_t vertex_count);

struct Plugin;
Plugin vertex_fetch_plugin();

}  // namespace foredraw
