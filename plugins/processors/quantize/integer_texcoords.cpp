#include "integer_texcoords.h"

#include "lattices.h"

#include <foredraw/geometry/box.h>
#include <foredraw/geometry/finite.h>
#include <foredraw/geometry/joined_sets.h>
#include <foredraw/scene/scaled_texcoords.h>

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace foredraw {

namespace {

constexpr std::uint32_t most_sets = 32;                 // as many as a VertexNeeds can tell apart
constexpr double most_exact = 0x1p24;                   // whole numbers up to it are floats
constexpr double most_wide = 65535, most_narrow = 255;  // that 16 and 8 bits hold

std::string semantic_of(std::uint32_t set) { return "TEXCOORD_" + std::to_string(set); }

std::span<const glm::vec2> coordinates_of(const VertexStream& stream) {
  return {reinterpret_cast<const glm::vec2*>(stream.bytes.view().data()), stream.count()};
}

using UvBox = Box<glm::dvec2>;

/// Nothing where one is not finite.
std::optional<UvBox> box_of(std::span<const glm::vec2> coordinates) {
  UvBox box;
  for (const glm::vec2& uv : coordinates) {
    if (!is_finite(uv)) return std::nullopt;
    box.add(glm::dvec2(uv));
  }
  return box;
}

/// The vertices' coordinates of a set, where they can be whole numbers.
const VertexStream* fit_stream(const VertexStreams& vertices, const std::string& semantic) {
  for (const auto& target : vertices.morph_targets) {
    if (std::ranges::find(target, semantic, &VertexStream::semantic) != target.end()) return nullptr;
  }
  const VertexStream* stream = vertices.find(semantic);
  const bool is_fit = stream != nullptr && stream->format == Format{Component::float32, 2, false, 8} &&
                      stream->count() == vertices.count && vertices.count > 0;
  return is_fit ? stream : nullptr;
}

std::optional<TexcoordGrid> grid_of(std::uint32_t set, const UvBox& box, double step) {
  const glm::dvec2 first = glm::round(box.min / step), last = glm::round(box.max / step);
  const double farthest = std::max({std::abs(first.x), std::abs(first.y), std::abs(last.x), std::abs(last.y)});
  const double steps = std::max(last.x - first.x, last.y - first.y);
  constexpr double most_of_step = 1 << step_bits;
  if (!(steps <= most_wide) || !(farthest * most_of_step <= most_exact)) return std::nullopt;
  return TexcoordGrid{set, step, first, steps > most_narrow};
}

/// Who hangs together by one set: groups, and behind them materials.
class Joining {
 public:
  Joining(const Scene& scene, std::span<const VertexGroup> groups, std::uint32_t set)
      : groups_(groups), set_(set), joined_(groups.size() + scene.materials.size()) {
    stays_.resize(groups.size() + scene.materials.size());
    for (std::uint32_t g = 0; g < groups.size(); ++g) number_of_[groups[g].vertices.get()] = g;
    find_streams();
    for (std::uint32_t m = 0; m < scene.materials.size(); ++m) {
      const Material& material = scene.materials[m];
      const bool is_looked_up = material.needs && (material.needs->texcoords >> set & 1u) != 0;
      if (!is_looked_up || material.keeps_spaces) keep(of_material(m));
    }
    for (const Draw& draw : scene.draws) join(draw);
  }

  void put(IntegerTexcoords& planned, double step) {
    std::vector<UvBox> boxes(stays_.size());
    std::vector<bool> stay(stays_.size());
    for (std::uint32_t one = 0; one < stays_.size(); ++one) {
      const std::uint32_t whole = joined_.of(one);
      if (stays_[one]) stay[whole] = true;
      if (one >= groups_.size() || !boxes_[one]) continue;
      boxes[whole].add(*boxes_[one]);
    }
    for (std::uint32_t one = 0; one < stays_.size(); ++one) {
      const std::uint32_t whole = joined_.of(one);
      if (stay[whole] || boxes[whole].is_empty()) continue;
      const auto grid = grid_of(set_, boxes[whole], step);
      if (!grid) continue;
      auto& list = one < groups_.size() ? planned.of_groups[one] : planned.of_materials[one - groups_.size()];
      list.push_back(*grid);
    }
  }

 private:
  std::uint32_t of_material(MaterialId m) const { return static_cast<std::uint32_t>(groups_.size()) + m; }
  void keep(std::uint32_t one) { stays_[one] = true; }

  /// Groups that hold the same block of memory have one grid, so that a file has it once.
  void find_streams() {
    boxes_.resize(groups_.size());
    const std::string semantic = semantic_of(set_);
    std::map<const std::byte*, std::uint32_t> first;
    for (std::uint32_t g = 0; g < groups_.size(); ++g) {
      const VertexStream* stream = fit_stream(*groups_[g].vertices, semantic);
      if (stream == nullptr) continue;
      const auto [same, is_new] = first.try_emplace(stream->bytes.view().data(), g);
      joined_.join(same->second, g);
      boxes_[g] = is_new ? box_of(coordinates_of(*stream)) : boxes_[same->second];
    }
  }

  void join(const Draw& draw) {
    for (const Level& level : draw.levels) {
      const auto number = number_of_.find(level.vertices.get());
      const bool may_change = number != number_of_.end() && boxes_[number->second];
      if (may_change && draw.material) {
        joined_.join(number->second, of_material(*draw.material));
      } else if (may_change) {
        keep(number->second);
      } else if (draw.material) {
        keep(of_material(*draw.material));
      }
    }
  }

  std::span<const VertexGroup> groups_;
  std::uint32_t set_;
  JoinedSets joined_;
  std::vector<bool> stays_;                  ///< [group, then material]
  std::vector<std::optional<UvBox>> boxes_;  ///< [group] of coordinates that can be whole numbers
  std::map<const VertexStreams*, std::uint32_t> number_of_;
};

template <class T>
VertexStream whole_numbers(const VertexStream& from, const TexcoordGrid& grid, double& farthest) {
  const std::span<const glm::vec2> coordinates = coordinates_of(from);
  std::vector<T> made;
  made.reserve(2 * coordinates.size());
  const glm::vec2 offset(grid.first * grid.step);
  const auto scale = static_cast<float>(grid.step);
  for (const glm::vec2& uv : coordinates) {
    const glm::dvec2 number = glm::round(glm::dvec2(uv) / grid.step) - grid.first;
    const T u = static_cast<T>(number.x), v = static_cast<T>(number.y);
    made.push_back(u);
    made.push_back(v);
    const glm::vec2 seen = offset + scale * glm::vec2(u, v);
    const glm::dvec2 off = glm::dvec2(seen) - glm::dvec2(uv);
    farthest = std::max(farthest, off.x * off.x + off.y * off.y);
  }
  const auto bytes = std::as_bytes(std::span(made));
  const Component component = sizeof(T) == 1 ? Component::uint8 : Component::uint16;
  return {from.semantic, {component, 2, false, 2 * sizeof(T)}, Shared<std::byte>({bytes.begin(), bytes.end()})};
}

}  // namespace

IntegerTexcoords find_integer_texcoords(const Scene& scene, std::span<const VertexGroup> groups, double tolerance) {
  IntegerTexcoords planned;
  planned.of_groups.resize(groups.size());
  planned.of_materials.resize(scene.materials.size());
  if (!(tolerance > 0) || !scene.products.empty()) return planned;
  std::uint32_t looked_up = 0;
  for (const Material& material : scene.materials) looked_up |= material.needs ? material.needs->texcoords : 0;
  for (std::uint32_t set = 0; set < most_sets; ++set) {
    if (looked_up >> set & 1u) Joining(scene, groups, set).put(planned, grid_step(tolerance, 2));
  }
  return planned;
}

IntegerVertices with_integer_texcoords(const VertexStreams& vertices, std::span<const TexcoordGrid> grids) {
  auto made = std::make_shared<VertexStreams>(vertices);
  double farthest = 0;
  for (const TexcoordGrid& grid : grids) {
    const auto stream = std::ranges::find(made->base, semantic_of(grid.set), &VertexStream::semantic);
    *stream = grid.is_wide ? whole_numbers<std::uint16_t>(*stream, grid, farthest)
                           : whole_numbers<std::uint8_t>(*stream, grid, farthest);
  }
  return {std::move(made), std::sqrt(farthest)};
}

void scale_textures(std::vector<Material>& materials, const IntegerTexcoords& planned) {
  for (std::size_t m = 0; m < materials.size(); ++m) {
    for (const TexcoordGrid& grid : planned.of_materials[m])
      materials[m] = with_scaled_texcoords(std::move(materials[m]), grid.scaled());
  }
}

}  // namespace foredraw
