#include "displacement.h"
#include "storable_map.h"

#include <foredraw/technique/plugin.h>
#include <foredraw/viewing/self_crossings.h>

#include <fmt/format.h>

#include <filesystem>

namespace foredraw {

namespace {

struct Options {
  ImagePath map;
  std::optional<float> factor;
  std::optional<float> offset;
  std::optional<int> uv;
};

class DisplacementProcessor final : public Processor {
 public:
  explicit DisplacementProcessor(Options options) : options_(std::move(options)) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    GivenDisplacement given{{}, options_.factor, options_.offset, {}};
    if (options_.uv) given.texcoord = static_cast<std::uint32_t>(*options_.uv);
    Scene changed = scene;
    if (!options_.map.path.empty()) {
      auto found = storable_map(run.image(options_.map), run.analyses);
      if (const std::string* why = std::get_if<std::string>(&found)) {
        run.keep("the map " + *why);
        return {};
      }
      StorableMap& map = std::get<StorableMap>(found);
      tell(map, run);
      map.image.name = std::filesystem::path(options_.map.path).stem().string();
      given.map = static_cast<ImageId>(scene.images.size());
      changed.images.push_back(std::move(map.image));
    }
    const DisplacementAnswer answer = displace(changed, draws, given);
    for (const auto& [draw, why] : answer.why_not)
      run.note_at({.draw = draw}, "not-displaced", "not displaced: " + why);
    if (answer.displaced.empty()) {
      run.keep("no draw can be displaced");
      return {};
    }
    if (answer.factor) {
      run.note("factor", fmt::format("no factor is given: a height of 1 moves the surface by {:.4g} units, 2 % of the "
                                     "diagonal",
                                     *answer.factor));
    }
    for (const DrawId draw : answer.displaced) {
      const std::string note = note_of(self_crossings(changed, draw, run.analyses, run.executor, run.cancel));
      if (!note.empty()) run.note_at({.draw = draw}, "passes-through-itself", note);
    }
    scene = std::move(changed);
    return answer.displaced;
  }

 private:
  static void tell(const StorableMap& map, const Run& run) {
    if (map.is_converted)
      run.note("map-converted", "the map becomes a PNG of 16 bits, since glTF holds PNG and JPEG alone");
    if (map.outside > 0) {
      run.note("heights-cut-off", fmt::format("{} texels of the map are not numbers from 0 to 1, and are clamped; "
                                              "scale the map to 0 to 1, and give `factor` and `offset`",
                                              map.outside));
    }
  }

  Options options_;
};

}  // namespace

Plugin displacement_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "displacement",
      .summary = "Gives draws a map of heights, or changes how far their own map moves the surface",
      .reference = "KHR_materials_displacement",
      .acts_on = {traits::triangles, traits::uv0},
      .provides = {traits::displaced},
      .pays_if = "the model comes with a map that its file does not name",
  };
  OptionTable<Options> table;
  table.row(&Options::map, "map", "Image with the heights in its first channel; without it, each material's own stays");
  table.row(&Options::factor, "factor",
            "How far a height of 1 moves the surface; without it, as the material says, or 2 % of the diagonal",
            {-1e30, 1e30, "units"});
  table.row(&Options::offset, "offset", "How far every point moves besides; without it, as the material says, or 0",
            {-1e30, 1e30, "units"});
  table.row(&Options::uv, "uv",
            "Number of the texture coordinates that place the map; without it, the material's, or 0", {0, 15});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<DisplacementProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
