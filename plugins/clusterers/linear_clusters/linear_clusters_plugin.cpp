#include "linear_clusters.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

class LinearClustersClusterer final : public Clusterer {
 public:
  explicit LinearClustersClusterer(LinearClustersOptions options) : options_(options) {}

  Clusters cluster(const DrawView& draw, Run& run) const override {
    warn_where_out_of_reach(draw, run);
    const int made_for = draw.stream().cache_size;
    return linear_clusters(draw.indices(), draw.vertex_count(), made_for > 0 ? made_for : 16, options_);
  }

 private:
  /// Each vertex misses once at least, so no order gets below vertices / triangles.
  void warn_where_out_of_reach(const DrawView& draw, Run& run) const {
    if (!options_.lambda || draw.triangle_count() == 0) return;
    std::vector<bool> used(draw.vertex_count(), false);
    for (std::uint32_t v : draw.indices()) used[v] = true;
    const auto vertices = static_cast<double>(std::count(used.begin(), used.end(), true));
    const double floor = vertices / static_cast<double>(draw.triangle_count());
    if (*options_.lambda >= floor) return;
    run.note(
        "lambda-out-of-reach",
        fmt::format(
            "lambda = {} cannot be reached: {:.0f} vertices for {} triangles make at least {:.3f} misses per triangle "
            "in any order, so clusters end only at hard boundaries and by chance; raise lambda or use growth",
            *options_.lambda, vertices, draw.triangle_count(), floor));
  }

  LinearClustersOptions options_;
};

}  // namespace

Plugin linear_clusters_plugin() {
  Plugin plugin;
  plugin.kind = Kind::clusterer;
  plugin.card = {
      .name = "linear-clusters",
      .summary =
          "Cuts a cache-friendly triangle order into clusters for a later stage to sort; moves no triangle itself",
      .reference = "Sander, Nehab, Barczak 2007, linear clustering; Han, Sander 2016, section 3.1",
      .acts_on = {traits::triangles},
      .wants = {traits::cache_ordered},
      .provides = {traits::clustered},
  };
  OptionTable<LinearClustersOptions> table;
  table.row(
      &LinearClustersOptions::lambda, "lambda",
      "Ends a cluster once its misses per triangle fall to this; lower gives fewer, larger clusters. Overrides growth",
      {0.5, 3, "misses per triangle"});
  table.row(&LinearClustersOptions::growth, "growth",
            "Ends a cluster once its misses per triangle fall to this multiple of those of the uncut order around it; "
            "higher gives more clusters, less overdraw and more shaded vertices",
            {1, 6, "times"});
  bind_options(plugin, table,
               [](const LinearClustersOptions& options) { return std::make_unique<LinearClustersClusterer>(options); });
  return plugin;
}

}  // namespace foredraw
