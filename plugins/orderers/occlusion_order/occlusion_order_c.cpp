#include "k_orders.h"

#include <foredraw/base/this_thread.h>
#include <foredraw/c/checked_input.h>
#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/overdraw/overdraw_bound.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

using namespace foredraw;

namespace {

constexpr std::array qualities = {OcclusionQuality::balanced, OcclusionQuality::fast, OcclusionQuality::balanced,
                                  OcclusionQuality::high};  // by FOREDRAW_OCCLUSION_FAST and so on; 0 is the default

/// Those of @default.
Views views_of_default() {
  Views views{{}, 128};
  for (const glm::dvec3& direction : fibonacci_directions(80)) views.views.push_back({direction});
  return views;
}

/// The draw from all views, as pieces that are moved as one.
std::optional<SubjectLayers> seen(const RasterPart& part, const Views& views, const KOrdersOptions& options,
                                  const Executor& executor) {
  const auto triangles = fragment_layers({&part, 1}, views, executor);
  if (!triangles) return std::nullopt;
  const Clusters atoms =
      cut_atoms(part.indices, part.positions.size(), options.cache_size, atom_size(options, part.triangle_count()));
  ClusterLayers layers = cluster_layers(*triangles, atoms, executor);
  SubjectLayers subject;
  for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) subject.owners.push_back({0, 0, atom});
  subject.draws.push_back({part.indices, part.positions.size(), atoms});
  subject.layers.owners = layers.owners;
  subject.layers.views = std::move(layers.views);
  for (const View& view : views.views) {
    subject.directions.push_back(view.direction);
    subject.weights.push_back(view.weight);
    subject.poses.push_back(0);
  }
  return subject;
}

struct Ordered {
  std::vector<std::uint32_t> order;  ///< of the triangles; empty: nothing is overdrawn
  double before = 0, after = 0;      ///< fragments shaded
};

std::optional<Ordered> ordered(const RasterPart& part, const Views& views, const KOrdersOptions& options,
                               const Executor& executor) {
  const auto subject = seen(part, views, options, executor);
  if (!subject) return std::nullopt;
  const ViewTally before = tally_of(*subject, counts_of(*subject, as_it_came(*subject)));
  if (before.shaded <= before.visible) return Ordered{{}, before.shaded, before.shaded};
  const KOrders found = k_orders(*subject, options, executor);
  return Ordered{in_sequence(subject->draws[0].atoms, found.orders[0][0]), before.shaded,
                 tally_of(*subject, found.counts).shaded};
}

}  // namespace

int foredraw_occlusion_order(uint32_t* order, const foredraw_triangles* triangles, const foredraw_positions* positions,
                             int quality, double acmr_budget, uint32_t cache_size, int shows_back_faces) {
  return c::with_triangles(triangles, order, [&](const c::CheckedTriangles& checked) -> int {
    if (const int status = c::positions_status(positions, checked.vertex_count())) return status;
    KOrdersOptions options;
    int cache = 16;
    if (const int status = c::take_option(cache_size, 3, 65535, cache)) return status;
    options.cache_size = static_cast<std::uint32_t>(cache);
    if (acmr_budget != 0) options.acmr_budget = acmr_budget;
    const bool is_good = static_cast<unsigned>(quality) < qualities.size() && options.acmr_budget >= 1 &&
                         std::isfinite(options.acmr_budget) && (shows_back_faces == 0 || shows_back_faces == 1);
    if (!is_good) return FOREDRAW_OPTION_RANGE;
    options.quality = qualities[static_cast<unsigned>(quality)];
    if (checked.indices().size() >= std::size_t{1} << 31) return FOREDRAW_TOO_LARGE;
    std::vector<std::uint32_t> best(checked.triangle_count());
    std::iota(best.begin(), best.end(), 0u);
    if (!best.empty()) {
      const auto places = c::elements_at<glm::vec3>(positions->first, positions->stride, checked.vertex_count());
      const RasterPart part{places, checked.indices(), shows_back_faces == 0};
      const Executor executor = on_this_thread();
      if (!overdraw_bound({&part, 1}, least_overdraw)) {
        const Views views = views_of_default();
        auto found = ordered(part, views, options, executor);
        if (!found) return FOREDRAW_TOO_LARGE;
        if (options.quality == OcclusionQuality::high) {  // finer pieces mostly find the better order, but not always
          options.quality = OcclusionQuality::balanced;
          auto plainer = ordered(part, views, options, executor);
          if (plainer && plainer->after < found->after) found = std::move(plainer);
        }
        if (found->after < found->before) best = std::move(found->order);
      }
    }
    std::ranges::copy(best, order);
    return FOREDRAW_DONE;
  });
}
