#pragma once
// Small files of which everything can be merged.

#include "framework/io/gltf/edits.h"
#include "support/compressed_gltf.h"
#include "support/merged_draws.h"

#include <foredraw/base/random.h>
#include <foredraw/instances/merged_instances.h>

#include <array>
#include <cstring>

namespace foredraw::testing {

inline constexpr const char* merge_instances_extension = "FOREDRAW_merge_instances";

/// How the attributes lie in the file.
enum class Lay {
  apart,                ///< each in a view of its own
  interleaved,          ///< a vertex's side by side, each mesh in a view
  one_after_the_other,  ///< a view for each attribute, in it the meshes'
};

/// Three meshes of 4, 6 and 8 vertices, 2, 4 and 6 triangles, each placed by three nodes; two materials. Positions are
/// floats that no two vertices share, normals three bytes in rows of four, texture coordinates shorts, and _SIX takes
/// six bytes of rows of eight.
inline GltfBuilder yard(Lay lay = Lay::apart) {
  struct Part {
    const char* semantic;
    const char* type;
    int component;
    bool normalized;
    std::size_t bytes, row, offset;
  };
  static constexpr std::array parts{
      Part{"POSITION", "VEC3", 5126, false, 12, 12, 0}, Part{"NORMAL", "VEC3", 5120, true, 3, 4, 12},
      Part{"TEXCOORD_0", "VEC2", 5123, true, 4, 4, 16}, Part{"_SIX", "VEC3", 5123, false, 6, 8, 20}};
  constexpr std::size_t vertex = 28;
  GltfBuilder builder;
  builder.json["extensionsUsed"] = {"KHR_mesh_quantization"};
  builder.json["extensionsRequired"] = {"KHR_mesh_quantization"};
  for (const char* name : {"brick", "bark"}) builder.add("materials", {{"name", name}});
  Random random(7);
  std::vector<std::byte> rows(18 * vertex);
  for (std::size_t v = 0; v < 18; ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto value = static_cast<float>(random.unit());
      std::memcpy(rows.data() + v * vertex + 4 * c, &value, 4);
    }
    for (std::size_t c = 12; c < 26; ++c) rows[v * vertex + c] = static_cast<std::byte>(1 + random.below(100));
    rows[v * vertex + 15] = std::byte{0};
  }
  const auto taken = [&](const Part& part, std::size_t first, std::size_t count) {
    std::vector<std::byte> bytes(count * part.row);
    for (std::size_t v = 0; v < count; ++v) {
      std::memcpy(bytes.data() + v * part.row, rows.data() + (first + v) * vertex + part.offset, part.bytes);
    }
    return bytes;
  };
  std::array<std::size_t, 4> views{};
  for (std::size_t a = 0; a < 4 && lay == Lay::one_after_the_other; ++a) {
    views[a] = builder.add_view(taken(parts[a], 0, 18), parts[a].row);
  }
  std::size_t first = 0;
  for (std::size_t m = 0; m < 3; ++m) {
    const std::size_t count = 4 + 2 * m;
    const std::size_t all =
        lay == Lay::interleaved ? builder.add_view(std::span(rows).subspan(first * vertex, count * vertex), vertex) : 0;
    GltfJson primitive{{"attributes", GltfJson::object()}, {"material", m % 2}};
    for (std::size_t a = 0; a < 4; ++a) {
      const Part& part = parts[a];
      if (lay == Lay::apart) views[a] = builder.add_view(taken(part, first, count), part.row);
      const std::size_t view = lay == Lay::interleaved ? all : views[a];
      const std::size_t offset = lay == Lay::interleaved           ? part.offset
                                 : lay == Lay::one_after_the_other ? first * part.row
                                                                   : 0;
      const std::size_t accessor = builder.add_accessor(view, offset, part.component, part.type, count);
      if (part.normalized) builder.json["accessors"][accessor]["normalized"] = true;
      primitive["attributes"][part.semantic] = accessor;
    }
    const auto position = primitive["attributes"]["POSITION"].get<std::size_t>();
    for (const bool least : {true, false}) {
      std::array<float, 3> range{};
      for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t v = 0; v < count; ++v) {
          float value;
          std::memcpy(&value, rows.data() + (first + v) * vertex + 4 * c, 4);
          range[c] = v == 0 ? value : least ? std::min(range[c], value) : std::max(range[c], value);
        }
      }
      builder.json["accessors"][position][least ? "min" : "max"] = range;
    }
    std::vector<std::uint16_t> indices;
    for (std::size_t v = 0; v + 2 < count; ++v) {
      for (std::size_t c = 0; c < 3; ++c) indices.push_back(static_cast<std::uint16_t>(v + c));
    }
    primitive["indices"] = builder.add_values(indices, "SCALAR");
    builder.add("meshes", {{"name", "mesh" + std::to_string(m)}, {"primitives", {primitive}}});
    for (std::size_t n = 0; n < 3; ++n) {
      builder.add("nodes", {{"mesh", m}, {"translation", {m, n, 0.5}}, {"scale", {1, 2, 0.5}}});
    }
    first += count;
  }
  return builder;
}

/// All of it merged.
inline Scene merged_yard(Scene scene, const MergeByHand& how = {}) {
  const MergedInstances merged = merged_by_hand(scene, all_places(scene), how);
  return with_merged(std::move(scene), {merged});
}

}  // namespace foredraw::testing
