#include "vertex_pack.h"

#include "pack_scene.h"
#include "packed_vertices_product.h"

#include <foredraw/measuring/pose_options.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

struct VertexPackOptions : PoseSet, processors::vertex_pack::PackOptions {
  VertexPackOptions() { poses = "all"; }
};

class VertexPackProcessor final : public Processor {
 public:
  explicit VertexPackProcessor(VertexPackOptions options) : options_(std::move(options)) {
    if (const auto mistake = mistake_in(options_)) throw std::invalid_argument(*mistake);
  }

  /// Rows of other draws, which an earlier stage made, stay.
  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const Poses poses = make_poses(scene, options_);
    processors::vertex_pack::PackedScene made =
        processors::vertex_pack::pack_scene(scene, draws, run.subjects, poses, options_, run.analyses, run.executor);
    for (const processors::vertex_pack::NotPacked& left : made.left_out)
      run.note_at({.draw = left.draw}, "not-packed", left.why);
    if (made.draws.empty()) {
      run.keep("no draw can be packed; the notes say why");
      return {};
    }
    PackedVertices all;
    if (const auto* before = scene.products.find<PackedVertices>()) all = *before;
    std::erase_if(all.draws, [&](const auto& packed) { return std::ranges::binary_search(draws, packed.draw); });
    std::vector<DrawId> changed;
    bool is_posed = false;
    for (processors::vertex_pack::PackedDraw& draw : made.draws) {
      is_posed |= draw.packed.posed.has_value();
      tell(draw, packed_uv_widths(scene, draw.packed.draw), run);
      changed.push_back(draw.packed.draw);
      all.draws.push_back(std::move(draw.packed));
    }
    if (is_posed) {
      run.note("poses", fmt::format("poses that the layouts of posed vertices were made for: {}", poses.poses.size()));
    }
    std::ranges::sort(all.draws, {}, &PackedVertices::OfDraw::draw);
    scene.products.set(std::move(all));
    return changed;
  }

 private:
  /// `uv_widths`: of the texture, for 1 of uv.
  static void tell(const processors::vertex_pack::PackedDraw& draw, double uv_widths, const Run& run) {
    const About about{.draw = draw.packed.draw};
    constexpr double texels = 4096;
    const auto measure = [&](const char* metric, double bound, double whole, int field) {
      if (draw.packed.layout.field[field].bits != 0) run.measure_at(about, metric, bound, whole);
    };
    measure("position-bound", draw.bounds.position, draw.diagonal / 1e6, FOREDRAW_PACKED_X);
    measure("normal-bound", draw.bounds.normal, 1, FOREDRAW_PACKED_NORMAL_0);
    measure("tangent-bound", draw.bounds.tangent, 1, FOREDRAW_PACKED_TANGENT);
    measure("uv-bound", draw.bounds.uv() * uv_widths * texels, 1, FOREDRAW_PACKED_U);
    if (draw.packed.posed) {
      const double bound = packed_bounds(*draw.packed.posed).position;
      run.measure_at(about, "posed-bound", bound, draw.posed_diagonal / 1e6);
    }
    if (draw.no_direction > 0) {
      run.note_at(about, "no-direction",
                  fmt::format("vertices whose normal or tangent has no direction, so that a default is packed: {}",
                              draw.no_direction));
    }
    if (!draw.plain.empty()) {
      run.note_at(about, "stays-plain", "not packed, and still read from its own streams: " + draw.plain);
    }
  }

  VertexPackOptions options_;
};

}  // namespace

Plugin vertex_pack_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "vertex-pack",
      .summary =
          "Packs position, normal, tangent and texture coordinates of each vertex into 128 bits, with proved bounds",
      .reference = "Tatarchuk, Barczak, Purnomo 2008, vertex compression",
      .acts_on = {traits::triangles},
      .lossless = true,
      .measured_by = {"vertex-precision"},
      .metrics = {{"position-bound", "millionths of the diagonal", "Proved: no stored position is farther off", true,
                   true},
                  {"posed-bound", "millionths of the diagonal", "Proved: no posed position is farther off", true, true},
                  {"normal-bound", "degrees", "Proved: no normal is farther off", true, true},
                  {"tangent-bound", "degrees", "Proved: no tangent is farther off", true, true},
                  {"uv-bound", "texels of 4096", "Proved: no texture coordinate is farther off", true, true}},
  };
  plugin.products = {packed_vertices_product()};
  OptionTable<VertexPackOptions> table;
  table
      .choice(
          &processors::vertex_pack::PackOptions::method, "method",
          "How normals are coded. octahedral: as points of an octahedron; spherical: as two angles, as in the paper",
          {{"octahedral", processors::vertex_pack::NormalMethod::octahedral},
           {"spherical", processors::vertex_pack::NormalMethod::spherical}})
      .row(&processors::vertex_pack::PackOptions::displacement, "displacement",
           "Largest displacement along normals, as part of the box's diagonal: bits are shared out so that displaced "
           "points move the least (default: what materials say, else 0.002)",
           {0, 10, "of the diagonal"})
      .row(&processors::vertex_pack::PackOptions::slope, "slope",
           "Largest slope of the displacement's height, in diagonals of the box for the width of the texture (default: "
           "that of the materials' maps, else 0.2)",
           {0, 1000, "of the diagonal"})
      .row(&processors::vertex_pack::PackOptions::most_angle_error, "most-angle-error",
           "Largest error of normals, and of tangents at a right angle to them", {0.01, 10, "degrees"})
      .row(&processors::vertex_pack::PackOptions::most_uv_error, "most-uv-error",
           "Draws whose texture coordinates would be farther off are not packed", {0.001, 4096, "texels of 4096"})
      .row(&processors::vertex_pack::PackOptions::margin, "margin",
           "Room around the box of all poses, on each side, for what lies between poses and for blends of clips",
           {0, 10, "of its extent"});
  add_pose_rows(table);
  bind_options(plugin, table,
               [](const VertexPackOptions& options) { return std::make_unique<VertexPackProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
