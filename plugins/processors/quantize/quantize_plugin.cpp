#include "quantize.h"
#include "rounded_animations.h"
#include "touching_draws.h"

#include <foredraw/analysis/diagonal.h>
#include <foredraw/analysis/mesh_facts.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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
};

constexpr double texels = 4096;

/// Half the diagonal of a cell of a grid of so many bits over a length of 1.
double half_cell(int bits, double dimensions) { return std::sqrt(dimensions) / 2 / ((1 << bits) - 1); }

/// How far the middle between points of an octahedron of so many bits is from them, in degrees.
double between_directions(int bits) { return .86 * 127 / ((1 << (bits - 1)) - 1); }

/// The largest side of the box.
double side_of(std::span<const glm::vec3> positions) {
  glm::vec3 least(std::numeric_limits<float>::infinity()), most(-least);
  for (const glm::vec3& position : positions) {
    if (!is_finite(position)) continue;
    least = glm::min(least, position);
    most = glm::max(most, position);
  }
  const glm::dvec3 sides = glm::dvec3(most) - glm::dvec3(least);
  return std::max({sides.x, sides.y, sides.z, 0.0});
}

/// [draw] how far its positions may be off: what hangs together has one lattice.
std::vector<double> position_tolerances(const Scene& scene, const std::vector<DrawId>& draws,
                                        const std::vector<VertexGroup>& groups, const std::vector<Meeting>& meetings,
                                        const QuantizeOptions& options, Run& run) {
  JoinedSets sets(scene.draws.size());
  const std::vector<Subject> subjects = subjects_of(scene, run.subjects);
  for (const Subject& subject : subjects) {
    for (const SubjectPart& other : subject.parts) sets.join(subject.parts.front().draw, other.draw);
  }
  std::vector<double> sizes(scene.draws.size());  // of a subject: the largest of its draws
  for (const DrawId id : draws) {
    const auto positions = positions_of(run.analyses, *scene.draws[id].full().vertices);
    double& size = sizes[sets.of(id)];
    const bool by_bits = options.position_bits > 0;
    size = std::max(size, by_bits ? side_of(positions->values) : diagonal_of(positions->values));
  }
  const double part = options.position_bits > 0 ? half_cell(options.position_bits, 3) : options.position_error;
  std::vector<double> tolerances(scene.draws.size());
  for (const DrawId id : draws) tolerances[id] = part * sizes[sets.of(id)];
  for (const VertexGroup& group : groups) {
    for (const VertexGroup::User& user : group.users) sets.join(group.users.front().draw, user.draw);
  }
  for (const Meeting& meeting : meetings) sets.join(meeting.at.draw, meeting.with.draw);
  std::vector<double> least(scene.draws.size());
  for (const DrawId id : draws) {
    double& one = least[sets.of(id)];
    if (one == 0 || (tolerances[id] > 0 && tolerances[id] < one)) one = tolerances[id];
  }
  for (const DrawId id : draws) tolerances[id] = least[sets.of(id)];
  return tolerances;
}

class QuantizeVertices final : public Processor {
 public:
  explicit QuantizeVertices(QuantizeOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    std::vector<VertexGroup> groups = vertex_groups(scene);
    for (const HeldDraw& held : keep_groups_of(groups, draws)) {
      run.note_at(
          {held.draw}, "shared-vertices",
          "not quantised: it shares its vertices with " + scene.draws[held.by].name + ", which must stay as it is");
    }
    const std::vector<Meeting> meetings = meetings_of(scene, draws, run.analyses);
    const std::vector<double> tolerances = position_tolerances(scene, draws, groups, meetings, options_, run);
    const double direction =
        options_.direction_bits > 1 ? between_directions(options_.direction_bits) : options_.direction_error;
    const double uv = options_.uv_bits > 0 ? half_cell(options_.uv_bits, 2) : options_.uv_error / texels;

    std::vector<Quantized> made(groups.size());
    run.executor.for_each(groups.size(), [&](std::size_t i) {
      made[i] = quantize(*groups[i].vertices,
                         {.position = tolerances[groups[i].users.front().draw],
                          .direction = direction,
                          .uv = uv,
                          .color = options_.color_error,
                          .weight = options_.weight_error},
                         run.cancel);
    });
    std::vector<DrawId> changed;
    bool any = false;
    for (std::size_t i = 0; i < groups.size(); ++i) {
      any |= made[i].vertices->stamp() != groups[i].vertices->stamp();
      for (const VertexGroup::User& user : groups[i].users) {
        changed.push_back(user.draw);
        put(made[i], scene.draws[user.draw].levels[user.level], user.level > 0);
      }
      tell(made[i], groups[i].users.front(), run);
    }
    any |= round_animations(scene, draws, run);
    if (!any) run.keep("every attribute is as coarse as the errors allow");
    if (!meetings.empty()) run.measure_at({}, "gap", largest_gap(scene, meetings, run.analyses), 1);
    std::ranges::sort(changed);
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
  }

 private:
  /// Both surfaces moved, the level's and that of full detail.
  static void put(const Quantized& made, Level& level, bool is_coarser) {
    level.vertices = made.vertices;
    if (is_coarser) level.error += static_cast<float>(2 * made.largest.position);
  }

  /// False where no key changed.
  bool round_animations(Scene& scene, const std::vector<DrawId>& draws, Run& run) const {
    double size = 0;
    for (const DrawId id : draws) {
      size = std::max(size, diagonal_of(positions_of(run.analyses, *scene.draws[id].full().vertices)->values));
    }
    const KeyTolerances tolerances{options_.translation_error * size, options_.rotation_error, options_.scale_error};
    std::vector<RoundedAnimation> made(scene.animations.size());
    run.executor.for_each(made.size(), [&](std::size_t i) { made[i] = rounded(scene.animations[i], tolerances); });
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
          "Rounds vertex attributes within the errors asked for, so that compressed files are small; put `weld` "
          "behind it, and write with --compression",
      .reference = "EXT_meshopt_compression, appendix B",
      .acts_on = {traits::triangles},
      .breaks = {traits::welded},
      .pays_if = "the file is written compressed",
      .measured_by = {"scene-cost"},
      .metrics = {{"position-error", "units", "Largest distance of a rounded position, in the draw's units", true,
                   true},
                  {"direction-error", "degrees", "Largest angle of a rounded normal or tangent", true, true},
                  {"uv-error", "texels of 4096", "Largest distance of a rounded texture coordinate", true, true},
                  {"color-error", "", "Largest error of a component of a colour, of 1", true, true},
                  {"weight-error", "", "Largest error of a skin weight, of 1", true, true},
                  {"translation-error", "units", "Largest distance of an animated translation from its key", true,
                   true},
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
           "How far animated translations may be off at any key, as part of the diagonal of the largest draw; 0: they "
           "stay",
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
           "In place of uv-error: the error of a grid of so many bits over the texture; 0: by error", {0, 24, "bits"});
  bind_options(plugin, table,
               [](const QuantizeOptions& options) { return std::make_unique<QuantizeVertices>(options); });
  return plugin;
}

}  // namespace foredraw
