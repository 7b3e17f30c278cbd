#pragma once
// An open file, closed with what holds it. For this room's own files.

#include <cstddef>
#include <span>

namespace foredraw {

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor();
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int get() const { return number_; }

 private:
  int number_;
};

/// False, with errno, where not all could be written.
bool write_all(int descriptor, std::span<const std::byte> bytes);

}  // namespace foredraw
