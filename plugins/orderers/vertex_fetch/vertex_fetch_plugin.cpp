#include "vertex_fetch.h"

#include <foredraw/technique/plugin.h>

namespace foredraw {

namespace {

class VertexFetch final : public VertexOrderer {
 public:
  VertexOrder order(const VertexUse& use, Run&) override {
    return vertex_fetch(use.index_streams, use.vertices.count);
  }
};

struct VertexFetchOptions {};

}  // namespace

Plugin vertex_fetch_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "vertex-fetch",
      .summary = "Numbers vertices by first use over every draw that shares them, so that they are fetched in sequence",
      .reference = "common practice; measured as overfetch by vertex-cache",
      .acts_on = {traits::triangles},
      .provides = {traits::fetch_ordered},
  };
  bind_options(plugin, OptionTable<VertexFetchOptions>(),
               [](const VertexFetchOptions&) { return std::make_unique<VertexFetch>(); });
  return plugin;
}

}  // namespace foredraw
