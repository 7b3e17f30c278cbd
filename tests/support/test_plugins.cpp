#include "support/test_plugins.h"

#include <foredraw/draw_orders/draw_orders_product.h>
#include <foredraw/measuring/overdraw_service.h>

#include <algorithm>
#include <numeric>
#include <stdexcept>

namespace foredraw::testing {

namespace {

std::vector<std::uint32_t> falling(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.rbegin(), order.rend(), 0u);
  return order;
}

std::vector<std::uint32_t> rising(std::size_t count) {
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

struct ReverseDraw final : DrawOrderer {
  IndexOrder order(const DrawView& draw, Run&) const override { return falling(draw.triangle_count()); }
  int cache_size() const override { return 24; }
};

struct KeepsEverything final : DrawOrderer {
  IndexOrder order(const DrawView&, Run& run) const override {
    run.keep("it is best as it is");
    return {};
  }
  int cache_size() const override { return 48; }
};

/// And a third one, between them, that its table never names: it is left out.
struct TwoOrders final : SubjectOrderer {
  SubjectOrders order(const SubjectView& subject, Run&) const override {
    SubjectOrders answer;
    answer.table.draws = subject.draws;
    answer.table.theta_steps = 2;
    answer.table.order = {0, 2};
    for (DrawId id : subject.draws) {
      const std::size_t triangles = subject.scene.draws[id].levels[0].orders[0].triangle_count();
      answer.orders.push_back({rising(triangles), rising(triangles), falling(triangles)});
    }
    return answer;
  }
};

struct ReverseVertices final : VertexOrderer {
  VertexOrder order(const VertexUse& use, Run&) const override { return falling(use.vertices.count); }
};

struct Pairs final : Clusterer {
  Clusters cluster(const DrawView& draw, Run&) const override {
    Clusters clusters;
    for (std::uint32_t t = 0; t < draw.triangle_count(); t += 2) clusters.offsets.push_back(t);
    clusters.offsets.push_back(static_cast<std::uint32_t>(draw.triangle_count()));
    return clusters;
  }
};

struct AddDraw final : Processor {
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    if (draws.empty()) return {};
    Draw copy = scene.draws[draws.front()];
    copy.name += " again";
    copy.origin.reset();
    const auto id = static_cast<DrawId>(scene.draws.size());
    scene.draws.push_back(std::move(copy));
    scene.meshes.front().draws.push_back(id);
    run.count_at({id}, "added", 1);
    run.note_at({id}, "added", "it was not there before");
    return draws;
  }
};

struct DoubleTriangles final : DrawProcessor {
  Draw process(const DrawView& draw, Run&) const override {
    Draw result = draw.draw();
    std::vector<std::uint32_t> indices(draw.indices().begin(), draw.indices().end());
    indices.insert(indices.end(), draw.indices().begin(), draw.indices().end());
    result.levels[0].orders = {{.indices = Shared<std::uint32_t>(std::move(indices))}};
    return result;
  }
};

struct CountDraws final : Evaluator {
  void evaluate(const Scene& scene, Run& run) const override {
    run.count("draws", static_cast<double>(scene.draws.size()));
  }
};

struct CountTriangles final : DrawEvaluator {
  void evaluate(const DrawView& draw, Run& run) const override {
    run.count("triangles", static_cast<double>(draw.triangle_count()));
    run.measure("corners-per-vertex", static_cast<double>(draw.indices().size()),
                static_cast<double>(draw.vertex_count()));
  }
};

struct AskOverdraw final : DrawOrderer {
  IndexOrder order(const DrawView& draw, Run& run) const override {
    if (run.overdraw == nullptr) throw std::runtime_error("nobody measures overdraw");
    const Subject subject{draw.draw().name, {{draw.id, {}}}};
    const OverdrawCount count = run.overdraw->count(draw.scene, subject, run.views, run)[0][0];
    return count.shaded > count.visible ? falling(draw.triangle_count()) : rising(draw.triangle_count());
  }
};

struct FixedOverdraw final : OverdrawService {
  OverdrawCounts draw(std::span<const RasterPart> parts, const Views& views, Run&) const override {
    return OverdrawCounts(parts.size(), std::vector<OverdrawCount>(views.views.size(), {3, 2, 0}));
  }
};

struct Faulty final : DrawOrderer {
  explicit Faulty(FaultyOptions o) : options(std::move(o)) {}
  IndexOrder order(const DrawView& draw, Run&) const override {
    IndexOrder order = rising(draw.triangle_count());
    if (options.on != "*" && options.on != draw.draw().name) return order;
    if (options.fault == "throw") throw std::runtime_error("something went wrong");
    if (options.fault == "odd-throw") throw 42;
    if (options.fault == "short") order.pop_back();
    if (options.fault == "repeat") order.front() = order.back();
    return order;
  }
  FaultyOptions options;
};

}  // namespace

Plugin reverse_draw() {
  return plugin_of<ReverseDraw>(
      Kind::orderer, {.name = "reverse-draw", .acts_on = {traits::triangles}, .provides = {traits::cache_ordered}});
}
Plugin two_orders() {
  Plugin plugin = plugin_of<TwoOrders>(Kind::orderer, {.name = "two-orders", .acts_on = {traits::triangles}});
  plugin.products = {draw_orders_product()};
  return plugin;
}
Plugin reverse_vertices() { return plugin_of<ReverseVertices>(Kind::orderer, {.name = "reverse-vertices"}); }
Plugin pairs() {
  return plugin_of<Pairs>(Kind::clusterer,
                          {.name = "pairs", .acts_on = {traits::triangles}, .provides = {traits::clustered}});
}
Plugin add_draw() { return plugin_of<AddDraw>(Kind::processor, {.name = "add-draw", .acts_on = {traits::triangles}}); }
Plugin double_triangles() {
  return plugin_of<DoubleTriangles>(
      Kind::processor, {.name = "double-triangles", .acts_on = {traits::triangles}, .breaks = {traits::clustered}});
}
Plugin count_draws() {
  return plugin_of<CountDraws>(Kind::evaluator, {.name = "count-draws", .metrics = {{"draws", "draws", "How many"}}});
}
Plugin count_triangles() {
  return plugin_of<CountTriangles>(
      Kind::evaluator,
      {.name = "count-triangles",
       .acts_on = {traits::triangles},
       .metrics = {{"triangles", "triangles", "How many"}, {"corners-per-vertex", "corners per vertex", "Sharing"}}});
}
Plugin ask_overdraw() {
  return plugin_of<AskOverdraw>(Kind::orderer,
                                {.name = "ask-overdraw", .acts_on = {traits::triangles}, .uses_overdraw = true});
}
Plugin answer_overdraw() {
  Plugin plugin =
      plugin_of<CountDraws>(Kind::evaluator, {.name = "answer-overdraw", .metrics = {{"draws", "draws", "How many"}}});
  plugin.overdraw_service = [](const Settings&) { return std::make_unique<FixedOverdraw>(); };
  return plugin;
}

Plugin faulty() {
  Plugin plugin = plugin_of<ReverseDraw>(Kind::orderer, {.name = "faulty", .acts_on = {traits::triangles}});
  OptionTable<FaultyOptions> table;
  table.row(&FaultyOptions::fault, "fault", "What goes wrong").row(&FaultyOptions::on, "on", "Where");
  bind_options(plugin, table, [](const FaultyOptions& options) { return std::make_unique<Faulty>(options); });
  return plugin;
}

Plugin keeps_everything() {
  return plugin_of<KeepsEverything>(Kind::orderer, {.name = "keeps-everything",
                                                    .acts_on = {traits::triangles},
                                                    .provides = {traits::cache_ordered},
                                                    .breaks = {traits::clustered}});
}

Plugin unavailable() {
  Plugin plugin = plugin_of<ReverseDraw>(Kind::orderer, {.name = "unavailable", .acts_on = {traits::triangles}});
  plugin.unavailable = [] { return std::optional<std::string>("no such device"); };
  return plugin;
}

Plugin needs_clusters() {
  return plugin_of<ReverseDraw>(Kind::orderer, {.name = "needs-clusters",
                                                .acts_on = {traits::triangles},
                                                .needs = {traits::clustered},
                                                .breaks = {traits::cache_ordered}});
}

void add_test_plugins(Registry& registry) {
  for (const auto& make :
       {reverse_draw, two_orders, reverse_vertices, pairs, add_draw, double_triangles, count_draws, count_triangles,
        ask_overdraw, answer_overdraw, faulty, keeps_everything, unavailable, needs_clusters}) {
    registry.add(make());
  }
}

}  // namespace foredraw::testing
