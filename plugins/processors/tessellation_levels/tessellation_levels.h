#pragma once
// How finely to divide the triangles of a displaced mesh, by what the map of heights shows on them.

#include "height_deviations.h"
#include "level_ladder.h"

#include <foredraw/base/parallel.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

enum class LevelMethod : std::uint8_t { content, edge_length, constant };

/// With both limits, the error is met as far as the triangles allow. Without any, levels are the finest that gain
/// something. More than 2^32 - 1 triangles are never made.
struct TessellationLimits {
  std::optional<std::uint64_t> triangles;  ///< that the tessellator may make of the mesh
  std::optional<double> error;             ///< as the goal says, in units
  LevelGoal goal = LevelGoal::rms;
};

/// Of the whole mesh.
struct MeshTessellation {
  std::uint64_t triangles = 0;
  double rms = 0, largest = 0;  ///< deviations, in units
};

struct ChosenLevels {
  std::vector<LogLevels> levels;                       ///< [triangle], part by part
  std::vector<std::vector<TessellationScale>> scales;  ///< [part] as DrawTessellation has them
  MeshTessellation plain;                              ///< nothing divided
  MeshTessellation chosen;
};

/// Levels of a mesh. Triangles that share an edge, by positions, agree on its level, also along seams of the texture
/// and of parts. Deviations are measured on the pattern that comes of these levels, on every triangle. A limit of
/// triangles is kept unless the mesh itself has more; an error is reached where the map's own density reaches it.
/// O(triangles log(triangles) + samples). At most 150 bytes a triangle beside the answer.
ChosenLevels tessellation_levels(std::span<const HeightPart> parts, LevelMethod method,
                                 const TessellationLimits& limits, const Executor& executor);

/// Into how many triangles levels divide one, with equal spacing.
std::uint32_t triangles_of(const LogLevels& levels);

/// With `scale` taken from each, but not below 0.
LogLevels scaled(const LogLevels& levels, std::uint32_t scale);

struct Plugin;
Plugin tessellation_levels_plugin();

}  // namespace foredraw
