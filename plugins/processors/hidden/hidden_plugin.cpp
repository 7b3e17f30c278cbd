#include "cut_draw.h"
#include "hidden.h"
#include "hidden_search.h"
#include "standing_parts.h"

#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

using processors::hidden::Moving;
using processors::hidden::SeenFrom;

struct Options : HiddenOptions {
  std::optional<SeenFrom> seen_from;
  std::string box;
  std::string points;
  Moving moving = Moving::apart;
};

/// The map from the unit cube to each place that cameras are in.
std::vector<glm::dmat4> boxes_of(const Options& options) {
  std::vector<glm::dmat4> boxes;
  const auto add = [&](const glm::dvec3& from, const glm::dvec3& to) {
    glm::dmat4 box(0);
    for (int axis = 0; axis < 3; ++axis) box[axis][axis] = to[axis] - from[axis];
    box[3] = glm::dvec4(from, 1);
    boxes.push_back(box);
  };
  if (options.seen_from == SeenFrom::box) {
    const auto corners = processors::hidden::points_in(options.box);
    if (!corners || corners->size() != 2) {
      throw std::invalid_argument(
          "seen-from = \"box\" needs two corners, in the space of the scene: box = \"x y z; x y z\"");
    }
    add(corners->front(), corners->back());
  }
  if (options.seen_from == SeenFrom::points) {
    const auto points = processors::hidden::points_in(options.points);
    if (!points) {
      throw std::invalid_argument(
          "seen-from = \"points\" needs points, in the space of the scene: points = \"x y z; x y z\"");
    }
    for (const glm::dvec3& point : *points) add(point, point);
  }
  return boxes;
}

processors::hidden::HiddenSearchOptions search_options(const Options& options) {
  if (!options.seen_from) {
    throw std::invalid_argument(
        "say where cameras may be: seen-from = \"outside\", \"above\", \"box\" or \"points\"; what they never see is "
        "removed");
  }
  processors::hidden::HiddenSearchOptions search;
  static_cast<HiddenOptions&>(search) = options;
  search.moving = options.moving;
  search.cameras = {*options.seen_from, boxes_of(options)};
  return search;
}

std::size_t count(const std::vector<std::uint8_t>& flags) {
  return static_cast<std::size_t>(std::ranges::count(flags, 1));
}

class HiddenProcessor final : public Processor {
 public:
  explicit HiddenProcessor(const Options& options) : options_(search_options(options)) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    if (!scene.products.empty()) {
      run.keep("the scene has products, which refer to triangles: put this stage before those that make them");
      return draws;
    }
    processors::hidden::HiddenSearchOptions search = options_;
    search.subjects = run.subjects;
    search.seed = run.seed;
    const std::vector<DrawId> asked = candidates(scene, draws, run);
    const auto between = [&run] {
      if (run.cancelled()) throw std::runtime_error("cancelled");
    };
    const processors::hidden::FoundHidden found =
        processors::hidden::find_hidden(scene, asked, search, between, run.executor);
    std::vector<DrawId> changed;
    for (const auto& [id, goes] : found.hidden) {
      if (count(goes) > 0) changed.push_back(id);
    }
    tell(scene, found, run);
    if (changed.empty()) run.keep("nothing is hidden, as far as pictures and rays can tell");
    for (const DrawId id : changed) processors::hidden::cut(scene.draws[id], found.hidden.at(id));
    return changed;
  }

 private:
  static std::vector<DrawId> candidates(const Scene& scene, const std::vector<DrawId>& draws, Run& run) {
    const std::vector<std::string> why = processors::hidden::why_they_stay(scene, run.subjects);
    std::vector<DrawId> result;
    for (const DrawId id : draws) {
      if (scene.draws[id].full().stream().indices.empty()) continue;
      if (why[id].empty()) {
        result.push_back(id);
      } else {
        run.note_at({id}, "stays-whole", "stays whole: " + why[id]);
      }
    }
    return result;
  }

  static void tell(const Scene& scene, const processors::hidden::FoundHidden& found, Run& run) {
    double triangles = 0, gone = 0;
    for (const Draw& draw : scene.draws) triangles += static_cast<double>(draw.full().stream().triangle_count());
    for (const auto& [id, goes] : found.hidden) {
      const std::size_t hidden = count(goes);
      gone += static_cast<double>(hidden);
      if (hidden == goes.size()) {
        run.note_at({id}, "all-hidden", "no camera sees any of it: one triangle without area keeps its place");
      } else if (hidden > 0) {
        run.note_at({id}, "part-hidden", fmt::format("no camera sees {} of its {} triangles", hidden, goes.size()));
      }
    }
    run.measure_at({}, "hidden", gone, triangles);
    run.measure_at({}, "proved", static_cast<double>(found.proved), triangles);
    run.count_at({}, "poses", static_cast<double>(found.poses));
    if (found.last_check.shown > 0) {
      run.measure_at({}, "contradicted", static_cast<double>(found.last_check.asked),
                     static_cast<double>(found.last_check.shown));
      run.count_at({}, "samples", static_cast<double>(found.last_check.shown));
    }
  }

  processors::hidden::HiddenSearchOptions options_;
};

}  // namespace

Plugin hidden_plugin() {
  OptionTable<Options> table;
  table
      .choice<std::optional<SeenFrom>>(
          &Options::seen_from, "seen-from",
          "Must be given. Where cameras may be. outside: anywhere outside; above: outside, and no lower than the "
          "subject's middle; box, points: inside 'box', or at 'points', and nowhere else",
          {{"outside", SeenFrom::outside},
           {"box", SeenFrom::box},
           {"points", SeenFrom::points},
           {"above", SeenFrom::above}})
      .row(&Options::box, "box", "With seen-from box: two corners of it in the space of the scene, as 'x y z; x y z'")
      .row(&Options::points, "points",
           "With seen-from points: where cameras are, in the space of the scene, as 'x y z; x y z; ...'")
      .choice(&HiddenOptions::unit, "unit",
              "What goes or stays as one. component: triangles that are connected, all together; triangle: single "
              "triangles, except two rings around what is seen",
              {{"component", processors::hidden::Unit::component}, {"triangle", processors::hidden::Unit::triangle}})
      .choice(&Options::moving, "moving",
              "What parts of a character may hide of each other. apart: only what follows one and the same joint, so "
              "that it holds in every pose; clips: what is hidden in all keys of all clips",
              {{"apart", Moving::apart}, {"clips", Moving::clips}})
      .row(&HiddenOptions::views, "views",
           "Pictures that decide what is seen; a quarter as many more are taken from nearby, with perspective",
           {1, 10000, "views"})
      .row(&HiddenOptions::size, "size", "Width and height of these pictures", {16, 4096, "pixels"})
      .row(&HiddenOptions::rays, "rays",
           "Rays cast from each triangle that no picture shows, shared out over the poses", {0, 65536, "rays"})
      .row(&HiddenOptions::checks, "checks",
           "Pictures, from views and in poses not used before, that the result is checked with",
           {1, 10000, "pictures"});

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "hidden",
      .summary = "Removes what cameras cannot see: parts inside others, by pictures and rays from where cameras are",
      .reference = "own",
      .acts_on = {traits::triangles},
      .breaks = {traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered, traits::clustered,
                 traits::welded},
      .pays_if = "something lies where no camera sees it",
      .metrics = {{"hidden", "per triangle", "Triangles removed, as no camera sees them", false},
                  {"proved", "per triangle", "Triangles removed that lie inside a closed part, by proof", false},
                  {"poses", "poses", "Poses that the subjects were looked at in", false, false, true},
                  {"contradicted", "per pixel checked",
                   "Pixels of the last check that showed something hidden, which was put back"},
                  {"samples", "pixels", "Pixels of the last check, from held-out views", false}},
  };
  bind_options(plugin, std::move(table),
               [](const Options& options) { return std::make_unique<HiddenProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
