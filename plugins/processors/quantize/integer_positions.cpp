#include "integer_positions.h"

#include "quantize.h"

#include <foredraw/geometry/finite.h>
#include <foredraw/scene/skin_weights.h>

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <type_traits>

namespace foredraw {

namespace {

constexpr double most_steps = 65535, most_of_target = 32767;
/// Floats hold multiples of a step of six bits up to here, and of a power of two up to there.
constexpr double exact_multiples = 1 << (24 - step_bits), exact_powers = 1 << 23;

/// The smallest box around all positions of what is placed together, from its draws' origin.
struct Extent {
  glm::dvec3 least{std::numeric_limits<double>::infinity()}, most{-std::numeric_limits<double>::infinity()};
  double of_targets = 0;  ///< the largest component of a morph target

  void add(const glm::vec3& position) {
    least = glm::min(least, glm::dvec3(position));
    most = glm::max(most, glm::dvec3(position));
  }
  void add_change(const glm::vec3& change) {
    for (int c = 0; c < 3; ++c) of_targets = std::max(of_targets, std::abs(double{change[c]}));
  }
  double farthest() const {
    const glm::dvec3 reach = glm::max(glm::abs(least), glm::abs(most));
    return std::max({reach.x, reach.y, reach.z});
  }
};

/// Draws that have one grid or none.
struct Unit {
  DrawId first = 0;
  Extent extent = {};
  std::optional<std::string> why = {};  ///< it has none; empty where quantize() says so, or nothing is to be said
  bool is_untouched = false;            ///< and its positions are not rounded at all

  void stays(std::string reason) {
    if (!why) why = std::move(reason);
  }
  void stays_untouched() {
    stays({});
    is_untouched = true;
  }
};

std::int64_t multiple(double length, double step) { return std::llround(length / step); }

bool fits(const Extent& extent, double step, double exact) {
  if (extent.farthest() / step >= exact || extent.of_targets / step > most_of_target) return false;
  for (int c = 0; c < 3; ++c) {
    const auto steps = multiple(extent.most[c], step) - multiple(extent.least[c], step);
    if (static_cast<double>(steps) > most_steps) return false;
  }
  return true;
}

/// Whether all of its vertices are where joints move them, and not where the node does.
bool are_moved_by_joints(const Draw& draw, std::size_t joints) {
  return std::ranges::all_of(draw.levels, [&](const Level& level) {
    const SkinWeights skin(*level.vertices);
    const auto moves = [&](const SkinWeights::Slot& slot) { return slot.weight > 0 && slot.joint < joints; };
    for (std::uint32_t v = 0; v < level.vertices->count && !skin.empty(); ++v) {
      if (std::ranges::none_of(skin.of(v), moves)) return false;
    }
    return !skin.empty();
  });
}

/// The greatest power of two that is a step.
double power_step(double distance) { return std::ldexp(1.0, std::ilogb(2 * distance / std::sqrt(3.0))); }

class Finding {
 public:
  Finding(const Scene& scene, const std::vector<VertexGroup>& groups, Lattices& lattices, Analyses& analyses)
      : scene_(scene), groups_(groups), lattices_(lattices), analyses_(analyses), sets_(scene.draws.size()) {}

  IntegerPositions run(const std::vector<DrawId>& draws) {
    join_placed_together(scene_, sets_);
    for (const VertexGroup& group : groups_) {
      for (const VertexGroup::User& user : group.users) sets_.join(group.users.front().draw, user.draw);
    }
    for (const DrawId id : draws) units_.try_emplace(sets_.of(id), Unit{id});
    look_at_draws();
    look_at_nodes();
    for (const VertexGroup& group : groups_) measure(group);
    choose_steps();
    return grids(draws);
  }

 private:
  struct Lattice {
    bool has_floats = false;
    double step = 0;  ///< of its grids; 0: it has none
  };

  /// Nothing where none of its draws may change.
  Unit* unit_of(DrawId id) {
    const auto found = units_.find(sets_.of(id));
    return found == units_.end() ? nullptr : &found->second;
  }
  double tolerance_of(const Unit& unit) const { return lattices_.tolerances[unit.first]; }
  Lattice& lattice_of(const Unit& unit) { return by_lattice_[lattices_.sets.of(unit.first)]; }

  void look_at_draws() {
    std::set<const VertexStreams*> may_change;
    for (const VertexGroup& group : groups_) may_change.insert(group.vertices.get());
    for (DrawId id = 0; id < scene_.draws.size(); ++id) {
      Unit* unit = unit_of(id);
      if (unit == nullptr) continue;
      const Draw& draw = scene_.draws[id];
      const Material* material = scene_.material_of(draw);
      if (std::ranges::any_of(draw.levels, [&](const Level& at) { return !may_change.contains(at.vertices.get()); })) {
        unit->stays(draw.name + " is placed with them, and must stay as it is");
      } else if (std::ranges::any_of(draw.levels, [](const Level& level) { return level.origin.has_value(); })) {
        unit->stays("the file has their levels of detail as meshes of their own");
      } else if (material != nullptr && material->keeps_spaces) {
        unit->stays("another material may stand in for " + material->name +
                    ", or an extension or animation changes it");
      }
    }
  }

  /// Who has no node has nothing to scale it back.
  void look_at_nodes() {
    std::vector<char> is_drawn(scene_.draws.size(), 0);
    for (const Node& node : scene_.nodes) {
      if (!node.mesh) continue;
      for (const DrawId id : scene_.meshes[*node.mesh].draws) {
        is_drawn[id] = 1;
        Unit* unit = unit_of(id);
        if (unit == nullptr) continue;
        if (node.keeps_mesh) unit->stays("an extension or another scene refers to their node, or no scene shows it");
        if (node.skin && !are_moved_by_joints(scene_.draws[id], scene_.skins[*node.skin].joints.size()))
          unit->stays("some of their vertices have no joint that moves them");
      }
    }
    for (DrawId id = 0; id < is_drawn.size(); ++id) {
      if (Unit* unit = unit_of(id); unit != nullptr && is_drawn[id] == 0) unit->stays("no node draws them");
    }
  }

  void measure(const VertexGroup& group) {
    Unit& unit = *unit_of(group.users.front().draw);
    const VertexStreams& vertices = *group.vertices;
    const VertexStream* stream = vertices.find("POSITION");
    const bool are_floats = stream != nullptr && stream->format.component == Component::float32;
    if (!are_floats || !(tolerance_of(unit) > 0)) return unit.stays_untouched();
    for (const glm::vec3& position : positions_of(analyses_, vertices)->values) {
      if (!is_finite(position)) return unit.stays_untouched();
      unit.extent.add(position);
    }
    for (const std::vector<VertexStream>& target : vertices.morph_targets) {
      const auto moved = std::ranges::find(target, "POSITION", &VertexStream::semantic);
      if (moved != target.end()) measure_target(*moved, unit);
    }
  }

  static void measure_target(const VertexStream& stream, Unit& unit) {
    if (stream.format.component != Component::float32) return unit.stays_untouched();
    for (const glm::vec3& change : decode_vec3(stream)) {
      if (!is_finite(change)) return unit.stays_untouched();
      unit.extent.add_change(change);
    }
  }

  /// Of each lattice: of six bits where all of it has grids that floats hold exactly, else a power of two. What is too
  /// wide even for that stays floats.
  void choose_steps() {
    for (const auto& [root, unit] : units_) {
      if (unit.is_untouched) continue;
      lattice_of(unit).has_floats |= unit.why || !fits(unit.extent, grid_step(tolerance_of(unit), 3), exact_multiples);
    }
    for (auto& [root, unit] : units_) {
      if (unit.why) continue;
      Lattice& lattice = lattice_of(unit);
      const double step = lattice.has_floats ? power_step(tolerance_of(unit)) : grid_step(tolerance_of(unit), 3);
      if (fits(unit.extent, step, exact_powers)) {
        lattice.step = step;
      } else {
        unit.stays("they are more than 65,535 steps wide, or too far from 0 for floats to be rounded so finely");
      }
    }
  }

  IntegerPositions grids(const std::vector<DrawId>& draws) {
    IntegerPositions result{std::vector<std::optional<PositionGrid>>(scene_.draws.size()), lattices_.tolerances, {}};
    for (const DrawId id : draws) {
      const Unit& unit = *unit_of(id);
      const double step = lattice_of(unit).step;
      if (!unit.why) {
        const glm::dvec3& least = unit.extent.least;
        result.grids[id] = {step, {multiple(least.x, step), multiple(least.y, step), multiple(least.z, step)}};
      } else if (step > 0) {
        result.tolerances[id] = step * std::sqrt(3.0) / 2 * (1 + 1e-9);  // its lattice has the step along all axes
      }
    }
    for (const auto& [root, unit] : units_) {
      if (unit.why && !unit.why->empty()) result.staying.emplace_back(unit.first, *unit.why);
    }
    return result;
  }

  const Scene& scene_;
  const std::vector<VertexGroup>& groups_;
  Lattices& lattices_;
  Analyses& analyses_;
  JoinedSets sets_;
  std::map<std::uint32_t, Unit> units_;  ///< by the smallest draw
  std::map<std::uint32_t, Lattice> by_lattice_;
};

template <class T>
VertexStream whole_numbers(const VertexStream& of, const std::vector<T>& numbers, Component component) {
  const auto bytes = std::as_bytes(std::span(numbers));
  return {of.semantic, {component, 3, false, 3 * sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

/// `first` added back, in the arithmetic of shaders: one rounding, of the sum.
template <class T>
VertexStream on_grid(const VertexStream& of, double step, const std::array<std::int64_t, 3>& first, double& error) {
  std::vector<T> numbers;
  numbers.reserve(of.count() * 3);
  double farthest = 0;
  for (const glm::vec3& position : decode_vec3(of)) {
    double square = 0;
    for (int c = 0; c < 3; ++c) {
      const std::int64_t number = multiple(position[c], step), least = first[static_cast<std::size_t>(c)];
      numbers.push_back(static_cast<T>(number - least));
      const double off = double{static_cast<float>(step * static_cast<double>(number))} - double{position[c]};
      square += off * off;
    }
    farthest = std::max(farthest, square);
  }
  error = std::max(error, std::sqrt(farthest));
  return whole_numbers(of, numbers, sizeof(T) == 2 && std::is_signed_v<T> ? Component::int16 : Component::uint16);
}

}  // namespace

glm::vec3 PositionGrid::offset() const {
  return {static_cast<float>(step * static_cast<double>(first[0])),
          static_cast<float>(step * static_cast<double>(first[1])),
          static_cast<float>(step * static_cast<double>(first[2]))};
}

IntegerPositions integer_positions(const Scene& scene, const std::vector<DrawId>& draws,
                                   const std::vector<VertexGroup>& groups, Lattices& lattices, Analyses& analyses) {
  return Finding(scene, groups, lattices, analyses).run(draws);
}

OnGrid on_grid(const VertexStreams& vertices, const PositionGrid& grid) {
  OnGrid result;
  auto made = std::make_shared<VertexStreams>(vertices);
  for (VertexStream& stream : made->base) {
    if (stream.semantic == "POSITION") stream = on_grid<std::uint16_t>(stream, grid.step, grid.first, result.error);
  }
  for (std::vector<VertexStream>& target : made->morph_targets) {
    for (VertexStream& stream : target) {
      if (stream.semantic == "POSITION") stream = on_grid<std::int16_t>(stream, grid.step, {}, result.error);
    }
  }
  result.vertices = std::move(made);
  return result;
}

}  // namespace foredraw
