// What is wrong with levels that a file or a stage has.
#include "level_ladder.h"
#include "tessellation_levels.h"
#include "tessellation_levels_product.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace foredraw {

std::string read_tessellation(ExtensionReader& from, const ExtensionValue& value, DrawTessellation& to) {
  const auto levels = rows_of<LogLevels>(from, value.member("levels"), Component::uint8);
  if (!levels) return "has no accessor 'levels' of four unsigned bytes";
  to.levels = *levels;
  const ExtensionValue* scales = value.member("scales");
  if (scales == nullptr || scales->list() == nullptr || scales->list()->empty() ||
      scales->list()->size() > most_log_level + 1u) {
    return "has no array 'scales' of 1 to 7 objects";
  }
  for (const ExtensionValue& one : *scales->list()) {
    const auto number = [&](const char* name) -> std::optional<double> {
      const ExtensionValue* member = one.member(name);
      const auto value = member == nullptr ? std::nullopt : member->number();
      return value && std::abs(*value) <= std::numeric_limits<float>::max() ? value : std::nullopt;
    };
    const auto rms = number("rms"), largest = number("largest");
    const ExtensionValue* triangles = one.member("triangles");
    if (triangles == nullptr || !triangles->whole() || !rms || !largest) {
      return "has a scale without 'triangles', 'rms' and 'largest'";
    }
    to.scales.push_back({*triangles->whole(), static_cast<float>(*rms), static_cast<float>(*largest)});
  }
  const ExtensionValue* ranges = value.member("ranges");
  const auto begins =
      ranges == nullptr ? std::nullopt : rows_of<std::uint32_t>(from, ranges->member("begins"), Component::uint32);
  const auto displacements =
      ranges == nullptr ? std::nullopt
                        : rows_of<DisplacementRange>(from, ranges->member("displacements"), Component::float32);
  if (!begins || !displacements) return "has no 'ranges' with accessors 'begins' and 'displacements'";
  to.range_begins = *begins;
  to.ranges = *displacements;
  return {};
}

namespace {

std::string difference(std::span<const TessellationScale> scales, std::span<const LogLevels> levels) {
  std::uint8_t finest = 0;
  for (const LogLevels& of : levels) finest = std::max(finest, std::ranges::max(of));
  if (finest > most_log_level) return fmt::format("have a level of 2^{}, but 64 is the highest there is", finest);
  if (scales.size() != finest + 1u) return fmt::format("have {} scales, but levels up to 2^{}", scales.size(), finest);
  for (std::uint32_t s = 0; s < scales.size(); ++s) {
    std::uint64_t triangles = 0;
    for (const LogLevels& of : levels) triangles += triangles_of(scaled(of, s));
    if (triangles != scales[s].triangles)
      return fmt::format("make {} triangles at scale {}, not {}", triangles, s, scales[s].triangles);
    const TessellationScale before = s == 0 ? TessellationScale{} : scales[s - 1];
    const bool rises = std::isfinite(scales[s].rms) && std::isfinite(scales[s].largest) &&
                       scales[s].rms >= before.rms && scales[s].largest >= before.largest;
    if (!rises) return "have errors that do not rise as the levels fall";
  }
  return {};
}

}  // namespace

std::string tessellation_difference(const DrawTessellation& of, const Scene& scene) {
  const Draw& draw = scene.draws[of.draw];
  const Material* material = scene.material_of(draw);
  if (draw.topology != Topology::triangles || draw.full().vertices->find("POSITION") == nullptr)
    return "are of a draw without triangles";
  if (material == nullptr || !material->displacement) return "are of a draw that nothing displaces";
  const std::size_t triangles = draw.full().stream().triangle_count();
  if (of.levels.size() != triangles) return fmt::format("are of {} triangles, not {}", of.levels.size(), triangles);
  if (std::string why = difference(of.scales, of.levels.view()); !why.empty()) return why;
  const auto begins = of.range_begins.view();
  if (begins.size() != of.ranges.size() || (triangles > 0 && (begins.empty() || begins[0] != 0)))
    return "do not have a displacement range for each triangle";
  for (std::size_t r = 0; r < begins.size(); ++r) {
    const bool is_rising = begins[r] < triangles && (r == 0 || begins[r] > begins[r - 1]);
    const DisplacementRange& range = of.ranges.view()[r];
    const bool is_range = std::isfinite(range.least) && std::isfinite(range.most) && range.least <= range.most;
    if (!is_rising || !is_range) return fmt::format("have an invalid displacement range: number {}", r);
  }
  return {};
}

namespace {

/// Of draws of one mesh: an edge has one level.
std::string disagreement(std::span<const DrawTessellation* const> draws, const Scene& scene) {
  std::vector<std::vector<glm::vec3>> positions;
  std::vector<HeightPart> parts;
  std::vector<LogLevels> levels;
  for (const DrawTessellation* of : draws) {
    positions.push_back(decode_vec3(*scene.draws[of->draw].full().vertices->find("POSITION")));
    levels.insert(levels.end(), of->levels.view().begin(), of->levels.view().end());
  }
  for (std::size_t i = 0; i < draws.size(); ++i)
    parts.push_back({.positions = positions[i], .indices = scene.draws[draws[i]->draw].full().stream().indices.view()});
  const std::vector<std::uint32_t> edges = shared_edges(parts);
  for (std::size_t edge = 0; edge < edges.size(); ++edge) {
    if (levels[edge / 3][edge % 3] != levels[edges[edge] / 3][edges[edge] % 3])
      return fmt::format("do not agree on an edge of triangle {}", edge / 3);
  }
  return {};
}

/// Those of stored draws that are in a mesh together, by the first mesh that has them.
std::vector<std::vector<const DrawTessellation*>> by_mesh(const StoredTessellations& stored, const Scene& scene) {
  std::map<DrawId, std::size_t> mesh_of;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    for (const DrawId draw : scene.meshes[m].draws) mesh_of.try_emplace(draw, m);
  }
  std::map<std::size_t, std::vector<const DrawTessellation*>> together;
  for (const DrawTessellation& of : stored.draws) {
    const auto found = mesh_of.find(of.draw);
    together[found == mesh_of.end() ? scene.meshes.size() + of.draw : found->second].push_back(&of);
  }
  std::vector<std::vector<const DrawTessellation*>> result;
  for (auto& [mesh, draws] : together) result.push_back(std::move(draws));
  return result;
}

}  // namespace

std::string tessellation_disagreement(const StoredTessellations& stored, const Scene& scene) {
  for (const auto& draws : by_mesh(stored, scene)) {
    if (std::string why = disagreement(draws, scene); !why.empty())
      return "those of " + scene.draws[draws.front()->draw].name + ' ' + why;
  }
  return {};
}

}  // namespace foredraw
