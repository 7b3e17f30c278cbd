#include "tessellate.h"

#include <foredraw/displaced/level_counts.h>
#include <foredraw/displaced/scaled_levels.h>
#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/displaced/stored_levels.h>
#include <foredraw/scene/displacement_stamp.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <variant>

namespace foredraw {

namespace {

struct Options {
  std::optional<float> parts;
  std::optional<double> texels;
  TessellationSpacing spacing = TessellationSpacing::equal;
  int most = 4'000'000;
};

class Tessellate final : public Processor {
 public:
  explicit Tessellate(Options options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<std::string> why_not(draws.size());
    std::vector<std::optional<Draw>> made(draws.size());
    run.executor.for_each(draws.size(), [&](std::size_t i) {
      if (!run.cancelled()) made[i] = tessellated(scene, draws[i], run.analyses, why_not[i]);
    });
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < draws.size(); ++i) {
      const About about{.draw = draws[i]};
      if (!made[i]) {
        run.note_at(about, "not-tessellated", "not tessellated: " + why_not[i]);
        continue;
      }
      run.count_at(about, "triangles", static_cast<double>(made[i]->full().stream().triangle_count()));
      scene.draws[draws[i]] = std::move(*made[i]);
      changed.push_back(draws[i]);
    }
    if (changed.empty()) run.keep("no draw can be tessellated");
    take_displacement(scene, changed);
    take_heights(scene, changed);
    return changed;
  }

 private:
  /// How a draw is divided, and by how much its points move.
  struct Divided {
    TessellatedMesh mesh;
    std::vector<float> displacements;
    std::vector<std::uint32_t> source;  ///< [triangle of the mesh] that of the draw
  };

  std::string too_many(std::span<const TessellationLevels> levels, TessellationSpacing spacing) const {
    const std::uint64_t triangles = count_triangles(levels, spacing);
    if (triangles <= static_cast<std::uint64_t>(options_.most)) return {};
    return fmt::format(
        "{} triangles would come out, more than the limit of {}; give a larger `texels`, a lower "
        "`parts` or a higher `most`",
        triangles, options_.most);
  }

  /// As the options say, or else those that a stage chose, or as fine as the map.
  std::vector<TessellationLevels> levels_of(const Level& level, std::span<const std::array<std::int32_t, 2>> places,
                                            const DrawTessellation* chosen) const {
    const auto indices = level.stream().indices.view();
    if (options_.parts) {
      const float parts = *options_.parts;
      return std::vector<TessellationLevels>(indices.size() / 3, {{parts, parts, parts}, parts});
    }
    if (chosen != nullptr && !options_.texels) return scaled_levels(*chosen, 0);
    return levels_by_texels(indices, decode_vec3(*level.vertices->find("POSITION")), places,
                            options_.texels.value_or(usual_texels_per_part));
  }

  std::variant<Divided, std::string> divided_by_map(const Scene& scene, DrawId id, Analyses& analyses) const {
    const auto map = laid_out_map(scene, id, analyses);
    if (const std::string* why = std::get_if<std::string>(&map)) return *why;
    const LaidOutMap& on_draw = std::get<LaidOutMap>(map);
    const Level& level = scene.draws[id].full();
    const auto indices = level.stream().indices.view();
    const std::vector<TessellationLevels> levels = levels_of(level, on_draw.places, tessellation_of(scene, id));
    if (std::string why = too_many(levels, options_.spacing); !why.empty()) return why;
    Divided divided{tessellated_mesh(indices, level.vertices->count, levels, options_.spacing),
                    {},
                    sources_of(levels, options_.spacing)};
    divided.displacements = displacements(divided.mesh, indices, on_draw.places, on_draw.sampled(),
                                          on_draw.displacement.factor, on_draw.displacement.offset);
    return divided;
  }

  std::variant<Divided, std::string> divided_by_heights(const DrawHeights& heights, const Level& level) const {
    const auto levels = baked_levels(heights.levels.view(), level.stream().indices.view(),
                                     decode_vec3(*level.vertices->find("POSITION")));
    if (std::string why = too_many(levels, TessellationSpacing::equal); !why.empty()) return why;
    return Divided{tessellated_mesh(heights, level),
                   height_displacements(heights.heights.view(), heights.bits, heights.factor, heights.offset),
                   sources_of(levels, TessellationSpacing::equal)};
  }

  std::optional<Draw> tessellated(const Scene& scene, DrawId id, Analyses& analyses, std::string& why_not) const {
    const Draw& draw = scene.draws[id];
    const auto refuse = [&](std::string why) {
      why_not = std::move(why);
      return std::nullopt;
    };
    if (draw.levels.size() > 1) return refuse("it has several levels of detail");
    if (draw.full().orders.size() > 1) return refuse("it has several orders");
    const DrawHeights* heights = heights_of(scene, id);
    auto made = heights != nullptr ? divided_by_heights(*heights, draw.full()) : divided_by_map(scene, id, analyses);
    if (std::string* why = std::get_if<std::string>(&made)) return refuse(std::move(*why));
    Divided& divided = std::get<Divided>(made);
    const IndexStream& stream = draw.full().stream();
    const Material* material = scene.material_of(draw);
    Tessellated triangles =
        tessellate(*draw.full().vertices, stream.indices.view(), displacement_directions(scene, id, analyses),
                   divided.mesh, divided.displacements, material != nullptr && material->normal_map);
    Draw result = draw;
    const auto of_file = stream.triangle_origin.view();
    if (!of_file.empty()) {
      for (std::uint32_t& source : divided.source) source = of_file[source];
    }
    result.full().vertices = std::make_shared<const VertexStreams>(std::move(triangles.vertices));
    result.full().stream() = {};
    result.full().stream().indices = Shared(std::move(triangles.indices));
    result.full().stream().triangle_origin = Shared(std::move(divided.source));
    result.traits.remove(traits::displaced);
    result.traits.remove(traits::quantized);
    return result;
  }

  /// What is moved for good is not moved again.
  static void take_displacement(Scene& scene, const std::vector<DrawId>& draws) {
    std::map<MaterialId, std::vector<DrawId>> by_material;
    for (const DrawId draw : draws) {
      const Material* material = scene.material_of(scene.draws[draw]);
      if (material != nullptr && material->displacement) by_material[*scene.draws[draw].material].push_back(draw);
    }
    for (const auto& [material, users] : by_material) {
      Material& own = scene.materials[own_material(scene, material, users)];
      change_look(own, stamp_of(*own.displacement));
      own.displacement.reset();
    }
  }

  static void take_heights(Scene& scene, const std::vector<DrawId>& draws) {
    const BakedHeights* all = scene.products.find<BakedHeights>();
    if (all == nullptr) return;
    BakedHeights left = *all;
    std::erase_if(left.draws, [&](const DrawHeights& of) { return std::ranges::binary_search(draws, of.draw); });
    if (left.draws.empty()) {
      scene.products.erase(BakedHeights::product);
    } else {
      scene.products.set(std::move(left));
    }
  }

  Options options_;
};

}  // namespace

Plugin tessellate_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "tessellate",
      .summary = "Divides displaced triangles as a GPU's tessellator does, and moves the points by the map of heights",
      .reference = "Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::triangles, traits::displaced},
      .breaks = {traits::displaced, traits::quantized, traits::welded, traits::clustered, traits::cache_ordered,
                 traits::overdraw_ordered, traits::fetch_ordered, traits::progressive},
      .pays_if = "an engine or tool shows the surface and has no tessellation",
      .metrics = {{"triangles", "triangles", "Triangles that came out", false}},
  };
  OptionTable<Options> table;
  table.row(&Options::parts, "parts",
            "Parts of every edge, a tessellator's level; without it and `texels`, the levels that "
            "`tessellation-levels` stored",
            {1, 64});
  table.row(&Options::texels, "texels", "Least texels of the map along a part of an edge; without any levels, 1.5",
            {0.5, 65536, "texels"});
  table.choice(&Options::spacing, "spacing", "How the points on an edge are spaced, in the words of shaders",
               {{"equal", TessellationSpacing::equal},
                {"fractional-odd", TessellationSpacing::fractional_odd},
                {"fractional-even", TessellationSpacing::fractional_even}});
  table.row(&Options::most, "most", "Most triangles that a draw may have afterwards", {1, 100'000'000, "triangles"});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<Tessellate>(options); });
  return plugin;
}

}  // namespace foredraw
