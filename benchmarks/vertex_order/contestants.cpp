#include "contestants.h"

#include "bench_meshes.h"

#include <plugins/orderers/forsyth/forsyth.h>
#include <plugins/orderers/lookahead/lookahead.h>
#include <plugins/orderers/tipsify/tipsify.h>

#include <meshoptimizer.h>

#include <type_traits>

namespace foredraw::bench {

namespace {

template <class Options>
Contestant ours(std::string order, std::string setting,
                Indices (*technique)(std::span<const std::uint32_t>, std::size_t, const Options&),
                std::type_identity_t<Options> options) {
  return {std::move(order), std::move(setting), [=](std::span<const std::uint32_t> indices, std::size_t vertices) {
            return technique(indices, vertices, options);
          }};
}

Indices lookahead_indices(std::span<const std::uint32_t> indices, std::size_t vertices,
                          const LookaheadOptions& options) {
  return reordered(indices, lookahead(indices, vertices, options));
}

Indices forsyth_indices(std::span<const std::uint32_t> indices, std::size_t vertices, const ForsythOptions& options) {
  return reordered(indices, forsyth(indices, vertices, options));
}

/// Further arguments are handed on to the peer's function.
template <class Function, class... Settings>
Contestant peer(std::string order, std::string setting, Function function, Settings... settings) {
  return {std::move(order), std::move(setting), [=](std::span<const std::uint32_t> indices, std::size_t vertices) {
            Indices result(indices.size());
            function(result.data(), indices.data(), indices.size(), vertices, settings...);
            return result;
          }};
}

}  // namespace

std::vector<Contestant> contestants() {
  // The peer's functions have overloads for other types of indices.
  using Peer = void (*)(unsigned*, const unsigned*, std::size_t, std::size_t);
  using FifoPeer = void (*)(unsigned*, const unsigned*, std::size_t, std::size_t, unsigned);
  const Peer cache = meshopt_optimizeVertexCache;
  const Peer strip = meshopt_optimizeVertexCacheStrip;
  const FifoPeer fifo = meshopt_optimizeVertexCacheFifo;

  return {
      ours("tipsify", "cache-size=14", tipsify_indices, {.cache_size = 14}),
      ours("tipsify", "cache-size=16", tipsify_indices, {.cache_size = 16}),
      ours("tipsify", "cache-size=16, built-for=18", tipsify_indices, {.cache_size = 16, .built_for = 18}),
      ours("tipsify", "cache-size=32", tipsify_indices, {.cache_size = 32}),
      ours("lookahead", "quality=fast", lookahead_indices, {.quality = LookaheadQuality::fast}),
      ours("lookahead", "quality=balanced", lookahead_indices, {}),
      ours("lookahead", "quality=high", lookahead_indices, {.quality = LookaheadQuality::high}),
      ours("lookahead", "target=fifo", lookahead_indices, {.target = LookaheadTarget::fifo}),
      ours("lookahead", "target=fifo, quality=high", lookahead_indices,
           {.quality = LookaheadQuality::high, .target = LookaheadTarget::fifo}),
      ours("lookahead", "target=fifo, cache-size=32", lookahead_indices,
           {.target = LookaheadTarget::fifo, .cache_size = 32}),
      ours("lookahead", "target=nvidia", lookahead_indices, {.target = LookaheadTarget::nvidia}),
      ours("lookahead", "target=amd", lookahead_indices, {.target = LookaheadTarget::amd}),
      ours("lookahead", "target=intel", lookahead_indices, {.target = LookaheadTarget::intel}),
      ours("forsyth", "cache-size=32", forsyth_indices, {.cache_size = 32}),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=14", fifo, 14u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=16", fifo, 16u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=18", fifo, 18u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=32", fifo, 32u),
      peer("meshopt_optimizeVertexCache", "", cache),
      peer("meshopt_optimizeVertexCacheStrip", "", strip),
  };
}

}  // namespace foredraw::bench
