#include "sprite_fill.h"

#include <foredraw/image/texture_uv.h>
#include <foredraw/measuring/alpha_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <stdexcept>

namespace foredraw {

namespace {

/// What is kept of an image for all draws that show it.
struct KeptLevels {
  static constexpr std::string_view name = "sprite-fill.levels";
  AlphaLevels levels;

  /// The first one is kept with the image.
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (std::size_t i = 1; i < levels.size(); ++i) sum += levels[i]->alpha.size() * sizeof(std::uint16_t);
    return sum;
  }
};

class SpriteFillEvaluator final : public DrawEvaluator {
 public:
  explicit SpriteFillEvaluator(const SpriteFillOptions& options) : options_(options), looks_(sprite_looks(options)) {}

  void evaluate(const DrawView& draw, Run& run) const override {
    const Texture& texture = texture_of(draw);
    const std::string semantic = fmt::format("TEXCOORD_{}", texture.texcoord);
    const VertexStream* texcoords = draw.vertices().find(semantic);
    if (texcoords == nullptr || texcoords->count() < draw.vertex_count()) {
      throw std::runtime_error(fmt::format("it has no {}, which its material's texture needs", semantic));
    }
    const auto kept = levels_of(draw.scene.images[*texture.image], run);
    if (kept->levels.front()->is_made_up) run.note(NoAlpha::code, NoAlpha::text);
    const auto triangles = placed_triangles(texture_uv(*texcoords, texture), draw.indices());
    const Sampling sampling{texture.wrap, texture.is_nearest};

    std::vector<SpriteFill> fills(looks_.size());
    run.executor.for_each(looks_.size(), [&](std::size_t i) {
      if (!run.cancelled()) fills[i] = sprite_fill(triangles, kept->levels, sampling, looks_[i], options_);
    });
    if (run.cancelled()) throw std::runtime_error("cancelled");
    double filled = 0, needed = 0;
    for (const SpriteFill& fill : fills) {
      filled += static_cast<double>(fill.filled);
      needed += static_cast<double>(fill.needed);
    }
    run.count("filled", filled);
    run.count("needed", needed);
    run.measure("fill", filled, needed);
  }

 private:
  static const Texture& texture_of(const DrawView& draw) {
    const Material* material = draw.scene.material_of(draw.draw());
    if (material == nullptr || !material->base_colour) throw std::runtime_error("its material has no texture");
    const Texture& texture = *material->base_colour;
    if (!texture.image || *texture.image >= draw.scene.images.size()) {
      throw std::runtime_error("the format of its texture is not supported");
    }
    return texture;
  }

  /// Kept by the image, the channel and whether more than the first level is wanted.
  std::shared_ptr<const KeptLevels> levels_of(const Image& image, const Run& run) const {
    auto decoded = alpha_image_of(run.analyses, image, options_.channel);
    if (const std::string* why = std::get_if<std::string>(&decoded)) {
      throw std::runtime_error(fmt::format("its image cannot be read: {}", *why));
    }
    const char asked[] = {static_cast<char>(options_.channel), options_.mipmaps ? '\1' : '\0'};
    const Stamp parts[] = {image.bytes.stamp(), content_hash(std::span<const char>(image.uri)),
                           content_hash(std::span<const char>(asked))};
    return run.analyses.get<KeptLevels>(combine(parts), [&]() -> KeptLevels {
      auto& alpha = std::get<std::shared_ptr<const AlphaImage>>(decoded);
      if (!options_.mipmaps) return {{std::move(alpha)}};
      return {alpha_levels(std::move(alpha))};
    });
  }

  SpriteFillOptions options_;
  std::vector<SpriteLook> looks_;
};

}  // namespace

Plugin sprite_fill_plugin() {
  OptionTable<SpriteFillOptions> table;
  table.row(&SpriteFillOptions::scales, "scales",
            "Sizes at which sprites are drawn, in pixels per texel, separated by spaces; each above 0 and at most 16");
  table.row(&SpriteFillOptions::turns, "turns", "Number of rotations at each scale; the first is upright",
            {1, 64, "turns"});
  table.row(&SpriteFillOptions::threshold, "threshold", "A pixel shows if it has more alpha than this", {0, 1, ""});
  add_alpha_channel(table, &SpriteFillOptions::channel);
  table.row(&SpriteFillOptions::mipmaps, "mipmaps",
            "Sample mip levels where sprites are drawn smaller than their images");
  table.row(&SpriteFillOptions::seed, "seed", "Seed of the offsets, in parts of a pixel, at which sprites are drawn",
            {.least = 0});

  Plugin plugin;
  plugin.kind = Kind::evaluator;
  plugin.card = {
      .name = "sprite-fill",
      .summary = "Counts the pixels that sprites fill, and how many of them show anything",
      .reference = "Persson 2012 (particle trimming)",
      .acts_on = {traits::sprite},
      .metrics =
          {
              {"fill", "pixels filled per pixel that shows",
               "Pixels filled for each pixel that shows; 1 is the minimum"},
              {"filled", "pixels", "Pixels that triangles cover, summed over all scales and turns"},
              {"needed", "pixels",
               "Those of them that show; trimming must not change it, except for pixels on a frame's own edge", false},
          },
  };
  bind_options(plugin, std::move(table),
               [](const SpriteFillOptions& options) { return std::make_unique<SpriteFillEvaluator>(options); });
  return plugin;
}

}  // namespace foredraw
