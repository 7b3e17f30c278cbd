#pragma once
#include <cstddef>
#include <span>

namespace foredraw {

/// Memory that other processes see, too, who are handed its descriptor.
class SharedBlock {
 public:
  /// Zeros, of which pages take memory once they are touched. Others can not change its size, and where they
  /// `only_read` it, they can not write it, whatever they try. Throws std::system_error.
  SharedBlock(std::size_t bytes, bool only_read);
  /// One that was handed over. Throws std::system_error where there is none.
  static SharedBlock handed(int descriptor, bool writable);

  SharedBlock(SharedBlock&& other) noexcept;
  SharedBlock& operator=(SharedBlock&&) = delete;
  ~SharedBlock();

  std::byte* data() const { return bytes_.data(); }
  std::size_t size() const { return bytes_.size(); }
  int descriptor() const { return descriptor_; }

 private:
  SharedBlock(int descriptor, std::span<std::byte> bytes) : descriptor_(descriptor), bytes_(bytes) {}

  int descriptor_;
  std::span<std::byte> bytes_;
};

}  // namespace foredraw
