#include <foredraw/base/content_hash.h>

#include <xxhash.h>

#include <cstdio>

namespace foredraw {

Stamp content_hash(std::span<const std::byte> bytes, std::uint64_t seed) {
  const XXH128_hash_t hash = XXH3_128bits_withSeed(bytes.data(), bytes.size(), seed);
  return {hash.high64, hash.low64};
}

Stamp combine(std::span<const Stamp> stamps) { return content_hash(stamps); }

std::string to_text(const Stamp& stamp) {
  char text[33];
  std::snprintf(text, sizeof text, "%016llx%016llx", static_cast<unsigned long long>(stamp.high),
                static_cast<unsigned long long>(stamp.low));
  return text;
}

}  // namespace foredraw
