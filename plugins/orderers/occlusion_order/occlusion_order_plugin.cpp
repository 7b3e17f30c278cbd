#include "k_orders.h"

#include <foredraw/draw_orders/draw_orders_product.h>
#include <foredraw/measuring/subject_capture.h>
#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/order_grid.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

struct Options : KOrdersOptions, OrderGrid {
  std::optional<int> made_for;  // entries of the cache, in place of what the draw says
  std::int64_t start = 0;
  bool sequences = true;
};

std::uint32_t cache_size_of(const IndexStream& stream, const Options& options) {
  constexpr std::uint32_t usual = 16;
  if (options.made_for) return static_cast<std::uint32_t>(*options.made_for);
  return stream.cache_size > 0 ? stream.cache_size : usual;
}

/// Clusters where the draw has some, else atoms of its order.
Clusters atoms_of(const Draw& draw, const Options& options) {
  const IndexStream& stream = draw.full().stream();
  if (stream.clusters) return *stream.clusters;
  return cut_atoms(stream.indices.view(), draw.full().vertices->count, cache_size_of(stream, options),
                   atom_size(options, stream.triangle_count()));
}

/// The capture of many looks takes most of the time: then a better search for orders is cheap beside it.
bool has_many_looks(const SubjectView& view, const Run& run) {
  constexpr std::size_t many = 1000;
  const bool moves = view.subject.is_placed() && !run.poses.share_views;
  return moves && run.poses.poses.size() * run.views.views.size() > many;
}

/// A sequence of the parts for each order, where the looks that decided nothing agree that they are better.
std::optional<KSequences> sequences_of(const SubjectView& view, const SubjectLayers& seen, const Options& options,
                                       const Run& run) {
  constexpr std::size_t most_parts = 1024;  // every one is tried at every place, from every start
  const std::size_t parts = view.subject.parts.size();
  if (options.k < 2 || !options.sequences || view.free_groups.empty() || parts > most_parts) return std::nullopt;
  KSequences found = k_sequences(seen, static_cast<std::uint32_t>(parts), view.free_groups,
                                 {.k = options.k, .seed = options.seed}, run.executor);
  if (found.after.shaded < found.before.shaded) return found;
  return std::nullopt;
}

/// What a search comes to, beside what there was.
struct Found {
  SubjectCapture captured;
  std::optional<KSequences> sequences;
  KOrders orders;
  ViewTally before, after;
};

/// Nothing where nothing is overdrawn, which the run is told.
std::optional<Found> search(const SubjectView& view, const Options& options, Run& run) {
  Found found;
  found.captured = capture_subject(
      view, run.poses, [&](const Draw& draw) { return atoms_of(draw, options); }, run, {},
      options.k == 1 ? most_looks(options.quality) : every_look);
  const SubjectLayers& subject = found.captured.seen;
  found.before = tally_of(subject, counts_of(subject, as_it_came(subject)));
  if (!has_overdraw(found.before, run)) return std::nullopt;
  found.sequences = sequences_of(view, subject, options, run);
  found.orders = k_orders(subject, options, run.executor, found.sequences ? &*found.sequences : nullptr);
  found.after = tally_of(subject, found.orders.counts);
  return found;
}

class OcclusionOrderOrderer final : public SubjectOrderer {
 public:
  explicit OcclusionOrderOrderer(Options options) : options_(options) {}

  SubjectOrders order(const SubjectView& view, Run& run) const override {
    if (!may_overdraw(view, run)) return {};
    Options options = options_;
    options.seed = run.seed + static_cast<std::uint64_t>(options_.start);
    options.cache_size = cache_size_of(view.scene.draws[view.draws[0]].full().stream(), options_);
    options.fine_atoms = options.k > 1 || has_many_looks(view, run);
    std::optional<Found> found = search(view, options, run);
    if (!found) return {};
    if (options.quality == OcclusionQuality::high) {  // finer atoms mostly find the better order, but not always
      options.quality = OcclusionQuality::balanced;
      std::optional<Found> plainer = search(view, options, run);
      if (plainer && plainer->after.shaded < found->after.shaded) found = std::move(plainer);
    }
    if (!lowers_overdraw(found->before, found->after, run)) return {};
    const SubjectCapture& captured = found->captured;
    SubjectOrders result;
    result.table = order_table(view.scene, run.poses, run.views, captured.by_pose(found->orders.serving), options);
    result.table.draws = view.draws;
    if (found->sequences) add_sequences(result.table, view, *found, run);
    for (const DrawId id : view.draws) {
      const std::size_t d = captured.number_of(id);
      result.orders.emplace_back();
      for (const auto& order : found->orders.orders) {
        result.orders.back().push_back(in_sequence(captured.seen.draws[d].atoms, order[d]));
      }
    }
    return result;
  }

 private:
  static void add_sequences(OrderTable& table, const SubjectView& view, const Found& found, Run& run) {
    table.parts = view.subject.parts;
    for (const auto& sequence : found.orders.sequences) {
      table.sequences.insert(table.sequences.end(), sequence.begin(), sequence.end());
    }
    const auto ratio = [](const ViewTally& tally) { return tally.shaded / tally.visible; };
    run.note(
        "sequences",
        fmt::format("{} draws in a sequence of their own for each order: from views that decided nothing, overdraw "
                    "between draws falls from {:.4f} to {:.4f}",
                    table.parts.size(), ratio(found.sequences->before), ratio(found.sequences->after)));
  }

  Options options_;
};

}  // namespace

Plugin occlusion_order_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "occlusion-order",
      .summary =
          "Draws first what hides most, as measured from many views and poses; put lookahead or tipsify before it",
      .reference = "own; orders by look as in Han, Sander 2016, section 3",
      .acts_on = {traits::triangles},
      .wants = {traits::cache_ordered},
      .uses = {traits::clustered},
      .provides = {traits::overdraw_ordered},
      .breaks = {traits::fetch_ordered},
      .pays_if = "the subject has overdraw, and the new order lowers it as measured",
      .uses_overdraw = true,
  };
  plugin.products = {draw_orders_product()};
  OptionTable<Options> table;
  table.row<int>(&Options::k, "k",
                 "Number of orders for each draw, of which the engine picks one by view and pose; more orders lower "
                 "overdraw and take more memory",
                 {1, 255, "orders"});
  table.row<double>(
      &Options::acmr_budget, "acmr-budget",
      "Highest ACMR allowed, as a multiple of that of the order that comes in; more lets overdraw fall further",
      {1, 100});
  table.row<double>(&Options::vertex_weight, "vertex-weight",
                    "Within that budget: how many per cent of the fragments one per cent more shaded vertices must "
                    "save; higher keeps the ACMR lower, 0 spends the whole budget",
                    {0, 1000});
  table.choice<OcclusionQuality>(
      &Options::quality, "quality", "How much is tried: high leaves the least overdraw, fast takes the least time",
      {{"fast", OcclusionQuality::fast}, {"balanced", OcclusionQuality::balanced}, {"high", OcclusionQuality::high}});
  table.row<std::optional<int>>(&Options::made_for, "cache-size",
                                "Size of the FIFO vertex cache that the ACMR is counted with; by default the one that "
                                "the order was made for, or 16",
                                {3, 65535, "entries"});
  table.row<int>(&Options::restarts, "restarts",
                 "With k above 1: how often to search again from other starting looks; the best result is kept, and "
                 "each search takes time",
                 {0, 1000, "times"});
  table.row<std::int64_t>(&Options::start, "seed", "Seed of the starting looks, added to the pipeline's seed");
  table.row<bool>(&Options::sequences, "sequences",
                  "With k above 1: give each order a sequence of the subject's draws, in which the engine draws them; "
                  "false for engines that cannot draw in a sequence that changes");
  table.row<int>(&Options::theta_steps, "theta-steps",
                 "Rows of the table from which the engine reads which order to draw: steps of the view from straight "
                 "above to straight below",
                 {1, 1024});
  table.row<int>(&Options::phi_steps, "phi-steps", "Columns of that table: steps of the view around the subject",
                 {1, 1024});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<OcclusionOrderOrderer>(options); });
  return plugin;
}

}  // namespace foredraw
