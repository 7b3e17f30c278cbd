#pragma once
// Overdraw counted along rays, with as many samples in a pixel as one likes.

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/overdraw_count.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <cstdint>
#include <span>

namespace foredraw {

struct OverdrawEmbreeOptions {
  int samples = 1;         ///< in each pixel: one in its middle, or more at random places; 1 to 1024
  std::uint64_t seed = 0;  ///< of random places
};

/// Sends a ray through every sample of pictures of views.size x views.size pixels that just hold the bounding sphere of
/// all parts, and counts along it what passes a depth test `less` when parts and triangles are drawn one after the
/// other. Counts are of samples. Size 16 to 4096; distance 0 (orthographic), or 1.01 and more.
///
/// A ray hits a triangle where its sample is inside (top-left rule), exactly, once the corners are snapped to 2^-18
/// pixel. Embree proposes triangles and does not judge them, so its floats leave no trace in the counts: they are the
/// same on every machine. Depth is along the axis of view; that of the corners, and then of the hit, is quantised to
/// 2^-24 of the sphere's diameter. Triangles that repeat a corner or have no area in the picture are never hit, nor are
/// those with a position that is not finite.
///
/// Views are shared out over the threads; the counts are the same however they are. O(triangles log triangles) once,
/// and for each view O(positions + samples * (log triangles + hits)). Throws std::runtime_error where Embree refuses.
OverdrawCounts overdraw_embree(std::span<const RasterPart> parts, const Views& views,
                               const OverdrawEmbreeOptions& options = {}, const Executor& executor = Executor(1));

struct Plugin;
Plugin overdraw_embree_plugin();

}  // namespace foredraw
