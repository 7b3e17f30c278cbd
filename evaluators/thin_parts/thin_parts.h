#pragma once
// How much of a scene is thinner than a pixel, and what ways against jagged edges may make of it.

#include <foredraw/frames/reference_renderer.h>

#include <vector>

namespace foredraw {

/// What is seen in one frame, by its width on the screen: the shortest way across, to right and left, up and down or
/// diagonally, until there is nothing, or something far nearer or farther away.
class SeenWidths {
 public:
  /// Samples along each edge of a pixel.
  static constexpr int samples = 8;
  /// Widths from here on are one.
  static constexpr int most_pixels = 16;

  SeenWidths() : counts_(std::size_t{samples * most_pixels} + 1) {}

  void add(double pixels);
  void add(const SeenWidths& other);

  double seen() const;                       ///< samples
  double thinner_than(double pixels) const;  ///< of these, those narrower than that
  /// The width that so large a part of all is narrower than, in pixels.
  double width_of(double part) const;

 private:
  std::vector<double> counts_;  // [width in samples, rounded down]
};

/// What is narrower than 1 / SeenWidths::samples pixel may fall between all samples, and is not seen then.
SeenWidths seen_widths(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera, FrameSize size);

/// Parts of the surface of all meshes, each as often as nodes show it, in the scene's units at rest.
struct SurfaceShares {
  double area = 0;
  double closed = 0;  ///< of bodies whose triangles share every edge, welded by positions over the draws of a mesh
  double wires = 0;   ///< of triangles that know of a wire
};
SurfaceShares surface_shares(const FrameScene& scene, const FrameMoment& moment);

struct Plugin;
Plugin thin_parts_plugin();

}  // namespace foredraw
