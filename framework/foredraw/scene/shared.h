#pragma once
// Immutable, reference-counted streams.

#include <foredraw/base/content_hash.h>

#include <cstring>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace foredraw {

/// An immutable array shared by everybody who holds it. A copy is a handle. The content stamp is computed on the first
/// ask and kept, so equal content has equal stamps and nothing needs a global counter.
template <class T>
class Shared {
 public:
  Shared() = default;
  explicit Shared(std::vector<T> values) : block_(std::make_shared<const Block>(std::move(values))) {}

  std::span<const T> view() const { return block_ ? std::span<const T>(block_->values) : std::span<const T>(); }
  std::size_t size() const { return block_ ? block_->values.size() : 0; }
  bool empty() const { return size() == 0; }

  Stamp stamp() const {
    if (!block_) return content_hash(std::span<const T>());
    std::call_once(block_->once, [this] { block_->stamp = content_hash(view()); });
    return block_->stamp;
  }

  /// The same block of memory; cheaper than comparing stamps, and false for equal copies.
  bool is(const Shared& other) const { return block_ == other.block_; }
  friend bool operator==(const Shared& a, const Shared& b) { return a.is(b) || a.stamp() == b.stamp(); }

 private:
  struct Block {
    explicit Block(std::vector<T> v) : values(std::move(v)) {}
    std::vector<T> values;
    mutable std::once_flag once;
    mutable Stamp stamp;
  };
  std::shared_ptr<const Block> block_;
};

}  // namespace foredraw
