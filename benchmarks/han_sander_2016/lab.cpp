#include "lab.h"

#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/parse.h>
#include <foredraw/technique/built_in_plugins.h>
#include <foredraw/viewing/view_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace {

ViewSet held_out() { return {.views = "random", .count = 300, .seed = 2016, .distance = 3, .size = 256}; }

std::string one_line(std::string text) {
  std::ranges::replace(text, '\n', ' ');  // inline tables end with their line
  return text;
}

}  // namespace

Views held_out_views() { return make_views(held_out()); }

Lab::Lab() : executor_(2), analyses_(image_decoder({})) {
  Registry all;
  add_built_in_plugins(all);
  for (const Plugin* plugin : all.all()) {
    Plugin ours = *plugin;
    // The paper's characters are one skin each; of ours some are put together from rigid pieces, which are ordered
    // too.
    if (ours.card.name == "animated-kmeans") ours.card.acts_on = {traits::triangles};
    registry_.add(std::move(ours));
  }
}

Result Lab::run(const Scene& scene, const std::string& stages, int keyframes) {
  return optimize(planned(scene, stages, keyframes, ""), scene, {executor_, analyses_});
}

Figures Lab::measured(const Scene& scene, const std::string& motion, int keyframes) {
  const ViewSet views = held_out();
  const std::string measures = fmt::format(
      R"({{ use = "vertex-cache", cache-size = {} }}, {{ use = "overdraw-raster", views = "{}", count = {}, seed = {},
distance = {}, size = {}, faces = "front", poses = {}, clips = '{}' }})",
      cache_size, views.views, *views.count, views.seed, *views.distance, views.size, keyframes, motion);
  const Report report =
      foredraw::measure(planned(scene, "", keyframes, measures), scene, {executor_, analyses_}).report;
  return {report.after.metrics.find("vertex-cache", "acmr")->value(),
          report.after.metrics.find("overdraw-raster", "ratio")->value()};
}

Plan Lab::planned(const Scene& scene, const std::string& stages, int keyframes, const std::string& measures) {
  const std::string text = fmt::format(R"(pipeline = 1
stages = [{}]
measure = [{}]
services = {{ overdraw = {{ use = "overdraw-raster", faces = "front" }} }}
[views]
views = "icosphere"
count = 162
rotation = 1
size = 128
[poses]
poses = {}
)",
                                       one_line(stages), one_line(measures), keyframes);
  Diagnostics diagnostics;
  const auto pipeline = parse_file(text, "experiment", diagnostics);
  auto plan = pipeline ? foredraw::plan(*pipeline, registry_, scene, diagnostics) : std::nullopt;
  if (!plan) throw std::runtime_error(to_text(diagnostics));
  return std::move(*plan);
}

}  // namespace foredraw::bench
