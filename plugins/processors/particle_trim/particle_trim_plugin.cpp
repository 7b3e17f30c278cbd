#include "sprite_quads.h"

#include <foredraw/technique/alpha_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <stdexcept>

namespace foredraw {

namespace {

using trim::ShownImage;
using trim::SpriteQuad;

/// A draw whose quads can be trimmed.
struct SpriteDraw {
  DrawId id = 0;
  const Texture* texture = nullptr;
  std::shared_ptr<const AlphaImage> image;
  std::vector<SpriteQuad> quads;
  std::vector<TrimmedSprite> sprites;  ///< [quad]
};

/// Frames of one image that get polygons of one shape, and the quads that show them.
struct Job {
  const ShownImage* image = nullptr;
  std::vector<TrimFrame> frames;
  std::vector<std::vector<TrimmedSprite*>> shown_by;  ///< [frame]
};

std::string_view text(TrimmedSprite::Outcome outcome) {
  using Outcome = TrimmedSprite::Outcome;
  switch (outcome) {
    case Outcome::rectangle: return "trimmed to an upright rectangle: every polygon of so few vertices is larger, or covers what shows beside it";
    case Outcome::empty: return "nothing of it shows, so it stays as it is; it need not be drawn at all";
    case Outcome::full: return "all of it shows: there is nothing to trim";
    case Outcome::no_saving: return "trimming saves too little (least-saving), so it stays as it is";
    default: return "";
  }
}

std::string_view code(TrimmedSprite::Outcome outcome) {
  using Outcome = TrimmedSprite::Outcome;
  switch (outcome) {
    case Outcome::rectangle: return "rectangle";
    case Outcome::empty: return "empty";
    case Outcome::full: return "full";
    case Outcome::no_saving: return "no-saving";
    default: return "";
  }
}

class ParticleTrim final : public Processor {
 public:
  explicit ParticleTrim(ParticleTrimOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) override {
    std::vector<SpriteDraw> sprites = sprites_of(scene, draws, run);
    trim_all(sprites, run);
    std::vector<DrawId> trimmed;
    for (const SpriteDraw& sprite : sprites) {
      tell(sprite, run);
      const bool any = std::ranges::any_of(sprite.sprites, [](const TrimmedSprite& quad) { return !quad.corners.empty(); });
      if (!any) continue;
      Draw& draw = scene.draws[sprite.id];
      draw = with_polygons(draw, sprite.quads, sprite.sprites, *sprite.texture, *sprite.image, options_);
      trimmed.push_back(sprite.id);
    }
    if (trimmed.empty()) run.keep("no sprite has empty corners worth trimming");
    return trimmed;
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
        left.emplace_back(id, "it has no image");
        continue;
      }
      const Texture& texture = *material->base_colour;
      auto image = alpha_image_of(run.analyses, scene.images[*texture.image], options_.channel);
      if (const std::string* why = std::get_if<std::string>(&image)) {
        left.emplace_back(id, *why);
        continue;
      }
      SpriteDraw sprite{id, &texture, std::get<std::shared_ptr<const AlphaImage>>(image), {}, {}};
      auto quads = trim::sprite_quads(scene.draws[id], texture, *sprite.image);
      if (const std::string* why = std::get_if<std::string>(&quads)) {
        run.note_at({id}, "left-alone", *why);
        continue;
      }
      sprite.quads = std::move(std::get<std::vector<SpriteQuad>>(quads));
      sprite.sprites.resize(sprite.quads.size());
      sprites.push_back(std::move(sprite));
    }
    if (sprites.empty() && !left.empty()) throw std::runtime_error(left.front().second);
    for (const auto& [id, why] : left) run.note_at({id}, "left-alone", why);
    return sprites;
  }

  /// Every frame once, however many quads show it.
  void trim_all(std::vector<SpriteDraw>& sprites, Run& run) const {
    using ImageKey = std::tuple<const AlphaImage*, Wrap, Wrap, bool>;
    std::map<ImageKey, std::unique_ptr<const ShownImage>> images;
    std::vector<Job> jobs;
    std::map<std::tuple<const ShownImage*, std::int64_t, std::int64_t, std::int64_t, std::int64_t>, std::pair<std::size_t, std::size_t>> places;
    std::map<std::tuple<const ShownImage*, std::int64_t, std::int64_t>, std::size_t> sizes;
    for (SpriteDraw& sprite : sprites) {
      const Sampling sampling{sprite.texture->wrap, sprite.texture->is_nearest};
      auto& image = images[{sprite.image.get(), sampling.wrap[0], sampling.wrap[1], sampling.is_nearest}];
      if (!image) {
        image.reset(new ShownImage(*sprite.image, sampling,
                                   {options_.threshold, options_.footprint, options_.mip_levels, options_.padding}));
      }
      for (std::size_t q = 0; q < sprite.quads.size(); ++q) {
        const TrimFrame& frame = sprite.quads[q].frame;
        const trim::Point size = frame.most - frame.least;
        const auto [place, is_new] = places.try_emplace({image.get(), frame.least.x, frame.least.y, frame.most.x, frame.most.y});
        if (is_new) {
          const auto [job, is_first] = sizes.try_emplace({image.get(), size.x, size.y}, jobs.size());
          if (is_first || !options_.shared) {
            job->second = jobs.size();
            jobs.push_back({image.get(), {}, {}});
          }
          place->second = {job->second, jobs[job->second].frames.size()};
          jobs[job->second].frames.push_back(frame);
          jobs[job->second].shown_by.emplace_back();
        }
        jobs[place->second.first].shown_by[place->second.second].push_back(&sprite.sprites[q]);
      }
    }
    std::atomic<std::size_t> finished = 0;
    run.executor.for_each(jobs.size(), [&](std::size_t i) {
      const std::vector<TrimmedSprite> made = particle_trim(*jobs[i].image, jobs[i].frames, options_);
      for (std::size_t f = 0; f < made.size(); ++f) {
        for (TrimmedSprite* sprite : jobs[i].shown_by[f]) *sprite = made[f];
      }
      if (run.progress) run.progress(static_cast<double>(++finished) / static_cast<double>(jobs.size()));
    });
  }

  static void tell(const SpriteDraw& draw, Run& run) {
    const Place place{.draw = draw.id};
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
    run.measure_at(place, "area", area, frame_area);
    run.measure_at(place, "alpha-lost", lost, 1);
    run.count_at(place, "texels", static_cast<double>(texels));
    for (const auto& [outcome, count] : outcomes) {
      if (outcome == TrimmedSprite::Outcome::trimmed) continue;
      const std::string of = draw.sprites.size() == 1 ? "" : fmt::format("{} of {} quads: ", count, draw.sprites.size());
      run.note_at(place, std::string(code(outcome)), of + std::string(text(outcome)));
    }
  }

  ParticleTrimOptions options_;
};

}  // namespace

Plugin particle_trim_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "particle-trim",
      .summary = "Draws sprites as tight polygons in place of quads, proven to hide nothing that shows",
      .reference = "Persson 2012, Graphics Gems for Games, Particle trimming; DePano 1987",
      .acts_on = {traits::triangles, traits::sprite},
      .provides = {traits::trimmed},
      .breaks = {traits::clustered, traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered},
      .pays_if = "a sprite has empty corners",
      .metrics = {{"area", "of the frame", "What is drawn of each frame, of its area; 1: the whole quad"},
                  {"alpha-lost", "alpha", "Largest value that may show outside of the polygon, 0 to 1; at most the threshold", true, true},
                  {"texels", "texels", "Texels that were checked: all that show are drawn", false}},
  };
  OptionTable<ParticleTrimOptions> table;
  table.row(&ParticleTrimOptions::vertices, "vertices", "Most vertices of a polygon", {3, 16, "vertices"})
      .choice(&ParticleTrimOptions::method, "method", "The smallest of all polygons, or Persson's search on a reduced hull",
              {{"optimal", TrimMethod::optimal}, {"persson", TrimMethod::persson}})
      .row(&ParticleTrimOptions::threshold, "threshold", "What is above it shows", {0, 1, ""});
  add_alpha_channel(table, &ParticleTrimOptions::channel);
  table
      .choice(&ParticleTrimOptions::footprint, "footprint",
              "How far a texel reaches: its square; all that blends with it; or where the blend is above the threshold",
              {{"texels", trim::Footprint::texels},
               {"bilinear-loose", trim::Footprint::bilinear_loose},
               {"bilinear", trim::Footprint::bilinear}})
      .row(&ParticleTrimOptions::mip_levels, "mip-levels", "Smaller versions of the image that may be sampled", {0, 14, "levels"})
      .row(&ParticleTrimOptions::padding, "padding", "More on each side", {0, 64, "texels"})
      .choice(&ParticleTrimOptions::uv, "uv", "Numbers that the polygon's texture coordinates are rounded to",
              {{"float32", trim::UvFormat::float32}, {"float16", trim::UvFormat::float16}, {"unorm16", trim::UvFormat::unorm16}})
      .choice(&ParticleTrimOptions::winding, "winding", "How polygons run as seen in the image; kept: as the quads do",
              {{"kept", TrimWinding::as_before},
               {"clockwise", TrimWinding::clockwise},
               {"counter-clockwise", TrimWinding::counter_clockwise}})
      .row(&ParticleTrimOptions::shared, "shared", "One polygon for all frames of an image that are of one size")
      .row(&ParticleTrimOptions::least_saving, "least-saving", "Sprites that save less stay as they are", {0, 1, "of the frame"})
      .row(&ParticleTrimOptions::hull_edges, "hull-edges", "Of method persson: to so many the hull is reduced first", {3, 32, "edges"});
  bind_options(plugin, table, [](const ParticleTrimOptions& options) { return std::make_unique<ParticleTrim>(options); });
  return plugin;
}

}  // namespace foredraw
