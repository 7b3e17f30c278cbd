#include "second_depth.h"
#include "second_depth_product.h"

#include <foredraw/scene/reorder.h>
#include <foredraw/shells/second_depth.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

using ShellKind = processors::second_depth::Kind;

class SecondDepthProcessor final : public Processor {
 public:
  explicit SecondDepthProcessor(SecondDepthOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    SecondDepth all;
    for (std::size_t m = 0; m < scene.meshes.size() && !run.cancelled(); ++m) {
      std::vector<DrawId> candidates;
      std::vector<std::uint32_t> triangles;
      for (const DrawId id : scene.meshes[m].draws) {
        if (!std::ranges::binary_search(draws, id) || !may_go(scene, id, run)) continue;
        candidates.push_back(id);
        triangles.push_back(first_range(scene, id, run));
      }
      processors::second_depth::Limits limits{&run.executor, run.cancel, {}};
      if (run.progress) {
        limits.progress = [&, m](double part) {
          run.progress((static_cast<double>(m) + part) / static_cast<double>(scene.meshes.size()));
        };
      }
      for (const DrawShells& draw : shells_of(scene, candidates, triangles, run.analyses, limits)) {
        tell(draw, scene, run);
        const auto closed = static_cast<std::uint32_t>(std::ranges::count(draw.kinds, ShellKind::closed));
        if (closed == 0) continue;
        all.draws.push_back({draw.draw, closed});
        put_closed_first(scene.draws[draw.draw], draw.kinds);
      }
    }
    if (run.cancelled()) return {};
    if (all.draws.empty()) {
      run.keep("no draw has a closed shell that may be drawn without its front faces; the notes say why");
      return {};
    }
    std::ranges::sort(all.draws, {}, &SecondDepth::OfDraw::draw);
    std::vector<DrawId> changed;
    for (const SecondDepth::OfDraw& of : all.draws) changed.push_back(of.draw);
    scene.products.set(std::move(all));
    return changed;
  }

 private:
  bool may_go(const Scene& scene, DrawId id, Run& run) const {
    std::string why = why_not_in_second_depth(scene, id, options_);
    if (why.empty() && scene.draws[id].full().orders.size() > 1) {
      why = "has several orders; put this stage before the one that makes them";
    }
    if (why.empty()) return true;
    run.note_at({.draw = id}, "not-closed", "left out: it " + why);
    measure(scene.draws[id], id, 0, run);
    return false;
  }

  static double measure(const Draw& draw, DrawId id, double closed, Run& run) {
    const double whole = draw.full().vertices->find("POSITION") == nullptr ? 0 : area_of(draw, run.analyses);
    if (whole > 0) run.measure_at({.draw = id}, "closed-area", closed, whole);
    return whole;
  }

  /// What lies behind belongs to other products, as wires do, and stays where it is.
  static std::uint32_t first_range(const Scene& scene, DrawId id, const Run& run) {
    const std::vector<std::uint32_t> bounds = run.bounds(scene, {id, 0}, SecondDepth::product);
    return bounds.empty() ? static_cast<std::uint32_t>(scene.draws[id].full().stream().triangle_count())
                          : bounds.front();
  }

  static void put_closed_first(Draw& draw, const std::vector<ShellKind>& kinds) {
    IndexOrder order;
    for (const bool closed : {true, false}) {
      for (std::uint32_t t = 0; t < kinds.size(); ++t) {
        if ((kinds[t] == ShellKind::closed) == closed) order.push_back(t);
      }
    }
    if (std::ranges::is_sorted(order)) return;
    for (auto t = static_cast<std::uint32_t>(kinds.size()); t < draw.full().stream().triangle_count(); ++t) {
      order.push_back(t);
    }
    draw = with_triangle_order(draw, order);
  }

  static void tell(const DrawShells& draw, const Scene& scene, Run& run) {
    static constexpr std::pair<ShellKind, const char*> words[] = {{ShellKind::open, "open"},
                                                                  {ShellKind::flat, "flat, both walls in one place"},
                                                                  {ShellKind::inside_out, "inside out"},
                                                                  {ShellKind::turned, "partly inside out"}};
    std::array<double, 5> areas{};
    std::array<std::size_t, 5> counts{};
    for (std::size_t t = 0; t < draw.kinds.size(); ++t) {
      areas[static_cast<std::size_t>(draw.kinds[t])] += draw.areas[t];
      ++counts[static_cast<std::size_t>(draw.kinds[t])];
    }
    const double whole = measure(scene.draws[draw.draw], draw.draw, areas[0], run);
    const auto share = [&](ShellKind kind) {
      return whole > 0 ? 100 * areas[static_cast<std::size_t>(kind)] / whole : 0;
    };
    std::string text = fmt::format("{:.1f} % of its area is closed", share(ShellKind::closed));
    for (const auto& [kind, word] : words) {
      const std::size_t count = counts[static_cast<std::size_t>(kind)];
      if (count > 0) text += fmt::format("; {} triangles ({:.1f} %) are {}", count, share(kind), word);
    }
    const std::size_t apart = scene.draws[draw.draw].full().stream().triangle_count() - draw.kinds.size();
    if (apart > 0) text += fmt::format("; {} triangles belong to another range and stay there", apart);
    run.note_at({.draw = draw.draw}, "closed", text);
  }

  SecondDepthOptions options_;
};

}  // namespace

Plugin second_depth_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "second-depth",
      .summary =
          "Puts closed shells first in their draws, so that engines know what to draw for second-depth anti-aliasing",
      .reference = "Persson 2012, Second-Depth Anti-Aliasing",
      .acts_on = {traits::triangles},
      .breaks = {traits::cache_ordered, traits::overdraw_ordered, traits::clustered},
      .pays_if = "the engine smooths edges by second depth, and meshes have closed shells",
      .lossless = true,
      .metrics = {{"closed-area", "of area", "Area of closed shells that may be drawn without their front faces",
                   false}},
  };
  plugin.products = {second_depth_product()};
  OptionTable<SecondDepthOptions> table;
  table.row(&SecondDepthOptions::skinned, "skinned",
            "Take shells that follow joints, too: they stay closed, but a pose may fold them through themselves");
  bind_options(plugin, table,
               [](const SecondDepthOptions& options) { return std::make_unique<SecondDepthProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
