#include "footprint.h"
#include "sprite_quads.h"

#include <foredraw/measuring/alpha_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <stdexcept>
#include <tuple>

namespace foredraw {

namespace {

using processors::particle_trim::ShownImage;
using processors::particle_trim::SpriteQuad;

/// A draw whose quads can be trimmed.
struct SpriteDraw {
  DrawId id = 0;
  const Texture* texture = nullptr;
  std::shared_ptr<const AlphaImage> image;
  std::vector<SpriteQuad> quads;
  std::vector<TrimmedSprite> sprites;  ///< [quad]

  Sampling sampling() const { return {texture->wrap, texture->is_nearest}; }
};

/// What a quad shows, and where its polygon goes.
struct ShownQuad {
  std::size_t image = 0;  ///< among those that are drawn
  TrimFrame frame;
  TrimmedSprite* sprite = nullptr;

  processors::particle_trim::Point size() const { return frame.most - frame.least; }
};

struct Told {
  std::string code, text;
};

Told told(TrimmedSprite::Outcome outcome) {
  using Outcome = TrimmedSprite::Outcome;
  switch (outcome) {
    case Outcome::rectangle:
      return {"rectangle",
              "trimmed to an upright rectangle: any other polygon of so few vertices is larger, or covers something "
              "visible beside the frame"};
    case Outcome::empty:
      return {"empty", "nothing of it shows, so it stays as it is; it need not be drawn at all (option threshold)"};
    case Outcome::full:
      return {"full",
              "all of it shows, so there is nothing to trim; for a sprite that is blended additively set channel = "
              "\"luminance\""};
    case Outcome::no_saving: return {"no-saving", "trimming would save less than least-saving, so it stays as it is"};
    default: return {};
  }
}

struct Options : ParticleTrimOptions {
  bool shared = false;  // one polygon for all frames of an image that are of one size
};

class ParticleTrimProcessor final : public Processor {
 public:
  explicit ParticleTrimProcessor(Options options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<SpriteDraw> sprites = sprites_of(scene, draws, run);
    trim_all(sprites, run);
    std::vector<DrawId> as_tight_as_can_be;
    bool any = false;
    for (const SpriteDraw& sprite : sprites) {
      tell(sprite, run);
      as_tight_as_can_be.push_back(sprite.id);
      const auto is_trimmed = [](const TrimmedSprite& quad) { return !quad.corners.empty(); };
      if (std::ranges::none_of(sprite.sprites, is_trimmed)) continue;
      any = true;
      Draw& draw = scene.draws[sprite.id];
      draw = with_polygons(draw, sprite.quads, sprite.sprites, *sprite.texture, *sprite.image, options_);
    }
    if (draws.empty()) {
      run.keep("there is no sprite to trim");
    } else if (!any) {
      run.keep(sprites.empty() ? "no sprite can be trimmed; the notes say why"
                               : "no sprite has empty corners worth trimming; the notes say more");
    }
    return as_tight_as_can_be;
  }

 private:
  std::vector<SpriteDraw> sprites_of(const Scene& scene, const std::vector<DrawId>& draws, Run& run) const {
    std::vector<SpriteDraw> sprites;
    std::vector<std::pair<DrawId, std::string>> left;
    for (const DrawId id : draws) {
      const Material* material = scene.material_of(scene.draws[id]);
      const bool has_image = material != nullptr && material->base_colour && material->base_colour->image &&
                             *material->base_colour->image < scene.images.size();
      if (!has_image) {
        left.emplace_back(id, "its material has no image");
        continue;
      }
      const Texture& texture = *material->base_colour;
      auto image = alpha_image_of(run.analyses, scene.images[*texture.image], options_.channel);
      if (const std::string* why = std::get_if<std::string>(&image)) {
        left.emplace_back(id, *why);
        continue;
      }
      SpriteDraw sprite{id, &texture, std::get<std::shared_ptr<const AlphaImage>>(image), {}, {}};
      auto quads = processors::particle_trim::sprite_quads(scene.draws[id], texture, *sprite.image);
      if (const std::string* why = std::get_if<std::string>(&quads)) {
        run.note_at({id}, "left-alone", "not trimmed: " + *why);
        continue;
      }
      sprite.quads = std::move(std::get<std::vector<SpriteQuad>>(quads));
      sprite.sprites.resize(sprite.quads.size());
      sprites.push_back(std::move(sprite));
    }
    if (sprites.empty() && !left.empty())
      throw std::runtime_error(scene.draws[left.front().first].name + ": " + left.front().second);
    for (const auto& [id, why] : left) run.note_at({id}, "left-alone", "not trimmed: " + why);
    return sprites;
  }

  void trim_all(std::vector<SpriteDraw>& sprites, Run& run) const {
    using Drawn = std::tuple<const AlphaImage*, Wrap, Wrap, bool>;
    std::map<Drawn, std::size_t> numbers;
    std::vector<std::unique_ptr<const ShownImage>> images;
    std::vector<ShownQuad> quads;
    for (SpriteDraw& sprite : sprites) {
      const Sampling sampling = sprite.sampling();
      const auto [number, is_new] = numbers.try_emplace(
          {sprite.image.get(), sampling.wrap[0], sampling.wrap[1], sampling.is_nearest}, images.size());
      if (is_new)
        images.emplace_back(new ShownImage(*sprite.image, sampling, processors::particle_trim::footprint_of(options_)));
      for (std::size_t q = 0; q < sprite.quads.size(); ++q) {
        quads.push_back({number->second, sprite.quads[q].frame, &sprite.sprites[q]});
      }
    }
    // Those that get one polygon stand together: of equal frames, or of frames that share their shape.
    const auto key = [](const ShownQuad& quad) { return std::tuple(quad.image, quad.size(), quad.frame.least); };
    std::ranges::sort(quads, {}, key);
    std::vector<std::span<ShownQuad>> jobs;
    for (std::size_t first = 0, last; first < quads.size(); first = last) {
      const auto is_alike = [&](const ShownQuad& quad) {
        return quad.image == quads[first].image && quad.size() == quads[first].size() &&
               (options_.shared || quad.frame.least == quads[first].frame.least);
      };
      for (last = first + 1; last < quads.size() && is_alike(quads[last]);) ++last;
      jobs.push_back(std::span(quads).subspan(first, last - first));
    }
    std::atomic<std::size_t> finished = 0;
    run.executor.for_each(jobs.size(), [&](std::size_t i) {
      trim_alike(*images[jobs[i].front().image], jobs[i]);
      if (run.progress) run.progress(static_cast<double>(++finished) / static_cast<double>(jobs.size()));
    });
  }

  /// Each frame once, however many quads show it.
  void trim_alike(const ShownImage& image, std::span<ShownQuad> quads) const {
    std::vector<TrimFrame> frames;
    for (const ShownQuad& quad : quads) {
      if (frames.empty() || frames.back().least != quad.frame.least) frames.push_back(quad.frame);
    }
    const std::vector<TrimmedSprite> made = particle_trim(image, frames, options_);
    std::size_t at = 0;
    for (const ShownQuad& quad : quads) {
      if (frames[at].least != quad.frame.least) ++at;
      *quad.sprite = made[at];
    }
  }

  static void tell(const SpriteDraw& draw, Run& run) {
    const About about{.draw = draw.id};
    double area = 0, frame_area = 0, lost = 0;
    std::uint64_t texels = 0;
    std::map<TrimmedSprite::Outcome, std::size_t> outcomes;
    for (const TrimmedSprite& sprite : draw.sprites) {
      area += sprite.area;
      frame_area += sprite.frame_area;
      lost = std::max(lost, sprite.lost);
      texels += sprite.texels;
      ++outcomes[sprite.outcome];
    }
    run.measure_at(about, "area", area, frame_area);
    run.measure_at(about, "alpha-lost", lost, 1);
    run.count_at(about, "texels", static_cast<double>(texels));
    for (const auto& [outcome, count] : outcomes) {
      if (outcome == TrimmedSprite::Outcome::trimmed) continue;
      const std::string of =
          draw.sprites.size() == 1 ? "" : fmt::format("{} of {} quads: ", count, draw.sprites.size());
      const bool is_full_without_alpha = outcome == TrimmedSprite::Outcome::full && draw.image->is_made_up;
      const auto [code, text] = is_full_without_alpha ? Told{NoAlpha::code, NoAlpha::text} : told(outcome);
      run.note_at(about, code, of + text);
    }
  }

  Options options_;
};

}  // namespace

Plugin particle_trim_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "particle-trim",
      .summary = "Trims sprite quads to tight polygons that fill fewer pixels, proven to cut off nothing that shows",
      .reference = "Persson 2012, Graphics Gems for Games, Particle trimming; DePano 1987",
      .acts_on = {traits::triangles, traits::sprite},
      .provides = {traits::trimmed},
      .breaks = {traits::clustered, traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered},
      .pays_if = "a sprite has empty corners",
      .measured_by = {"sprite-fill"},
      .metrics = {{"area", "of the frame", "Area that is drawn, as a share of the frame; 1: the whole quad"},
                  {"alpha-lost", "alpha", "Largest alpha that may be cut off, 0 to 1; never above the threshold", true,
                   true},
                  {"texels", "texels", "Texels checked by the proof", false}},
  };
  OptionTable<Options> table;
  table
      .row(&ParticleTrimOptions::vertices, "vertices",
           "Most vertices of a polygon; more fill fewer pixels and shade more vertices", {3, 16, "vertices"})
      .choice(&ParticleTrimOptions::method, "method",
              "optimal: the smallest polygon there is; persson: Persson's search on a reduced hull, for comparison",
              {{"optimal", TrimMethod::optimal}, {"persson", TrimMethod::persson}})
      .row(&ParticleTrimOptions::threshold, "threshold",
           "What has more alpha than this shows; higher trims more and may cut off faint edges", {0, 1, ""});
  add_alpha_channel(table, &ParticleTrimOptions::channel);
  table
      .choice(&ParticleTrimOptions::footprint, "footprint",
              "How far a visible texel reaches. texels: its square, for nearest filtering; bilinear-loose: all that "
              "blends with it; bilinear: where the blend is above the threshold",
              {{"texels", processors::particle_trim::Footprint::texels},
               {"bilinear-loose", processors::particle_trim::Footprint::bilinear_loose},
               {"bilinear", processors::particle_trim::Footprint::bilinear}})
      .row(&ParticleTrimOptions::mip_levels, "mip-levels",
           "How many smaller mip levels may be sampled; more make polygons larger, 0 is for images without mipmaps",
           {0, 14, "levels"})
      .row(&ParticleTrimOptions::padding, "padding", "Extra margin on each side, for wider filters", {0, 64, "texels"})
      .choice(&ParticleTrimOptions::uv, "uv", "Format of the texture coordinates, to which polygons are rounded",
              {{"float32", processors::particle_trim::UvFormat::float32},
               {"float16", processors::particle_trim::UvFormat::float16},
               {"unorm16", processors::particle_trim::UvFormat::unorm16}})
      .choice(&ParticleTrimOptions::winding, "winding",
              "Winding of the polygons as seen in the image; kept: that of the quads",
              {{"kept", TrimWinding::as_before},
               {"clockwise", TrimWinding::clockwise},
               {"counter-clockwise", TrimWinding::counter_clockwise}})
      .row(&Options::shared, "shared", "Use one polygon for all frames of the same size in an image, as for flipbooks")
      .row(&ParticleTrimOptions::least_saving, "least-saving",
           "Sprites that would save less than this stay as they are", {0, 1, "of the frame"})
      .row(&ParticleTrimOptions::hull_edges, "hull-edges",
           "With method persson: edges that the hull is reduced to first", {3, 32, "edges"});
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<ParticleTrimProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
