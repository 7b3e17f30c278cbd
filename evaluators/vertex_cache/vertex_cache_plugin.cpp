#include "vertex_cache.h"

#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/order_lookup.h>

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

/// The models that the text names. Throws std::invalid_argument where it names none.
std::vector<CacheModel> models_of(const std::string& names) {
  std::vector<CacheModel> models;
  std::istringstream words(names);
  for (std::string name; words >> name;) {
    const auto model = cache_model(name);
    if (!model) {
      throw std::invalid_argument(fmt::format(
          "'{}' is not a cache model; models are fifo-N, lru-N, batches-CACHE-WARP-GROUP, nvidia, amd and intel",
          name));
    }
    models.push_back(*model);
  }
  return models;
}

class VertexCacheEvaluator final : public DrawEvaluator {
 public:
  explicit VertexCacheEvaluator(const VertexCacheOptions& options)
      : options_(options), models_(models_of(options.models)) {}

  void evaluate(const DrawView& draw, Run& run) const override {
    const std::vector<ServedOrder> orders = served_orders(draw.scene, draw.id);
    const std::size_t vertices = draw.vertex_count();
    const auto cache_size = static_cast<std::uint32_t>(options_.cache_size);
    measure(run, "", orders, [&](auto indices) { return count_fifo(indices, vertices, cache_size); });
    for (const CacheModel& model : models_) {
      measure(run, "models." + model.name + ".", orders, [&](auto indices) { return count(indices, vertices, model); });
    }
    const std::size_t vertex_size =
        options_.vertex_size ? static_cast<std::size_t>(*options_.vertex_size) : draw.vertices().bytes_per_vertex();
    double fetched = 0;
    double referenced = 0;  // the same in all orders
    for (const ServedOrder& order : orders) {
      const FetchCount fetch = count_fetches(order.indices(), vertices, vertex_size);
      fetched += order.share * static_cast<double>(fetch.fetched);
      referenced = static_cast<double>(fetch.referenced);
    }
    run.measure("overfetch", fetched, referenced);
  }

 private:
  using Count = std::function<CacheCount(std::span<const std::uint32_t>)>;

  static void measure(const Run& run, const std::string& group, std::span<const ServedOrder> orders,
                      const Count& count) {
    double misses = 0;
    CacheCount any;  // triangles and vertices are the same in all orders
    for (const ServedOrder& order : orders) {
      any = count(order.indices());
      misses += order.share * static_cast<double>(any.misses);
    }
    run.measure(group + "acmr", misses, static_cast<double>(any.triangles));
    run.measure(group + "atvr", misses, static_cast<double>(any.referenced));
  }

  VertexCacheOptions options_;
  std::vector<CacheModel> models_;
};

}  // namespace

Plugin vertex_cache_plugin() {
  OptionTable<VertexCacheOptions> table;
  table.row(&VertexCacheOptions::cache_size, "cache-size",
            "Size of the FIFO vertex cache that acmr and atvr are counted with", {3, 65535, "entries"});
  table.row(&VertexCacheOptions::vertex_size, "vertex-size",
            "Size of a vertex for overfetch; by default that of all attributes of the draw together",
            {1, 1024, "bytes"});
  table.row(
      &VertexCacheOptions::models, "models",
      "Further caches to count with, separated by spaces: fifo-N, lru-N, batches-CACHE-WARP-GROUP, nvidia, amd, intel");

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "vertex-cache",
      .summary = "Counts how often vertices are shaded (ACMR, ATVR) and fetched (overfetch), with models of GPU caches",
      .reference = "Hoppe 1999 (ACMR); Kerbl et al. 2018 (batches); meshoptimizer (overfetch)",
      .acts_on = {traits::triangles},
      .metrics =
          {
              {"acmr", "misses per triangle",
               "Vertices shaded per triangle; large regular meshes come close to 0.5 at best"},
              {"atvr", "misses per vertex", "Vertices shaded per vertex that is drawn; 1 is the minimum"},
              {"overfetch", "bytes per byte",
               "Bytes read from the vertex buffer per byte of the vertices drawn; 1 is the minimum, and small draws "
               "stay above it because whole cache lines are read"},
          },
  };
  bind_options(plugin, std::move(table),
               [](const VertexCacheOptions& options) { return std::make_unique<VertexCacheEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw
