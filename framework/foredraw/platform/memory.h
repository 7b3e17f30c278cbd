#pragma once
#include <cstdint>

namespace foredraw {

/// The most memory that this process has held, in bytes.
std::uint64_t peak_memory();

}  // namespace foredraw
