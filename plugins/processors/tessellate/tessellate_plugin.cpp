#include "tessellate.h"

#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/scene/displacement_stamp.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <array>
#include <map>

namespace foredraw {

namespace {

struct Options {
  std::optional<float> parts;
  double texels = 1;
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
    return changed;
  }

 private:
  std::vector<TessellationLevels> levels_of(const DisplacedSurface& surface) const {
    if (options_.parts) {
      const float level = *options_.parts;
      return std::vector<TessellationLevels>(surface.indices.size() / 3, {{level, level, level}, level});
    }
    return levels_by_texels(surface.indices, decode_vec3(*surface.vertices.find("POSITION")), surface.places,
                            options_.texels);
  }

  std::optional<Draw> tessellated(const Scene& scene, DrawId id, Analyses& analyses, std::string& why_not) const {
    const Draw& draw = scene.draws[id];
    const Material& material = *scene.material_of(draw);
    const auto refuse = [&](std::string why) {
      why_not = std::move(why);
      return std::nullopt;
    };
    if (draw.levels.size() > 1) return refuse("it has several levels of detail");
    if (draw.full().orders.size() > 1) return refuse("it has several orders");
    const auto map = laid_out_map(scene, id, analyses);
    if (const std::string* why = std::get_if<std::string>(&map)) return refuse(*why);
    const LaidOutMap& laid_out = std::get<LaidOutMap>(map);
    const IndexStream& stream = draw.full().stream();
    const std::vector<glm::vec3> directions = displacement_directions(scene, id, analyses);
    const DisplacedSurface surface{
        *draw.full().vertices,        stream.indices.view(),       directions, laid_out.places, laid_out.sampled(),
        laid_out.displacement.factor, laid_out.displacement.offset};
    const std::vector<TessellationLevels> levels = levels_of(surface);
    std::size_t triangles = 0;
    for (const TessellationLevels& of : levels) triangles += tessellation_counts(of, options_.spacing).triangles;
    if (triangles > static_cast<std::size_t>(options_.most)) {
      return refuse(
          fmt::format("{} triangles would come out, more than the limit of {}; give a larger `texels`, a "
                      "lower `parts` or a higher `most`",
                      triangles, options_.most));
    }
    Tessellated made = tessellate(surface, levels, options_.spacing, material.normal_map.has_value());
    Draw result = draw;
    const auto of_file = stream.triangle_origin.view();
    if (!of_file.empty()) {
      for (std::uint32_t& source : made.source) source = of_file[source];
    }
    result.full().vertices = std::make_shared<const VertexStreams>(std::move(made.vertices));
    result.full().stream() = {};
    result.full().stream().indices = Shared(std::move(made.indices));
    result.full().stream().triangle_origin = Shared(std::move(made.source));
    result.traits.remove(traits::displaced);
    result.traits.remove(traits::quantized);
    return result;
  }

  /// What is moved for good is not moved again.
  static void take_displacement(Scene& scene, const std::vector<DrawId>& draws) {
    std::map<MaterialId, std::vector<DrawId>> by_material;
    for (const DrawId draw : draws) by_material[*scene.draws[draw].material].push_back(draw);
    for (const auto& [material, users] : by_material) {
      Material& own = scene.materials[own_material(scene, material, users)];
      for (std::optional<Stamp>* stamp : {&own.look, &own.kind}) {
        if (*stamp) *stamp = combine(std::array{**stamp, stamp_of(*own.displacement)});
      }
      own.displacement.reset();
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
  table.row(&Options::parts, "parts", "Parts of every edge, a tessellator's level; without it, as fine as the map",
            {1, 64});
  table.row(&Options::texels, "texels", "Least texels of the map along a part of an edge, where `parts` is not given",
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
