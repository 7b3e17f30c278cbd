#pragma once
// The stamp of content that comes in pieces.

#include <foredraw/base/content_hash.h>

#include <memory>

namespace foredraw {

/// The same stamp as content_hash() has of all pieces in one.
class StreamedHash {
 public:
  StreamedHash();
  void add(std::span<const std::byte> piece);
  Stamp stamp() const;

 private:
  struct Free {
    void operator()(void* state) const;
  };
  std::unique_ptr<void, Free> state_;
};

}  // namespace foredraw
