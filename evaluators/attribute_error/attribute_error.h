#pragma once
// How far what a surface carries (texture coordinates, normals) is from that of another one that it stands for.

#include <foredraw/analysis/closest_points.h>
#include <foredraw/analysis/sampled.h>
#include <foredraw/base/parallel.h>

#include <cstdint>
#include <optional>

namespace foredraw {

struct AttributeErrorOptions {
  int samples = 10000;  ///< points on each surface, from 1 on
};

/// A surface with what each vertex carries: as many as positions, or none at all.
struct AttributedSurface {
  Surface surface;
  std::span<const glm::vec3> uvs;  ///< the third one is 0
  std::span<const glm::vec3> normals;
};

/// Root mean squares over points; nothing where one of the surfaces does not carry it, or no point has it.
struct OneWayAttributeError {
  std::optional<Sampled> uv;      ///< distance in the texture's square of 1 by 1
  std::optional<Sampled> normal;  ///< angle in degrees
};

struct AttributeError {
  OneWayAttributeError to_original, from_original;

  /// Both surfaces weigh the same.
  std::optional<Sampled> uv() const;
  std::optional<Sampled> normal() const;
};

/// What points of one surface, spread evenly by area, carry is compared with what the nearest point of the other one
/// does, both between corners as a renderer has it; normals are made to have length 1. Points where a number is not
/// finite, or where a normal has no length, do not count. Nothing where one of the surfaces, and not the other, has no
/// triangle with finite positions. The same at any number of threads.
std::optional<AttributeError> attribute_error(const AttributedSurface& changed, const AttributedSurface& original,
                                              const AttributeErrorOptions& options, std::uint64_t seed,
                                              const Executor& executor);

struct Plugin;
Plugin attribute_error_plugin();

}  // namespace foredraw
