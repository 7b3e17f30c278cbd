#include "k_orders.h"

#include <foredraw/analysis/cluster_layers.h>
#include <foredraw/analysis/distinct_poses.h>
#include <foredraw/analysis/order_nodes.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

struct Options : KOrdersOptions, OrderGrid {
  std::optional<int> made_for;  // entries of the cache, in place of what the draw says
};

std::uint32_t cache_size_of(const IndexStream& stream, const Options& options) {
  constexpr std::uint32_t usual = 16;
  if (options.made_for) return static_cast<std::uint32_t>(*options.made_for);
  return stream.cache_size > 0 ? stream.cache_size : usual;
}

/// Clusters where the draw has some, else atoms of its order.
Clusters atoms_of(const Draw& draw, const Options& options) {
  const IndexStream& stream = draw.levels[0].orders[0];
  if (stream.clusters) return *stream.clusters;
  return cut_atoms(stream.indices.view(), draw.levels[0].vertices->count, cache_size_of(stream, options),
                   atom_size(options.quality));
}

std::vector<std::uint32_t> triangles_of(const Clusters& atoms, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(atoms.offsets.back());
  for (const std::uint32_t atom : order) {
    for (std::uint32_t t = atoms.offsets[atom]; t < atoms.offsets[atom + 1]; ++t) triangles.push_back(t);
  }
  return triangles;
}

/// What a subject looks like in every pose and view. Draws that are not to be ordered are one atom each.
class Look {
 public:
  Look(const SubjectView& view, const Options& options, Run& run) : view_(view), options_(options), run_(run) {
    for (const SubjectPart& part : view.subject.parts) add_part(part.draw);
    const Subject subjects[] = {view.subject};
    distinct_ = distinct_poses(view.scene, subjects, run.poses, run.executor).front();
    for (std::size_t pose = 0; pose < run.poses.poses.size() && !run.cancelled(); ++pose) {
      if (distinct_.first_alike[pose] == pose) add_pose(pose);
    }
  }

  const SeenSubject& subject() const { return subject_; }
  /// [i] of the view's draws: its number in the subject.
  std::size_t number_of(DrawId draw) const {
    return static_cast<std::size_t>(std::ranges::find(draws_, draw) - draws_.begin());
  }
  /// Of the pose's first node in the subject.
  std::size_t first_node(std::size_t pose) const { return first_node_[distinct_.first_alike[pose]]; }

 private:
  void add_part(DrawId id) {
    if (std::ranges::find(draws_, id) != draws_.end()) return;
    draws_.push_back(id);
    const Draw& draw = view_.scene.draws[id];
    const IndexStream& stream = draw.levels[0].orders[0];
    const bool is_ordered = std::ranges::find(view_.draws, id) != view_.draws.end();
    const auto triangles = static_cast<std::uint32_t>(stream.triangle_count());
    subject_.draws.push_back({stream.indices.view(), draw.levels[0].vertices->count,
                              is_ordered ? atoms_of(draw, options_)
                                         : triangles > 0 ? Clusters{{0, triangles}} : Clusters{{0}}});
  }

  void add_pose(std::size_t pose) {
    const Subject& subject = view_.subject;
    const PosedNodes nodes = subject.is_placed() ? posed_nodes(view_.scene, run_.poses.poses[pose]) : PosedNodes();
    const DrawnSubject drawn = drawn_subject(view_.scene, subject, run_.overdraw->faces(), nodes, run_.analyses);
    Clusters all{{0}};
    const bool is_first = subject_.owners.empty();
    for (std::uint32_t part = 0; part < drawn.parts.size(); ++part) {
      if (drawn.parts[part].indices.empty()) continue;
      const auto d = static_cast<std::uint32_t>(number_of(subject.parts[part].draw));
      const Clusters& atoms = subject_.draws[d].atoms;
      const std::uint32_t first = all.offsets.back();
      for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) {
        all.offsets.push_back(first + atoms.offsets[atom + 1]);
        if (is_first) subject_.owners.push_back({part, d, atom});
      }
    }
    const auto captured = run_.overdraw->capture(drawn.parts, run_.views, run_);
    if (!captured) {
      throw std::runtime_error("what hides what can not be captured: let overdraw-raster answer in [services], or let "
                               "[views] name fewer or smaller pictures");
    }
    ClusterLayers layers = cluster_layers(*captured, all, run_.executor);
    subject_.layers.owners = layers.owners;
    first_node_.resize(pose + 1);
    first_node_[pose] = subject_.layers.views.size();
    for (std::size_t v = 0; v < layers.views.size(); ++v) {
      subject_.layers.views.push_back(std::move(layers.views[v]));
      subject_.directions.push_back(run_.views.views[v].direction);
      subject_.weights.push_back(run_.views.views[v].weight * distinct_.weights[pose]);
    }
  }

  const SubjectView& view_;
  const Options& options_;
  Run& run_;
  std::vector<DrawId> draws_;
  SeenSubject subject_;
  DistinctPoses distinct_;
  std::vector<std::size_t> first_node_;  // [pose]
};

double ratio(std::span<const OverdrawCount> counts, std::span<const double> weights) {
  double shaded = 0, visible = 0;
  for (std::size_t node = 0; node < counts.size(); ++node) {
    shaded += weights[node] * static_cast<double>(counts[node].shaded);
    visible += weights[node] * static_cast<double>(counts[node].visible);
  }
  return visible > 0 ? shaded / visible : 1;
}

class OcclusionOrder final : public SubjectOrderer {
 public:
  explicit OcclusionOrder(Options options) : options_(options) {}

  SubjectOrders order(const SubjectView& view, Run& run) override {
    Options options = options_;
    options.seed = run.seed;
    options.cache_size = cache_size_of(view.scene.draws[view.draws[0]].levels[0].orders[0], options_);
    const Look look(view, options, run);
    const SeenSubject& subject = look.subject();
    std::vector<std::vector<std::uint32_t>> as_it_came;
    for (const AtomicDraw& draw : subject.draws) {
      as_it_came.emplace_back();
      for (std::uint32_t atom = 0; atom < draw.atoms.count(); ++atom) as_it_came.back().push_back(atom);
    }
    const double before = ratio(counts_of(subject, as_it_came), subject.weights);
    if (before == 1) {
      run.keep("nothing in it is drawn that does not stay");
      return {};
    }
    const KOrders found = k_orders(subject, options, run.executor);
    const double after = ratio(found.counts, subject.weights);
    if (after >= before) {
      run.keep(fmt::format("ordered anew, its overdraw would be {:.4f} and not {:.4f} as it is", after, before));
      return {};
    }
    SubjectOrders result;
    result.table = found.orders.size() == 1
                       ? OrderTable{.order = {0}}
                       : order_table(view.scene, run.poses, run.views, serving_by_pose(look, found, run), options);
    result.table.draws = view.draws;
    for (const DrawId id : view.draws) {
      const std::size_t d = look.number_of(id);
      result.orders.emplace_back();
      for (const auto& order : found.orders) result.orders.back().push_back(triangles_of(subject.draws[d].atoms, order[d]));
    }
    return result;
  }

 private:
  static std::vector<std::uint8_t> serving_by_pose(const Look& look, const KOrders& found, const Run& run) {
    std::vector<std::uint8_t> serving;
    for (std::size_t pose = 0; pose < run.poses.poses.size(); ++pose) {
      const std::size_t first = look.first_node(pose);
      for (std::size_t v = 0; v < run.views.views.size(); ++v) serving.push_back(found.serving[first + v]);
    }
    return serving;
  }

  Options options_;
};

}  // namespace

Plugin occlusion_order_plugin() {
  Plugin plugin;
  plugin.kind = Kind::orderer;
  plugin.card = {
      .name = "occlusion-order",
      .summary = "Draws first what hides most, as measured from all sides and in all poses, in one or several orders",
      .reference = "own; orders by node as in Han, Sander 2016, section 3",
      .acts_on = {traits::triangles},
      .provides = {traits::overdraw_ordered},
      .breaks = {traits::fetch_ordered},
      .pays_if = "something is drawn that does not stay, and the new order draws less of it",
      .uses_overdraw = true,
  };
  OptionTable<Options> table;
  table.row<int>(&Options::k, "k", "Orders of each draw, of which the engine draws one by view and pose", {1, 255, "orders"});
  table.row<double>(&Options::acmr_budget, "acmr-budget",
            "What the orders may cost in the vertex cache: times the ACMR of the order that came in", {1, 100});
  table.choice<OcclusionQuality>(&Options::quality, "quality", "How much is tried out, against time",
               {{"fast", OcclusionQuality::fast},
                {"balanced", OcclusionQuality::balanced},
                {"high", OcclusionQuality::high}});
  table.row<std::optional<int>>(&Options::made_for, "cache-size",
            "Size of the FIFO vertex cache that the budget is reckoned for; without it what the order was made for, or 16",
            {3, 65535, "entries"});
  table.row<int>(&Options::theta_steps, "theta-steps",
                 "Steps of the table that says which order to draw, from straight above to straight below", {1, 1024});
  table.row<int>(&Options::phi_steps, "phi-steps", "The same, around the subject", {1, 1024});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<OcclusionOrder>(options); });
  return plugin;
}

}  // namespace foredraw
