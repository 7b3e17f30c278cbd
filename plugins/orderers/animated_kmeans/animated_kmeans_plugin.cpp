#include "animated_kmeans.h"

#include <foredraw/base/random.h>
#include <foredraw/draw_orders/draw_orders_product.h>
#include <foredraw/measuring/subject_capture.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/order_grid.h>

#include <fmt/format.h>

#include <map>
#include <stdexcept>

namespace foredraw {

namespace {

enum class Clips { joint, single };

struct Options : AnimatedKMeansOptions, OrderGrid {
  Clips clips = Clips::joint;
  std::int64_t start = 0;
};

/// Poses that share their index buffers, by their numbers.
std::vector<std::vector<std::size_t>> shares(const Poses& poses, Clips clips) {
  std::map<std::optional<AnimationId>, std::vector<std::size_t>> by_clip;
  for (std::size_t i = 0; i < poses.poses.size(); ++i) {
    by_clip[clips == Clips::single ? poses.poses[i].clip : std::nullopt].push_back(i);
  }
  std::vector<std::vector<std::size_t>> result;
  for (auto& [clip, numbers] : by_clip) result.push_back(std::move(numbers));
  return result;
}

/// Sums over the buffers of all clips.
struct Answer {
  std::vector<std::vector<IndexOrder>> orders;  // [draw of the view][buffer]
  std::vector<std::uint8_t> serving;            // [pose * number of views + view]
  ViewTally before, after;
};

class AnimatedKmeansOrderer final : public SubjectOrderer {
 public:
  explicit AnimatedKmeansOrderer(Options options) : options_(options) {}

  SubjectOrders order(const SubjectView& view, Run& run) const override {
    const auto sets = shares(run.poses, options_.clips);
    require_room(sets.size());
    Answer answer;
    answer.orders.resize(view.draws.size());
    answer.serving.resize(run.poses.poses.size() * run.views.views.size());
    for (const std::vector<std::size_t>& poses : sets) add_buffers(answer, poses, view, run);
    if (!has_overdraw(answer.before, run) || !lowers_overdraw(answer.before, answer.after, run)) return {};
    SubjectOrders result;
    result.table = order_table(view.scene, run.poses, run.views, answer.serving, options_);
    result.table.draws = view.draws;
    result.orders = std::move(answer.orders);
    return result;
  }

 private:
  void require_room(std::size_t sets) const {
    constexpr std::size_t most = 255;
    const std::size_t orders = sets * static_cast<std::size_t>(options_.k);
    if (orders <= most) return;
    throw std::invalid_argument(
        fmt::format("{} orders for each of {} clips make {} orders, but a table holds at most {}: set clips = "
                    "\"joint\", lower k to {}, or choose fewer clips in [poses]",
                    options_.k, sets, orders, most, std::max<std::size_t>(1, most / sets)));
  }

  void add_buffers(Answer& answer, const std::vector<std::size_t>& numbers, const SubjectView& view, Run& run) const {
    Poses poses{{}};
    for (const std::size_t number : numbers) poses.poses.push_back(run.poses.poses[number]);
    PatchDistances distances(run.views.views);
    const SubjectCapture captured = capture_subject(
        view, poses, [](const Draw& draw) { return *draw.full().stream().clusters; }, run,
        [&](const SubjectLayers& seen, const SubjectGeometry& drawn) {
          distances.add_pose(seen, drawn.parts, run.executor);
        });
    AnimatedKMeansOptions options = options_;
    options.seed = derive_seed(run.seed, static_cast<std::uint64_t>(options_.start), 0);
    const IndexBuffers found = animated_kmeans(captured.seen, distances, options, run.executor);
    answer.before += tally_of(captured.seen, counts_of(captured.seen, as_it_came(captured.seen)));
    answer.after += tally_of(captured.seen, found.counts);

    const std::size_t first = answer.orders[0].size();
    for (std::size_t i = 0; i < view.draws.size(); ++i) {
      const std::size_t d = captured.number_of(view.draws[i]);
      for (const auto& order : found.orders) {
        answer.orders[i].push_back(in_sequence(captured.seen.draws[d].atoms, order[d]));
      }
    }
    const std::size_t views = run.views.views.size();
    const std::vector<std::uint8_t> serving = captured.by_pose(found.serving);
    for (std::size_t i = 0; i < serving.size(); ++i) {
      answer.serving[numbers[i / views] * views + i % views] = static_cast<std::uint8_t>(first + serving[i]);
    }
  }

  Options options_;
};

}  // namespace

Plugin animated_kmeans_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "animated-kmeans",
      .summary = "Sorts an animated character's clusters front to back, in several orders chosen by pose and view",
      .reference = "Han, Sander 2016, section 3",
      .acts_on = {traits::triangles, traits::animated},
      .needs = {traits::clustered},
      .provides = {traits::overdraw_ordered},
      .breaks = {traits::fetch_ordered},
      .pays_if = "the subject has overdraw, and the new orders lower it as measured",
      .uses_overdraw = true,
  };
  plugin.products = {draw_orders_product()};
  OptionTable<Options> table;
  table.row<int>(&Options::k, "k",
                 "Number of orders for each draw, of which the engine picks one by view and pose; more orders lower "
                 "overdraw and take more memory",
                 {1, 255, "orders"});
  table.choice<Clips>(&Options::clips, "clips",
                      "joint: all clips share k orders; single: each clip has k orders of its own, at most 255 in all",
                      {{"joint", Clips::joint}, {"single", Clips::single}});
  table.choice<OverdrawMetric>(&Options::metric, "metric",
                               "How the best result is chosen. ratio: all fragments over all covered pixels; "
                               "view-mean: the mean of the ratios of all looks",
                               {{"ratio", OverdrawMetric::ratio}, {"view-mean", OverdrawMetric::view_mean}});
  table.row<int>(
      &Options::restarts, "restarts",
      "How often to search again from other starting looks; the best result is kept, and each search takes time",
      {0, 1000, "times"});
  table.row<std::int64_t>(&Options::start, "seed", "Seed of the starting looks, combined with the pipeline's seed");
  table.row<int>(&Options::theta_steps, "theta-steps",
                 "Rows of the table from which the engine reads which order to draw: steps of the view from straight "
                 "above to straight below",
                 {1, 1024});
  table.row<int>(&Options::phi_steps, "phi-steps", "Columns of that table: steps of the view around the subject",
                 {1, 1024});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<AnimatedKmeansOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
