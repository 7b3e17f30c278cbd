#pragma once
#include <cstdint>

namespace foredraw {

/// The most memory that this process has held, in bytes.
std::uint64_t peak_memory();

/// From here on this process may hold that many bytes of data of its own (heap, stacks of threads and private mappings, but
/// neither code nor mapped files); whoever allocates more is thrown std::bad_alloc. False where the system refuses.
bool limit_memory(std::uint64_t bytes);

}  // namespace foredraw
