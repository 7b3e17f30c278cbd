#pragma once
// Ways from the coarsest levels of a mesh to the finest ones. Each step has a threshold; the lower it is, the finer are
// the levels, and none ever becomes coarser on the way.

#include "height_deviations.h"

#include <foredraw/displaced/tessellation_levels.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace foredraw {

/// What is taken: all steps above a threshold, and those at it of the first `ties` triangles.
struct LadderPlace {
  float threshold = 0;
  std::uint32_t ties = 0;
};

class LevelLadder {
 public:
  virtual ~LevelLadder() = default;
  /// Replaces `levels`: [triangle].
  virtual void at(const LadderPlace& place, std::vector<LogLevels>& levels) const = 0;
  /// Above all thresholds: nothing is divided there.
  virtual float top() const = 0;
};

/// What deviations are to be kept low of.
enum class LevelGoal : std::uint8_t { rms, largest };

/// Each triangle by what it gains. `rms`: the squared error that a step takes away, over the triangles that it adds,
/// along the lower convex hull of both; so any place of the ladder has the least error that so many triangles can have,
/// as far as triangles stand alone. `largest`: a triangle becomes finer as long as its largest deviation is above the
/// threshold and falls by an eighth. An edge takes the smaller level of its triangles (rms) or the larger one
/// (largest). `edges`: shared_edges().
std::unique_ptr<LevelLadder> content_ladder(std::span<const std::array<HeightDeviation, level_count>> deviations,
                                            std::span<const float> shares, std::span<const std::uint8_t> finest,
                                            std::span<const std::uint32_t> edges, std::span<const std::uint8_t> limits,
                                            LevelGoal goal, std::uint64_t most_added);

/// Each edge by its length, as engines do it; inside as the finest edge.
std::unique_ptr<LevelLadder> edge_length_ladder(std::span<const HeightPart> parts);

/// All alike.
std::unique_ptr<LevelLadder> constant_ladder(std::size_t triangles);

/// [3t + e] of edge e of triangle t, over all parts: the first edge between the same two positions, its own number
/// where it is the first. Seams of the texture and of parts do not part edges.
std::vector<std::uint32_t> shared_edges(std::span<const HeightPart> parts);

/// [3t + e] log2 of the most parts of an edge, of which each is usual_texels_per_part long on the shorter of its sides:
/// at more of them a repaired seam need not be closed. `edges`: shared_edges().
std::vector<std::uint8_t> edge_limits(std::span<const HeightPart> parts, std::span<const std::uint32_t> edges);

}  // namespace foredraw
