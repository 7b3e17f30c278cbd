#pragma once
#include <foredraw/viewing/raster_part.h>

#include <optional>
#include <span>

namespace foredraw {

/// Where no order overdraws more than that there is no order to be looked for.
inline constexpr double least_overdraw = 1.001;

/// What no order of the triangles overdraws more than: fragments shaded over pixels covered, in the mean over all
/// orthographic views. Nothing where it is above `most`, which is found out after a few triangles of most meshes.
///
/// A triangle on the convex hull that faces outwards is hidden by nothing, and two of them never cover the same pixel.
/// In the mean over all views a face covers a quarter of its area (Cauchy 1841), so that pixels covered are at least a
/// quarter of the area on the hull, fragments at most a quarter of the whole area, of double-sided parts twice that. A
/// convex surface has the bound 1; a ball with a knob little more. Triangles within a millionth of the diameter of the
/// hull count as on it; those of parts with holes do not. O(n log n).
std::optional<double> overdraw_bound(std::span<const RasterPart> parts, double most);

}  // namespace foredraw
