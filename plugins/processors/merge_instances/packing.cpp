#include "packing.h"

#include "slot_cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace foredraw::processors::merge_instances {

namespace {

constexpr std::uint32_t nowhere = ~std::uint32_t{0};
constexpr std::size_t at_once = 4096;  ///< placements that a task looks at

/// A mesh in the index buffer.
struct PlacedSlots {
  SlotCuts cuts;
  std::uint32_t frequency = 0;
  std::array<std::uint32_t, 2> offset{nowhere, nowhere};  ///< plain, mirrored
};

void check(const PackedMesh& mesh) {
  const std::string name(mesh.name);
  if (mesh.indices.size() % 3 != 0)
    throw std::invalid_argument(name + ": the number of its indices is not a multiple of 3");
  if (std::uint64_t{mesh.first_vertex} + mesh.vertices > std::uint64_t{1} << 32) {
    throw std::invalid_argument(
        name + ": with it the vertex buffer has more vertices than 32 bits can number; merge fewer meshes together");
  }
  for (const std::uint32_t index : mesh.indices) {
    if (index >= mesh.vertices) {
      throw std::invalid_argument(name + ": index " + std::to_string(index) + " is not below its " +
                                  std::to_string(mesh.vertices) + " vertices");
    }
  }
}

void write_slots(const PackedMesh& mesh, const PlacedSlots& slots, bool is_mirrored, std::uint32_t* to) {
  for (std::size_t s = 0; s < slots.cuts.slots(); ++s) {
    std::uint32_t* entry = to + s * slots.frequency;
    for (std::uint32_t i = slots.cuts.first[s]; i < slots.cuts.first[s + 1]; i += 3, entry += 3) {
      entry[0] = mesh.first_vertex + mesh.indices[i];
      entry[1] = mesh.first_vertex + mesh.indices[i + (is_mirrored ? 2 : 1)];
      entry[2] = mesh.first_vertex + mesh.indices[i + (is_mirrored ? 1 : 2)];
    }
    std::fill(entry, to + (s + 1) * slots.frequency, entry[-1]);
  }
}

MergedTransform packed(const glm::mat4& world) {
  MergedTransform rows;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) rows[static_cast<std::size_t>(4 * row + column)] = world[column][row];
  }
  return rows;
}

/// Each mesh is cut, and what is placed is given room in the index buffer.
std::vector<PlacedSlots> cut_meshes(std::span<const PackedMesh> meshes,
                                    std::span<const std::array<std::uint8_t, 2>> is_placed,
                                    const FrequencyChoice& frequencies, const PackOptions& options,
                                    const Executor& executor, std::uint64_t& entries) {
  std::vector<PlacedSlots> slots(meshes.size());
  executor.for_each(meshes.size(), [&](std::size_t m) {
    if ((is_placed[m][0] | is_placed[m][1]) == 0) return;
    check(meshes[m]);
    if (meshes[m].indices.empty()) return;
    slots[m].frequency = frequencies.frequencies.at(frequencies.mesh_class[m]);
    slots[m].cuts = options.cut_well ? cut_slots(meshes[m].indices, meshes[m].vertices, slots[m].frequency)
                                     : cut_evenly(meshes[m].indices, meshes[m].vertices, slots[m].frequency);
  });
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    const std::uint64_t own = slots[m].cuts.slots() * slots[m].frequency;
    for (std::size_t side = 0; side < 2 && own > 0; ++side) {
      if (is_placed[m][side] == 0) continue;
      if (entries + own > options.most_entries) {
        throw std::length_error(std::string(meshes[m].name) + ": with it the merged index buffer has " +
                                std::to_string(entries + own) + " entries, of at most " +
                                std::to_string(options.most_entries) + "; merge fewer meshes together");
      }
      slots[m].offset[side] = static_cast<std::uint32_t>(entries);
      entries += own;
    }
  }
  return slots;
}

/// What a group comes to: how many slots of each class.
using ClassSlots = std::array<std::uint64_t, 4>;

/// Draws of a group, each with as many slots as offsets reach.
void add_draws(std::uint32_t group, const ClassSlots& own, const FrequencyChoice& frequencies,
               const PackOptions& options, std::uint64_t& slots, std::vector<MergedDraw>& draws) {
  for (std::size_t k = 0; k < frequencies.frequencies.size(); ++k) {
    const std::uint32_t frequency = frequencies.frequencies[k];
    const std::uint64_t most = std::max<std::uint64_t>(1, options.most_entries / frequency);
    for (std::uint64_t done = 0; done < own[k]; done += most) {
      const std::uint64_t count = std::min(most, own[k] - done);
      if (slots + count > std::numeric_limits<std::uint32_t>::max()) {
        throw std::length_error(
            "the merged draws need more slots than 32 bits can number; merge fewer instances together");
      }
      draws.push_back({group, frequency, static_cast<std::uint32_t>(slots), static_cast<std::uint32_t>(count)});
      slots += count;
    }
  }
}

}  // namespace

Placing placing_of(const glm::mat4& world) {
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      if (!std::isfinite(world[column][row])) return Placing::not_finite;
    }
  }
  if (world[0][3] != 0 || world[1][3] != 0 || world[2][3] != 0 || world[3][3] != 1) return Placing::not_affine;
  const auto axis = [&](int column) { return glm::dvec3(world[column][0], world[column][1], world[column][2]); };
  const glm::dvec3 x = axis(0), y = axis(1), z = axis(2);
  const double volume = x.x * (y.y * z.z - y.z * z.y) + x.y * (y.z * z.x - y.x * z.z) + x.z * (y.x * z.y - y.y * z.x);
  const auto squared = [](const glm::dvec3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; };
  const double box = std::sqrt(squared(x)) * std::sqrt(squared(y)) * std::sqrt(squared(z));
  // Elements are floats: below this part of the box that the axes could span, the sign is their rounding's.
  if (!(std::abs(volume) > 1e-6 * box)) return Placing::singular;
  return volume < 0 ? Placing::mirrored : Placing::plain;
}

std::string_view to_text(Placing placing) {
  switch (placing) {
    case Placing::plain: return "plain";
    case Placing::mirrored: return "mirrored";
    case Placing::singular: return "its transform is singular";
    case Placing::not_finite: return "its transform is not finite";
    case Placing::not_affine: return "its transform is not affine";
  }
  return "";
}

PackedInstances pack_instances(std::span<const PackedMesh> meshes, std::span<const PlacedMesh> placed,
                               const SpatialGroups& groups, const FrequencyChoice& frequencies,
                               const PackOptions& options, const Executor& executor) {
  PackedInstances result;
  const std::vector<std::uint32_t>& first = groups.first;
  const std::size_t group_count = groups.size();
  std::vector<std::array<std::uint8_t, 2>> is_placed(meshes.size());
  std::vector<std::uint8_t> is_mirrored(placed.size());
  std::vector<Placing> placings(placed.size());
  executor.for_each((placed.size() + at_once - 1) / at_once, [&](std::size_t task) {
    const std::size_t end = std::min(placed.size(), (task + 1) * at_once);
    for (std::size_t p = task * at_once; p < end; ++p) placings[p] = placing_of(placed[p].world);
  });
  for (const std::uint32_t p : groups.instances) {
    const Placing placing = placings[p];
    if (placing != Placing::plain && placing != Placing::mirrored) {
      throw std::invalid_argument(std::string(meshes[placed[p].mesh].name) +
                                  " cannot be merged: " + std::string(to_text(placing)));
    }
    is_mirrored[p] = placing == Placing::mirrored;
    is_placed[placed[p].mesh][is_mirrored[p]] = 1;
    result.mirrored += is_mirrored[p];
  }
  std::uint64_t entries = 0;
  const std::vector<PlacedSlots> cut = cut_meshes(meshes, is_placed, frequencies, options, executor, entries);
  result.indices.resize(entries);
  executor.for_each(meshes.size(), [&](std::size_t m) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (cut[m].offset[side] == nowhere) continue;
      write_slots(meshes[m], cut[m], side == 1, result.indices.data() + cut[m].offset[side]);
    }
  });

  // Instances by mesh in each group, and how many slots that makes.
  result.placed = groups.instances;
  result.transforms.resize(groups.instances.size());
  std::vector<ClassSlots> own(group_count);
  executor.for_each(group_count, [&](std::size_t g) {
    std::sort(result.placed.begin() + first[g], result.placed.begin() + first[g + 1],
              [&](std::uint32_t a, std::uint32_t b) {
                return placed[a].mesh != placed[b].mesh ? placed[a].mesh < placed[b].mesh : a < b;
              });
    own[g] = {};
    for (std::uint32_t i = first[g]; i < first[g + 1]; ++i) {
      const PlacedMesh& at = placed[result.placed[i]];
      result.transforms[i] = packed(at.world);
      if (cut[at.mesh].cuts.slots() > 0) own[g][frequencies.mesh_class[at.mesh]] += cut[at.mesh].cuts.slots();
    }
  });
  std::uint64_t slots = 0;
  std::vector<std::uint64_t> first_slot;
  for (std::uint32_t g = 0; g < group_count; ++g) {
    first_slot.push_back(slots);
    add_draws(g, own[g], frequencies, options, slots, result.draws);
    result.groups.push_back({groups.bounds[g].min, groups.bounds[g].max, first[g], first[g + 1] - first[g]});
  }
  result.slots.resize(slots);
  std::vector<std::array<std::uint64_t, 4>> counts(group_count);
  executor.for_each(group_count, [&](std::size_t g) {
    std::array<std::uint64_t, 4> next{};  // where each class goes on
    std::uint64_t at = first_slot[g];
    for (std::size_t k = 0; k < 4; ++k) {
      next[k] = at;
      at += own[g][k];
    }
    for (std::uint32_t i = first[g]; i < first[g + 1]; ++i) {
      const std::uint32_t p = result.placed[i];
      const PlacedSlots& mesh = cut[placed[p].mesh];
      std::uint64_t& to = next[frequencies.mesh_class[placed[p].mesh]];
      const std::uint32_t offset = mesh.offset[is_mirrored[p]];
      for (std::size_t s = 0; s < mesh.cuts.slots(); ++s) {
        result.slots[to++] = {offset + static_cast<std::uint32_t>(s) * mesh.frequency, i};
      }
      const std::uint64_t drawn = meshes[placed[p].mesh].indices.size();
      counts[g][0] += drawn;
      counts[g][1] += mesh.cuts.slots() * mesh.frequency - drawn;
      counts[g][2] += mesh.cuts.fetched;
      counts[g][3] += mesh.cuts.fetched_plain;
    }
  });
  for (const auto& [drawn, padding, fetched, fetched_plain] : counts) {
    result.drawn_entries += drawn;
    result.padded_entries += padding;
    result.fetched += fetched;
    result.fetched_plain += fetched_plain;
  }
  return result;
}

}  // namespace foredraw::processors::merge_instances
