#include <foredraw/measuring/overdraw_details.h>

#include <foredraw/overdraw/overdraw_bound.h>
#include <foredraw/overdraw/shading_counts.h>
#include <foredraw/viewing/drawn_orders.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

namespace foredraw {

namespace {

constexpr std::size_t most_times = 8;  ///< shaded that often or more

/// [draw][triangle] fragments, as heavy as their poses. Whole weights sum exactly.
using Hidden = std::vector<std::vector<double>>;

double sum_of(std::span<const double> counts) { return std::accumulate(counts.begin(), counts.end(), 0.0); }

/// Shares out what a subject's triangles hide to the draws that they are of.
void add_hidden(Hidden& hidden, const Subject& subject, std::span<const RasterPart> drawn,
                std::span<const std::uint32_t> sequence, std::span<const std::uint64_t> of_triangles, double weight) {
  for (std::size_t rank = 0; rank < drawn.size(); ++rank) {
    const std::size_t triangles = drawn[rank].triangle_count();
    std::vector<double>& of_draw = hidden[subject.parts[sequence[rank]].draw];
    of_draw.resize(std::max(of_draw.size(), triangles));
    for (std::size_t t = 0; t < triangles; ++t) of_draw[t] += weight * static_cast<double>(of_triangles[t]);
    of_triangles = of_triangles.subspan(triangles);
  }
}

/// "half of it is shaded by 3 of 150 clusters: 17 (31 %), 4 (12 %), 20 (9 %)"
std::string worst_clusters(const Clusters& clusters, std::span<const double> hidden) {
  const double all = sum_of(hidden);
  std::vector<double> of_clusters(clusters.count());
  for (std::size_t c = 0; c < of_clusters.size(); ++c) {
    of_clusters[c] = sum_of(hidden.subspan(clusters.offsets[c], clusters.offsets[c + 1] - clusters.offsets[c]));
  }
  std::vector<std::size_t> ranked(of_clusters.size());
  std::iota(ranked.begin(), ranked.end(), std::size_t{0});
  std::ranges::stable_sort(ranked, std::greater(), [&](std::size_t c) { return of_clusters[c]; });
  std::size_t count = 0;
  for (double sum = 0; 2 * sum < all; ++count) sum += of_clusters[ranked[count]];

  constexpr std::size_t most_named = 5;
  std::vector<std::string> named;
  for (const std::size_t c : std::span(ranked).first(std::min(count, most_named))) {
    named.push_back(fmt::format("{} ({:.0f} %)", c, 100 * of_clusters[c] / all));
  }
  return fmt::format("{} of {} clusters shade half of it: {}{}", count, ranked.size(), fmt::join(named, ", "),
                     count > named.size() ? ", ..." : "");
}

}  // namespace

std::string listed_draws(const std::vector<std::string>& names) {
  constexpr std::size_t few = 5;
  const std::size_t shown = std::min(few, names.size());
  return fmt::format("{} {} ({}{})", names.size(), names.size() == 1 ? "draw" : "draws",
                     fmt::join(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(shown), ", "),
                     shown < names.size() ? ", ..." : "");
}

void tell_overdraw_details(const SubjectsInPoses& subjects, const OverdrawService& service, const Views& views,
                           SequenceFrom said_by, Run& run) {
  if (!service.can_capture()) {
    return run.note("no-details",
                    "this evaluator does not record which draw shades a fragment; use overdraw-raster for details");
  }
  const Scene& scene = subjects.scene;
  Hidden hidden(scene.draws.size());
  std::vector<double> pixels(most_times + 1);
  std::vector<std::string> convex;
  for (std::size_t pose = 0; pose < subjects.poses.poses.size(); ++pose) {
    const PosedNodes nodes = posed_nodes(scene, subjects.poses.poses[pose]);
    for (std::size_t i = 0; i < subjects.subjects.size(); ++i) {
      if (!subjects.is_new(i, pose)) continue;
      const Subject& subject = subjects.subjects[i];
      const SubjectGeometry posed = subject_geometry(scene, subject, service.faces(), nodes, run.analyses);
      if (!subjects.moves(i) && overdraw_bound(posed.parts, least_overdraw)) convex.push_back(subject.name);
      const Pose& moment = subjects.poses.poses[pose];
      for (const ViewsOfOrders& some : views_by_orders(scene, subject, moment, views.views, said_by)) {
        const std::vector<RasterPart> drawn = parts_as_drawn(posed, scene, subject, some);
        const auto layers = service.capture(drawn, chosen(views, some.views), run);
        if (!layers) {
          return run.note("no-details",
                          fmt::format("the layers of {} take more than {} MB; ask for fewer or smaller views",
                                      subject.name, default_layer_bytes >> 20));
        }
        std::vector<std::uint32_t> as_drawn(layers->owners);
        std::iota(as_drawn.begin(), as_drawn.end(), 0u);
        const OverdrawDetails details = overdraw_details(*layers, as_drawn);
        const double weight = subjects.distinct[i].weights[pose];
        add_hidden(hidden, subject, drawn, some.sequence, details.hidden, weight);
        for (std::size_t times = 1; times < details.pixels_by_times.size(); ++times) {
          pixels[std::min(times, most_times)] += weight * static_cast<double>(details.pixels_by_times[times]);
        }
      }
    }
  }
  for (std::size_t times = 1; times <= most_times; ++times) {
    run.count_at({}, fmt::format("shaded-times.{}", times), pixels[times]);
  }
  std::vector<std::string> free_of_it;
  double all = 0;
  for (const auto& of_draw : hidden) all += sum_of(of_draw);
  for (DrawId draw = 0; draw < hidden.size(); ++draw) {
    const double of_draw = sum_of(hidden[draw]);
    if (of_draw == 0 && !hidden[draw].empty()) free_of_it.push_back(scene.draws[draw].name);
    if (of_draw == 0 || of_draw < all / 100) continue;
    std::string message = fmt::format("shades {:.1f} % of the fragments that end up hidden", 100 * of_draw / all);
    const std::vector<IndexStream>& orders = scene.draws[draw].full().orders;
    const auto& clusters = orders[0].clusters;
    // In several orders a triangle has several numbers, and so has a cluster.
    if (clusters && orders.size() == 1) message += "; " + worst_clusters(*clusters, hidden[draw]);
    run.note_at({draw, {}, {}}, "causes-overdraw", message);
  }
  if (!convex.empty()) {
    run.note_at({}, "convex",
                fmt::format("convex or nearly convex, so no order has a higher ratio than {}: {}", least_overdraw,
                            listed_draws(convex)));
  }
  if (!free_of_it.empty()) {
    run.note_at({}, "no-overdraw",
                fmt::format("shade no fragment that ends up hidden, from any view: {}", listed_draws(free_of_it)));
  }
}

}  // namespace foredraw
