#include <foredraw/base/streamed_hash.h>

#include <xxhash.h>

#include <new>

namespace foredraw {

namespace {

XXH3_state_t* state_in(void* state) { return static_cast<XXH3_state_t*>(state); }

}  // namespace

void StreamedHash::Free::operator()(void* state) const { XXH3_freeState(state_in(state)); }

StreamedHash::StreamedHash() : state_(XXH3_createState()) {
  if (!state_) throw std::bad_alloc();
  XXH3_128bits_reset(state_in(state_.get()));
}

void StreamedHash::add(std::span<const std::byte> piece) {
  XXH3_128bits_update(state_in(state_.get()), piece.data(), piece.size());
}

Stamp StreamedHash::stamp() const {
  const XXH128_hash_t hash = XXH3_128bits_digest(state_in(state_.get()));
  return {hash.high64, hash.low64};
}

}  // namespace foredraw
