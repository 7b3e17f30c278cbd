#pragma once
// A displaced draw of a scene as plain triangles, finely and less finely divided.

#include <foredraw/displaced/scene_displacement.h>
#include <foredraw/displaced/tessellation_pattern.h>
#include <foredraw/scene/vertex_streams.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

struct DivisionOptions {
  std::optional<float> parts;    ///< of every edge; none: levels that are stored, or by texels
  std::optional<double> texels;  ///< of the map along a part of an edge, at least
  TessellationSpacing spacing = TessellationSpacing::equal;
  int most = 4'000'000;  ///< triangles
  int levels = 1;        ///< of detail that come out, 1 and up
};

struct DividedLevel {
  std::shared_ptr<const VertexStreams> vertices;  ///< the finest level's, wherever its points are among them
  std::vector<std::uint32_t> indices;
};

struct DividedDraw {
  std::vector<DividedLevel> levels;   ///< from fine to coarse; fewer than asked for, where all edges are in one part
  std::vector<std::uint32_t> source;  ///< [triangle of the finest] that of the draw
};

/// The draw's full detail, divided as the options say and moved by its map or its baked heights. Or why it cannot be,
/// as the rest of a sentence.
std::variant<DividedDraw, std::string> divided_draw(const Scene& scene, DrawId draw, const DivisionOptions& options,
                                                    Analyses& analyses);

}  // namespace foredraw
