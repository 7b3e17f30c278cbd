#include "contestants.h"

#include "bench_meshes.h"

#include <plugins/orderers/forsyth/forsyth.h>
#include <plugins/orderers/tipsify/tipsify.h>

#include <meshoptimizer.h>

#include <type_traits>

namespace foredraw::bench {

namespace {

template <class Options>
Contestant ours(std::string order, std::string setting,
                std::vector<std::uint32_t> (*technique)(std::span<const std::uint32_t>, std::size_t, const Options&),
                std::type_identity_t<Options> options) {
  return {std::move(order), std::move(setting), [=](std::span<const std::uint32_t> indices, std::size_t vertices) {
            return reordered(indices, technique(indices, vertices, options));
          }};
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
      ours("tipsify", "cache-size=14", tipsify, {.cache_size = 14}),
      ours("tipsify", "cache-size=15", tipsify, {.cache_size = 15}),
      ours("tipsify", "cache-size=16", tipsify, {.cache_size = 16}),
      ours("tipsify", "cache-size=17", tipsify, {.cache_size = 17}),
      ours("tipsify", "cache-size=18", tipsify, {.cache_size = 18}),
      ours("tipsify", "cache-size=19", tipsify, {.cache_size = 19}),
      ours("tipsify", "cache-size=20", tipsify, {.cache_size = 20}),
      ours("forsyth", "cache-size=16", forsyth, {.cache_size = 16}),
      ours("forsyth", "cache-size=24", forsyth, {.cache_size = 24}),
      ours("forsyth", "cache-size=32", forsyth, {.cache_size = 32}),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=14", fifo, 14u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=15", fifo, 15u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=16", fifo, 16u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=17", fifo, 17u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=18", fifo, 18u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=19", fifo, 19u),
      peer("meshopt_optimizeVertexCacheFifo", "cache-size=20", fifo, 20u),
      peer("meshopt_optimizeVertexCache", "", cache),
      peer("meshopt_optimizeVertexCacheStrip", "", strip),
  };
}

}  // namespace foredraw::bench
