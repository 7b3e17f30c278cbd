#include "integer_positions.h"
#include "integer_texcoords.h"
#include "quantize.h"
#include "rounded_animations.h"
#include "scale_back.h"
#include "touching_draws.h"
#include "world_lengths.h"

#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

struct QuantizeOptions {
  double position_error = 3e-5;
  double direction_error = 1;
  double uv_error = .5;
  double color_error = .002;
  double weight_error = .004;
  double translation_error = 3e-5;
  double rotation_error = .07;
  double scale_error = 1e-4;
  int position_bits = 0;
  int direction_bits = 0;
  int uv_bits = 0;
  bool integers = true;
};

constexpr double texels = 4096;

/// Half the diagonal of a cell of a grid of so many bits over a length of 1.
double half_cell(int bits, double dimensions) { return std::sqrt(dimensions) / 2 / ((1 << bits) - 1); }

/// How far the middle between points of an octahedron of so many bits is from them, in degrees.
double between_directions(int bits) { return .86 * 127 / ((1 << (bits - 1)) - 1); }

class QuantizeProcessor final : public Processor {
 public:
  explicit QuantizeProcessor(QuantizeOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<VertexGroup> groups = vertex_groups(scene);
    for (const HeldDraw& held : keep_groups_of(groups, draws)) {
      run.note_at(
          {held.draw}, "shared-vertices",
          "not quantised: it shares its vertices with " + scene.draws[held.by].name + ", which must stay as it is");
    }
    bool any = round_animations(scene, draws, run);
    const std::vector<Meeting> meetings = meetings_of(scene, draws, run.analyses);
    const IntegerPositions integers = placed_positions(scene, draws, groups, meetings, run);
    const double uv = options_.uv_bits > 0 ? half_cell(options_.uv_bits, 2) : options_.uv_error / texels;
    const IntegerTexcoords texcoords = find_integer_texcoords(scene, groups, options_.integers ? uv : 0);
    const std::vector<Quantized> made = rounded_groups(groups, integers, texcoords, uv, run);
    std::vector<DrawId> changed;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      any |= made[i].vertices->stamp() != groups[i].vertices->stamp();
      for (const VertexGroup::User& user : groups[i].users) {
        changed.push_back(user.draw);
        put(made[i], scene.draws[user.draw].levels[user.level], user.level > 0, integers.grids[user.draw]);
      }
      tell(made[i], groups[i].users.front(), run);
    }
    for (const DrawId id : draws) {
      if (integers.grids[id]) put(*integers.grids[id], scene.draws[id]);
    }
    scale_textures(scene.materials, texcoords);  // before others copy materials
    const std::vector<NodeId> drawn_by = scale_back(scene, integers.grids);
    if (!any) run.keep("every attribute is as coarse as the errors allow");
    if (!meetings.empty()) run.measure_at({}, "gap", largest_gap(scene, meetings, drawn_by, run.analyses), 1);
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

 private:
  IntegerPositions placed_positions(const Scene& scene, const std::vector<DrawId>& draws,
                                    const std::vector<VertexGroup>& groups, const std::vector<Meeting>& meetings,
                                    Run& run) const {
    const bool by_bits = options_.position_bits > 0;
    const PositionTolerance tolerance{by_bits ? half_cell(options_.position_bits, 3) : options_.position_error,
                                      by_bits};
    Lattices lattices = lattices_of(scene, draws, groups, meetings, run.subjects, tolerance, run.analyses);
    if (options_.integers && scene.products.empty()) {
      IntegerPositions made = integer_positions(scene, draws, groups, lattices, run.analyses);
      std::map<std::string, std::vector<DrawId>> by_reason;
      for (const auto& [draw, why] : made.staying) by_reason[why].push_back(draw);
      for (const auto& [why, of] : by_reason) tell_staying(scene, of, why, run);
      return made;
    }
    if (options_.integers) {
      run.note_at(
          {}, "positions-stay-floats",
          "positions stay floats: the scene holds what earlier stages made, whose lengths are in the units of its "
          "draws; put quantize before those stages");
    }
    return {std::vector<std::optional<PositionGrid>>(scene.draws.size()), std::move(lattices.tolerances), {}};
  }

  static void tell_staying(const Scene& scene, const std::vector<DrawId>& draws, const std::string& why, Run& run) {
    const std::string& first = scene.draws[draws.front()].name;
    const std::string others = draws.size() == 1 ? "" : fmt::format(" and {} more", draws.size() - 1);
    run.note_at({}, "positions-stay-floats", fmt::format("positions of {}{} stay floats: {}", first, others, why));
  }

  std::vector<Quantized> rounded_groups(const std::vector<VertexGroup>& groups, const IntegerPositions& integers,
                                        const IntegerTexcoords& texcoords, double uv, const Run& run) const {
    const Tolerances tolerances{.direction = options_.direction_bits > 1 ? between_directions(options_.direction_bits)
                                                                         : options_.direction_error,
                                .uv = uv,
                                .color = options_.color_error,
                                .weight = options_.weight_error};
    std::vector<Quantized> made(groups.size());
    run.executor.for_each(groups.size(), [&](std::size_t i) {
      const DrawId draw = groups[i].users.front().draw;
      Tolerances own = tolerances;
      own.position = integers.tolerances[draw];
      // What is whole numbers already stays in quantize().
      const auto uvs = with_integer_texcoords(*groups[i].vertices, texcoords.of_groups[i]);
      const auto all = integers.grids[draw] ? on_grid(*uvs.vertices, *integers.grids[draw]) : OnGrid{uvs.vertices};
      made[i] = quantize(*all.vertices, own, run.cancel);
      made[i].largest.position = std::max(made[i].largest.position, all.error);
      made[i].largest.uv = std::max(made[i].largest.uv, uvs.largest);
    });
    return made;
  }

  /// Both surfaces moved, the level's and that of full detail.
  static void put(const Quantized& made, Level& level, bool is_coarser, const std::optional<PositionGrid>& grid) {
    level.vertices = made.vertices;
    if (!is_coarser) return;
    level.error += static_cast<float>(2 * made.largest.position);
    if (grid) level.error = static_cast<float>(level.error / grid->step);
  }

  static void put(const PositionGrid& grid, Draw& draw) {
    draw.traits.add(traits::quantized);
    draw.space.offset += draw.space.scale * glm::dvec3(grid.offset());
    draw.space.scale *= grid.step;
  }

  /// False where no key changed.
  bool round_animations(Scene& scene, const std::vector<DrawId>& draws, Run& run) const {
    const double size = longest_diagonal(scene, draws, run.analyses);
    const KeyTolerances tolerances{options_.translation_error * size, options_.rotation_error, options_.scale_error};
    const std::vector<double> units = longest_units(scene);
    std::vector<RoundedAnimation> made(scene.animations.size());
    run.executor.for_each(made.size(),
                          [&](std::size_t i) { made[i] = rounded(scene.animations[i], tolerances, units); });
    KeyErrors largest;
    std::size_t before = 0, after = 0;
    bool any = false;
    for (std::size_t i = 0; i < made.size(); ++i) {
      largest.translation = std::max(largest.translation, made[i].largest.translation);
      largest.rotation = std::max(largest.rotation, made[i].largest.rotation);
      largest.scale = std::max(largest.scale, made[i].largest.scale);
      before += made[i].keys_before;
      after += made[i].keys_after;
      any |= !std::ranges::equal(scene.animations[i].channels, made[i].animation.channels, {},
                                 &AnimationChannel::values, &AnimationChannel::values);
      scene.animations[i] = std::move(made[i].animation);
    }
    if (before == 0) return false;
    run.measure_at({}, "translation-error", largest.translation, 1);
    run.measure_at({}, "rotation-error", largest.rotation, 1);
    run.measure_at({}, "scale-error", largest.scale, 1);
    run.measure_at({}, "keys-left", static_cast<double>(after), static_cast<double>(before));
    return any;
  }

  static void tell(const Quantized& made, const VertexGroup::User& user, const Run& run) {
    const About about{.draw = user.draw, .level = user.level};
    const auto measure = [&](const char* metric, double error) {
      if (error > 0) run.measure_at(about, metric, error, 1);
    };
    measure("position-error", made.largest.position);
    measure("direction-error", made.largest.direction);
    measure("uv-error", made.largest.uv * texels);
    measure("color-error", made.largest.color);
    measure("weight-error", made.largest.weight);
    for (const std::string& stream : made.plain) run.note_at(about, "stays-plain", "not quantised: " + stream);
  }

  QuantizeOptions options_;
};

}  // namespace

Plugin quantize_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "quantize",
      .summary =
          "Rounds vertex attributes and animations within the errors asked for, and stores them in few bits; put "
          "`weld` "
          "behind it, and write with --compression",
      .reference = "KHR_mesh_quantization; EXT_meshopt_compression, appendix B",
      .acts_on = {traits::triangles},
      .breaks = {traits::welded},
      .pays_if = "the file is written compressed, or vertices take much of the GPU memory",
      .measured_by = {"scene-cost"},
      .metrics = {{"position-error", "units", "Largest distance of a rounded position, in the units that the draw had",
                   true, true},
                  {"direction-error", "degrees", "Largest angle of a rounded normal or tangent", true, true},
                  {"uv-error", "texels of 4096", "Largest distance of a rounded texture coordinate", true, true},
                  {"color-error", "", "Largest error of a component of a colour, of 1", true, true},
                  {"weight-error", "", "Largest error of a skin weight, of 1", true, true},
                  {"translation-error", "units",
                   "Largest distance of an animated translation from its key, in the world", true, true},
                  {"rotation-error", "degrees", "Largest angle of an animated rotation from its key", true, true},
                  {"scale-error", "", "Largest error of an animated scale, of 1", true, true},
                  {"keys-left", "keys per key", "Keys that animations keep", true},
                  {"gap", "units", "Largest distance between vertices of two draws that met before", true, true}},
  };
  OptionTable<QuantizeOptions> table;
  table
      .row(&QuantizeOptions::position_error, "position-error",
           "How far positions may be off, as part of the diagonal of their subject's largest draw; 0: they stay",
           {0, .1, "of the diagonal"})
      .row(&QuantizeOptions::direction_error, "direction-error",
           "How far normals and tangents may be off; 0: they stay", {0, 45, "degrees"})
      .row(&QuantizeOptions::uv_error, "uv-error", "How far texture coordinates may be off; 0: they stay",
           {0, 1024, "texels of 4096"})
      .row(&QuantizeOptions::color_error, "color-error", "How far each component of a colour may be off; 0: they stay",
           {0, 1, "of 1"})
      .row(&QuantizeOptions::weight_error, "weight-error", "How far each skin weight may be off; 0: they stay",
           {0, .1, "of 1"})
      .row(&QuantizeOptions::translation_error, "translation-error",
           "How far animated translations may be off at any key, as part of the diagonal of the draw that is largest "
           "in the "
           "world; 0: they stay",
           {0, .1, "of the diagonal"})
      .row(&QuantizeOptions::rotation_error, "rotation-error",
           "How far animated rotations may be off at any key; 0: they stay", {0, 45, "degrees"})
      .row(&QuantizeOptions::scale_error, "scale-error", "How far animated scales may be off at any key; 0: they stay",
           {0, 1, "of 1"})
      .row(&QuantizeOptions::position_bits, "position-bits",
           "In place of position-error: the error of a grid of so many bits over the largest side of the subject's "
           "largest draw; 0: by error",
           {0, 24, "bits"})
      .row(&QuantizeOptions::direction_bits, "direction-bits",
           "In place of direction-error: the error of so many bits for each of two components; 0 or 1: by error",
           {0, 16, "bits"})
      .row(&QuantizeOptions::uv_bits, "uv-bits",
           "In place of uv-error: the error of a grid of so many bits over the texture; 0: by error", {0, 24, "bits"})
      .row(&QuantizeOptions::integers, "integers",
           "Whether positions and texture coordinates become integers, which nodes, skins and materials scale back; "
           "false: "
           "they stay floats");
  bind_options(plugin, table,
               [](const QuantizeOptions& options) { return std::make_unique<QuantizeProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
