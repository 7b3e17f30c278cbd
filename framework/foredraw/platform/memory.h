#pragma once
#include <cstdint>
#include <optional>

namespace foredraw {

/// The most memory that this process has held, in bytes.
std::uint64_t peak_memory();

/// How much more memory this process comes to hold from here on, in bytes. The heap's free pages are given back to the
/// system first, so that what is allocated anew counts. One watch at a time: it begins peak_memory() anew.
class MemoryWatch {
 public:
  MemoryWatch();
  /// Nothing where this system does not tell.
  std::optional<std::uint64_t> growth() const;

 private:
  std::optional<std::uint64_t> at_first_;
};

/// Pieces of up to 8 MiB that are freed stay with this process, up to 256 MiB, for those who ask next: pictures come
/// and go by the thousand, and a system that hands out fresh pages for each takes longer than it takes to draw them.
void keep_freed_memory();

/// From here on this process may hold that many bytes of data of its own (heap, stacks of threads and private mappings,
/// but neither code nor mapped files); whoever allocates more is thrown std::bad_alloc. False where the system refuses.
bool limit_memory(std::uint64_t bytes);

}  // namespace foredraw
