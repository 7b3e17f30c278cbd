#pragma once
// Sizes of memory and of files as arguments have them.

#include <cstdint>
#include <optional>
#include <string_view>

namespace foredraw::cli {

/// "500M", "2G" or a number of bytes; K, M, G and T are powers of 1024. Nothing if it is no size, 0, or more than
/// 64 bits hold.
std::optional<std::uint64_t> byte_size_in(std::string_view text);

}  // namespace foredraw::cli
