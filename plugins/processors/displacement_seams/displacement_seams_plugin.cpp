#include "displacement_seams.h"

#include "gutter.h"
#include "seam_heights_product.h"

#include <foredraw/displaced/displacement_stamp.h>
#include <foredraw/displaced/map_seams.h>
#include <foredraw/displaced/seam_table.h>
#include <foredraw/image/texture_uv.h>
#include <foredraw/scene/own_material.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>

namespace foredraw {

namespace {

struct Options {
  SeamMethod method = SeamMethod::exact;
  int iterations = 20;
  int bits = 14;
  int gutter = 0;
  bool table = false;
};

/// Texels that are an image's bytes from the beginning: of large maps one copy more counts.
class NewTexels {
 public:
  explicit NewTexels(const HeightMap& old) : bytes_(old.bytes()) {
    std::memcpy(bytes_.data(), old.texels.data(), bytes_.size());
  }

  std::span<std::uint16_t> view() { return {reinterpret_cast<std::uint16_t*>(bytes_.data()), bytes_.size() / 2}; }

  Image image(const HeightMap& old, const std::string& name) && {
    Image image{.name = name, .bytes = Shared<std::byte>(std::move(bytes_))};
    image.is_texels = true;
    image.facts = {old.width, old.height, 1, 16};
    return image;
  }

 private:
  std::vector<std::byte> bytes_;
};

/// What becomes of a map. No texels: it stays.
struct Repaired {
  SeamRepair seams;
  std::optional<NewTexels> texels;
  std::size_t filled = 0;  ///< texels of gutters
};

/// The same surface by heights of another range; nullopt where floats do not hold it.
std::optional<Displacement> of_range(Displacement displacement, const SeamRepair& repaired) {
  const double factor = displacement.factor, offset = displacement.offset;
  if (repaired.at_zero != 0 || repaired.at_one != 1) {
    displacement.factor = static_cast<float>(factor * (repaired.at_one - repaired.at_zero));
    displacement.offset = static_cast<float>(offset + factor * repaired.at_zero);
  }
  if (!std::isfinite(displacement.factor) || !std::isfinite(displacement.offset)) return std::nullopt;
  return displacement;
}

class DisplacementSeamsProcessor final : public Processor {
 public:
  explicit DisplacementSeamsProcessor(Options options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const SceneSeams found = seams_of_maps(scene, draws, run.analyses, run.cancel);
    if (run.cancelled()) return {};
    for (const auto& [draw, why] : found.left_out) run.note_at({.draw = draw}, "not-repaired", "not repaired: " + why);
    std::size_t edges = 0;
    for (const MapSeams& of : found.maps) edges += of.seams.seams;
    if (found.maps.empty()) {
      run.keep("no displaced draw has a map of heights that can be read along its seams; the notes say why");
      return {};
    }
    if (edges == 0) {
      run.keep("0 seam edges: the layout of no displaced draw has seams");
      return {};
    }
    std::vector<Repaired> repaired(found.maps.size());
    run.executor.for_each(found.maps.size(), [&](std::size_t i) {
      if (!run.cancelled()) repaired[i] = repair(scene, found.maps[i], run.cancel);
    });
    if (run.cancelled()) return {};
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < repaired.size(); ++i) {
      const MapSeams& of = found.maps[i];
      tell(of, repaired[i].seams, repaired[i].filled, run);
      const bool is_new = repaired[i].texels && can_put(scene, of, repaired[i].seams, run);
      if (options_.table)
        put_table(scene, of, is_new ? std::span<const std::uint16_t>(repaired[i].texels->view()) : of.heights->texels,
                  run);
      if (is_new) put(scene, of, std::move(repaired[i]), run);
      if (is_new || options_.table) changed.insert(changed.end(), of.draws.begin(), of.draws.end());
    }
    if (changed.empty()) run.keep("no map can be improved: the sides of its seams are already as equal as they can be");
    std::ranges::sort(changed);
    return changed;
  }

 private:
  Repaired repair(const Scene& scene, const MapSeams& of, const std::atomic<bool>* cancel) const {
    Repaired result{
        seam_repair(of.seams, of.sampled(),
                    {options_.method, options_.iterations, static_cast<std::uint32_t>(options_.bits), cancel}),
        std::nullopt};
    if (!result.seams.is_new && options_.gutter == 0) return result;
    result.texels.emplace(*of.heights);
    foredraw::put(result.seams, result.texels->view());
    if (options_.gutter > 0) result.filled = fill_gutter(scene, of, result.texels->view(), cancel);
    if (!result.seams.is_new && result.filled == 0) result.texels.reset();
    return result;
  }

  /// Around the charts of all draws of the map; how many texels changed.
  std::size_t fill_gutter(const Scene& scene, const MapSeams& of, std::span<std::uint16_t> texels,
                          const std::atomic<bool>* cancel) const {
    std::vector<UvTriangle> triangles;
    for (const DrawId id : of.draws) {
      const Texture& texture = scene.material_of(scene.draws[id])->displacement->texture;
      const Level& level = scene.draws[id].full();
      const auto uvs = texture_uv(*level.vertices->find("TEXCOORD_" + std::to_string(texture.texcoord)), texture);
      const auto indices = level.stream().indices.view();
      for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
        triangles.push_back({uvs[indices[i]], uvs[indices[i + 1]], uvs[indices[i + 2]]});
    }
    return foredraw::fill_gutter(texels, of.sampled(), triangles, options_.gutter, cancel);
  }

  static void tell(const MapSeams& of, const SeamRepair& repaired, std::size_t filled, const Run& run) {
    std::size_t below = 0;
    for (std::size_t e = 0; e < repaired.rule.size(); ++e) below += repaired.factors[e] < repaired.rule[e] ? 1 : 0;
    const About about{.draw = of.draws.front()};
    run.count_at(about, "edges", static_cast<double>(of.seams.seams));
    run.count_at(about, "unequal", static_cast<double>(repaired.unequal_after));
    run.count_at(about, "texels", static_cast<double>(repaired.seam_texels.size()));
    run.note_at(
        about, "seams",
        fmt::format("{} seam edges; of {} points on them {} were unequal before, and {} are now; {} texels changed{}",
                    of.seams.seams, repaired.points, repaired.unequal_before, repaired.unequal_after,
                    repaired.seam_texels.size(),
                    below == 0
                        ? ""
                        : fmt::format("; {} edges are equal only at lower factors than their texels allow", below)));
    if (filled > 0) run.note_at(about, "gutter", fmt::format("{} texels beside the charts changed, too", filled));
    if (of.seams.left_out > 0) {
      run.note_at(
          about, "triangles-left-out",
          fmt::format("{} triangles have two corners at one point, or numbers that are not finite", of.seams.left_out));
    }
  }

  static bool can_put(const Scene& scene, const MapSeams& of, const SeamRepair& repaired, const Run& run) {
    for (const DrawId id : of.draws) {
      if (of_range(*scene.material_of(scene.draws[id])->displacement, repaired)) continue;
      run.note_at({.draw = id}, "not-repaired", "not repaired: its factor or offset would be infinite");
      return false;
    }
    return true;
  }

  /// Gives the new map to the materials.
  static void put(Scene& scene, const MapSeams& of, Repaired made, const Run& run) {
    const SeamRepair& repaired = made.seams;
    std::map<MaterialId, std::vector<DrawId>> by_material;
    for (const DrawId id : of.draws) by_material[*scene.draws[id].material].push_back(id);
    const auto image = static_cast<ImageId>(scene.images.size());
    scene.images.push_back(std::move(*made.texels).image(*of.heights, scene.images[of.image].name));
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
  }

  /// Heights of the map's seams, for its draws.
  static void put_table(Scene& scene, const MapSeams& of, std::span<const std::uint16_t> texels, const Run& run) {
    foredraw_height_map map = of.sampled();
    map.texels = texels.data();
    SeamTable table = seam_table(of.seams, map, of.draws.size());
    const std::size_t edges = table.firsts.size(), bytes = table.stored_bytes();
    if (edges == 0) return;
    const Shared parts(std::move(table.parts_log2));
    const Shared heights(std::move(table.heights));
    const SeamHeights* before = scene.products.find<SeamHeights>();
    SeamHeights all = before == nullptr ? SeamHeights{} : *before;
    std::size_t sides = 0;
    for (std::size_t d = 0; d < of.draws.size(); ++d) {
      std::erase_if(all.draws, [&](const DrawSeams& other) { return other.draw == of.draws[d]; });
      sides += table.sides[d].size();
      if (!table.sides[d].empty())
        all.draws.push_back({of.draws[d], parts, heights, Shared(std::move(table.sides[d]))});
    }
    std::ranges::sort(all.draws, {}, &DrawSeams::draw);
    scene.products.set(std::move(all));
    const About about{.draw = of.draws.front()};
    run.measure_at(about, "table", static_cast<double>(bytes), static_cast<double>(edges));
    run.note_at(about, "seam-table",
                fmt::format("heights of {} seam edges are stored apart: {} bytes, {:.1f} an edge, and {} more that say "
                            "which edges of triangles they are of",
                            edges, bytes, static_cast<double>(bytes) / static_cast<double>(edges),
                            sides * sizeof(foredraw_seam_side)));
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

  table.row(&Options::gutter, "gutter",
            "How far around the charts texels take the heights next to them, for filters that read there; 0: they stay "
            "as they are",
            {0, 64, "texels"});
  table.row(&Options::table, "table",
            "Store the heights of seams apart, too: both sides are then equal at any level and spacing");

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "displacement-seams",
      .summary = "Makes the heights of a displacement map equal on both sides of every seam of its layout",
      .reference = "own; the averaging is that of Tatarchuk, Barczak, Purnomo 2008",
      .acts_on = {traits::displaced},
      .pays_if = "the layout of the map has seams, and heights differ across them",
      .measured_by = {"seam-gap"},
      .metrics = {{"edges", "edges", "Edges at which the layout is cut", true, false, true},
                  {"unequal", "points", "Points of seam edges whose sides still differ"},
                  {"texels", "texels", "Texels that were changed"},
                  {"table", "bytes", "Bytes that the heights of a seam edge take when stored apart", true, false,
                   true}},
  };
  plugin.products = {seam_heights_product()};
  bind_options(plugin, table,
               [](const Options& options) { return std::make_unique<DisplacementSeamsProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
