#pragma once
#include <foredraw/base/content_hash.h>

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// As RFC 4648 has it, with padding.
std::string base64(std::span<const std::byte> bytes);

/// Numbers for the script, one after the other. What is there already is not stored again: poses that look alike and
/// orders that several pipelines find cost nothing.
class PageBuffer {
 public:
  /// The offset in bytes, a multiple of 4.
  template <class T>
  std::size_t add(std::span<const T> values) {
    static_assert(sizeof(T) == 4, "all is float32 or uint32");
    return add_bytes(std::as_bytes(values));
  }

  std::string base64() const { return foredraw::base64(bytes_); }

 private:
  std::size_t add_bytes(std::span<const std::byte> bytes);

  std::vector<std::byte> bytes_;
  std::map<Stamp, std::size_t> offsets_;
};

}  // namespace foredraw
