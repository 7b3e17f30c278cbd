#include "displacement_seams.h"

#include <foredraw/displaced/map_seams.h>
#include <foredraw/scene/displacement_stamp.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

struct Options {
  SeamMethod method = SeamMethod::exact;
  int iterations = 20;
  int bits = 14;
};

Image image_of(const RepairedMap& repaired, const HeightMap& heights, const Image& old) {
  const auto bytes = std::as_bytes(std::span(repaired.texels));
  Image image{.name = old.name, .bytes = Shared<std::byte>({bytes.begin(), bytes.end()})};
  image.is_texels = true;
  image.facts = {heights.width, heights.height, 1, 16};
  return image;
}

/// The same surface by heights of another range; nullopt where floats do not hold it.
std::optional<Displacement> of_range(Displacement displacement, const RepairedMap& repaired) {
  const double factor = displacement.factor, offset = displacement.offset;
  if (repaired.at_zero != 0 || repaired.at_one != 1) {
    displacement.factor = static_cast<float>(factor * (repaired.at_one - repaired.at_zero));
    displacement.offset = static_cast<float>(offset + factor * repaired.at_zero);
  }
  if (!std::isfinite(displacement.factor) || !std::isfinite(displacement.offset)) return std::nullopt;
  return displacement;
}

class DisplacementSeams final : public Processor {
 public:
  explicit DisplacementSeams(Options options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const SceneSeams found = seams_of_maps(scene, draws, run.analyses);
    for (const auto& [draw, why] : found.left_out) run.note_at({.draw = draw}, "not-repaired", "not repaired: " + why);
    std::size_t edges = 0;
    for (const MapSeams& of : found.maps) edges += of.seams.seams;
    if (edges == 0) {
      run.keep("0 seam edges: the layout of no displaced draw has seams");
      return {};
    }
    std::vector<RepairedMap> repaired(found.maps.size());
    run.executor.for_each(found.maps.size(), [&](std::size_t i) {
      const MapSeams& of = found.maps[i];
      if (run.cancelled()) return;
      repaired[i] = displacement_seams(
          of.seams, of.sampled(), {options_.method, options_.iterations, static_cast<std::uint32_t>(options_.bits)});
    });
    if (run.cancelled()) return {};
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < repaired.size(); ++i) {
      const MapSeams& of = found.maps[i];
      tell(of, repaired[i], run);
      if (repaired[i].texels.empty()) continue;
      if (!put(scene, of, repaired[i], run)) continue;
      changed.insert(changed.end(), of.draws.begin(), of.draws.end());
    }
    if (changed.empty()) run.keep("no map can be improved: the sides of its seams are already as equal as they can be");
    std::ranges::sort(changed);
    return changed;
  }

 private:
  static void tell(const MapSeams& of, const RepairedMap& repaired, const Run& run) {
    std::size_t below = 0;
    for (std::size_t e = 0; e < repaired.rule.size(); ++e) below += repaired.factors[e] < repaired.rule[e] ? 1 : 0;
    const About about{.draw = of.draws.front()};
    run.count_at(about, "edges", static_cast<double>(of.seams.seams));
    run.count_at(about, "unequal", static_cast<double>(repaired.unequal_after));
    run.count_at(about, "texels", repaired.texels.empty() ? 0 : static_cast<double>(repaired.seam_texels.size()));
    run.note_at(
        about, "seams",
        fmt::format("{} seam edges; of {} points on them {} were unequal before, and {} are now; {} texels changed{}",
                    of.seams.seams, repaired.points, repaired.unequal_before, repaired.unequal_after,
                    repaired.texels.empty() ? 0 : repaired.seam_texels.size(),
                    below == 0
                        ? ""
                        : fmt::format("; {} edges are equal only at lower factors than their texels allow", below)));
    if (of.seams.left_out > 0) {
      run.note_at(
          about, "triangles-left-out",
          fmt::format("{} triangles have two corners at one point, or numbers that are not finite", of.seams.left_out));
    }
  }

  /// Whether the new map could be given to the materials.
  static bool put(Scene& scene, const MapSeams& of, const RepairedMap& repaired, const Run& run) {
    std::map<MaterialId, std::vector<DrawId>> by_material;
    for (const DrawId id : of.draws) {
      const MaterialId material = *scene.draws[id].material;
      if (!of_range(*scene.materials[material].displacement, repaired)) {
        run.note_at({.draw = id}, "not-repaired", "not repaired: its factor or offset would be infinite");
        return false;
      }
      by_material[material].push_back(id);
    }
    const auto image = static_cast<ImageId>(scene.images.size());
    scene.images.push_back(image_of(repaired, *of.heights, scene.images[of.image]));
    for (const auto& [material, draws] : by_material) {
      Material& own = scene.materials[own_material(scene, material, draws)];
      own.displacement = of_range(*own.displacement, repaired);
      own.displacement->texture.image = image;
      for (std::optional<Stamp>* stamp : {&own.look, &own.kind}) {  // alike are those that were, and are moved alike
        if (*stamp) *stamp = combine(std::array{**stamp, stamp_of(*own.displacement)});
      }
    }
    if (repaired.at_zero != 0 || repaired.at_one != 1) {
      run.note_at(
          {.draw = of.draws.front()}, "new-range",
          fmt::format("heights reach from {:.4f} to {:.4f} of the old range: all texels are scaled, and factor and "
                      "offset of the materials adjusted",
                      repaired.at_zero, repaired.at_one));
    }
    return true;
  }

  Options options_;
};

}  // namespace

Plugin displacement_seams_plugin() {
  OptionTable<Options> table;
  table.choice(&Options::method, "method",
               "exact: equal whole numbers at the points of a tessellation; average: the paper's way, which averages "
               "texels that meet, again and again",
               {{"exact", SeamMethod::exact}, {"average", SeamMethod::average}});
  table.row(&Options::iterations, "iterations", "How often the paper's method goes over all seams", {1, 1000, ""});
  table.row(&Options::bits, "bits", "How many bits of the heights have to agree on both sides", {1, 16, "bits"});

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "displacement-seams",
      .summary = "Makes the heights of a displacement map equal on both sides of every seam of its layout",
      .reference = "own; the averaging is that of Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::displaced},
      .pays_if = "the layout of the map has seams, and heights differ across them",
      .measured_by = {"seam-gap"},
  };
  bind_options(plugin, table, [](const Options& options) { return std::make_unique<DisplacementSeams>(options); });
  return plugin;
}

}  // namespace foredraw
