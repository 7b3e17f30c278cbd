#pragma once
// Sizes of memory and of files, as people write them.

#include <cstdint>
#include <optional>
#include <string_view>

namespace foredraw::cli {

/// "500M", "2G" or a number of bytes; K, M, G and T are powers of 1024. Nothing where it is no size, none, or more than
/// 64 bits hold.
std::optional<std::uint64_t> byte_size_in(std::string_view text);

}  // namespace foredraw::cli
