#pragma once
// A ribbon with levels, in each of the ways in which a file can have them.

#include "framework/io/gltf/edits.h"

namespace foredraw::testing {

inline constexpr const char* levels_name = "FOREDRAW_levels";

/// Every `step`th square of a ribbon of eight, as indices.
inline std::vector<std::uint16_t> squares(std::uint16_t step) {
  std::vector<std::uint16_t> indices;
  for (std::uint16_t square = 0; square < 8; square = static_cast<std::uint16_t>(square + step)) {
    const auto v = static_cast<std::uint16_t>(2 * square);
    for (const int corner : {0, 1, 2, 2, 1, 3}) indices.push_back(static_cast<std::uint16_t>(v + corner));
  }
  return indices;
}

/// A node of full detail and two coarser ones, which share its vertices.
inline GltfBuilder with_lods() {
  GltfBuilder builder = ribbon(8);
  for (const std::uint16_t step : {std::uint16_t{2}, std::uint16_t{4}}) {
    GltfJson primitive = builder.json["meshes"][0]["primitives"][0];
    primitive["indices"] = builder.add_values(squares(step), "SCALAR");
    builder.add_mesh(primitive);
  }
  builder.json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = {1, 2};
  builder.json["nodes"][0]["extras"]["MSFT_screencoverage"] = {0.5, 0.2, 0.01};
  builder.json["extensionsUsed"] = {"MSFT_lod"};
  builder.json["scenes"] = {{{"nodes", {0}}}};
  builder.json["scene"] = 0;
  return builder;
}

/// The same as a primitive with FOREDRAW_levels, as the writer says it.
inline Scene with_made_levels() {
  Scene scene = read(ribbon(8));
  Draw& draw = scene.draws[0];
  for (const std::uint16_t step : {std::uint16_t{2}, std::uint16_t{4}}) {
    Level level = draw.full();
    const std::vector<std::uint16_t> narrow = squares(step);
    level.stream().indices = Shared<std::uint32_t>(std::vector<std::uint32_t>(narrow.begin(), narrow.end()));
    level.error = 0.1f * step;
    draw.levels.push_back(std::move(level));
  }
  return scene;
}

}  // namespace foredraw::testing
