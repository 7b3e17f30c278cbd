#pragma once
// Measure once, ask often: a subject is drawn once and what lies behind what is kept, so that the overdraw of any order
// of its triangles can be counted without drawing again.

#include <foredraw/base/parallel.h>
#include <foredraw/overdraw/layers.h>
#include <foredraw/scene/views.h>
#include <foredraw/viewing/raster_part.h>

#include <optional>

namespace foredraw {

/// For every view and every pixel with two layers or more the triangles of all parts front to back, numbered through as
/// the index streams are now; pixels with one layer are only counted. They judge any order, parts mixed as one likes.
struct FragmentLayers : Layers {};

inline constexpr std::size_t default_layer_bytes = std::size_t{256} << 20;

/// Draws the parts from every view as for_each_fragment() does, into pictures of views.size x views.size pixels. Views
/// are shared out over the threads; the layers are the same however they are. Nothing where they would take more than
/// `most_bytes`, or where the fragments of a single view would: who asked draws every order then. Each thread works in
/// a few times the fragments of one view besides. O(views * (triangles + fragments * log fragments)).
std::optional<FragmentLayers> fragment_layers(std::span<const RasterPart> parts, const Views& views,
                                              const Executor& executor, std::size_t most_bytes = default_layer_bytes);

}  // namespace foredraw
