#include "vertex_fetch.h"

#include <foredraw/analysis/vertex_cache.h>
#include <foredraw/base/counted.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

struct VertexFetchOptions {
  bool always = false;
};

class VertexFetchOrderer final : public VertexOrderer {
 public:
  explicit VertexFetchOrderer(VertexFetchOptions options) : options_(options) {}

  VertexOrder order(const VertexUse& use, Run& run) const override {
    VertexOrder order = vertex_fetch(use.index_streams, use.vertices.count);
    if (std::ranges::is_sorted(order)) {
      run.keep("its vertices are in order of first use already");
      return order;
    }
    if (options_.always) return order;
    std::vector<std::uint32_t> destination(order.size());
    for (std::uint32_t v = 0; v < order.size(); ++v) destination[order[v]] = v;
    const std::uint64_t before = bytes_fetched(use, {});
    const std::uint64_t after = bytes_fetched(use, destination);
    if (after >= before) {
      run.keep(
          after == before
              ? fmt::format("its order is as good already: {} bytes are fetched either way", counted(before))
              : fmt::format("its order is better already: {} bytes are fetched now, {} would be in order of first use",
                            counted(before), counted(after)));
    }
    return order;
  }

 private:
  /// With the vertices moved to their destinations (none: as they are), each index stream drawn by itself.
  static std::uint64_t bytes_fetched(const VertexUse& use, std::span<const std::uint32_t> destination) {
    std::uint64_t fetched = 0;
    for (const auto& indices : use.index_streams) {
      std::vector<std::uint32_t> moved(indices.begin(), indices.end());
      for (std::uint32_t& v : moved) v = destination.empty() ? v : destination[v];
      fetched += count_fetches(moved, use.vertices.count, use.vertices.bytes_per_vertex()).fetched;
    }
    return fetched;
  }

  VertexFetchOptions options_;
};

}  // namespace

Plugin vertex_fetch_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "vertex-fetch",
      .summary = "Renumbers vertices by first use, so that memory is read in sequence; put it after all orderers",
      .reference = "common practice; measured as overfetch by vertex-cache",
      .acts_on = {traits::triangles},
      .provides = {traits::fetch_ordered},
      .pays_if = "fewer bytes are fetched than with the current numbering",
  };
  OptionTable<VertexFetchOptions> table;
  table.row(&VertexFetchOptions::always, "always",
            "Renumber also where no fewer bytes are fetched: compressed indices are shorter in order of first use");
  bind_options(plugin, table,
               [](const VertexFetchOptions& options) { return std::make_unique<VertexFetchOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
