#pragma once
// Draws frames on the processor: exact coverage, depth, light and textures, so that choices of levels and renderings
// can be judged by what they look like and by how long they take.

#include <foredraw/frames/frame_moment.h>
#include <foredraw/frames/rendering.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// An object, and how it is drawn. A level above the mesh's coarsest one is that one.
struct DrawnObject {
  std::uint32_t object = 0;
  std::uint32_t level = 0;
  Rendering rendering = Rendering::full;
  friend bool operator==(const DrawnObject&, const DrawnObject&) = default;
};

/// What was done.
struct DrawnWork {
  std::uint64_t draws = 0;
  std::uint64_t triangles = 0;  ///< that were handed over, whether they are seen or not
  std::uint64_t vertices = 0;   ///< that were moved
  std::uint64_t samples = 0;    ///< that were shaded, those that were hidden later too
};
using FrameWork = std::array<DrawnWork, all_renderings.size()>;  ///< [rendering]

/// Linear colours, rows from the top.
struct FramePicture {
  FrameSize size;
  std::vector<glm::vec3> colours;
};

/// What a picture shows.
enum class FrameStyle {
  lit,      ///< light and colours
  levels,   ///< the coarsest level of each mesh black, full detail white
  objects,  ///< red is the object's number in the scene; exact below 2^24
};

/// What is done with wires that have the attributes of wire_radius.h. Those that joints or morph targets move are drawn
/// as they are.
enum class FrameWires : std::uint8_t {
  as_they_are,  ///< like everything else
  widened,      ///< to a pixel at least, and faded
  covering,     ///< so wide that their coverage can be computed in the middle of each pixel that they touch
};

/// How a frame is drawn, where it is not drawn plainly. What is widened and not opaque is drawn after everything
/// opaque: blended, without depth, and before the blended surfaces.
struct FrameDetail {
  FrameWires wires = FrameWires::as_they_are;
  int wire_samples = 1;      ///< of how many pictures this is one that make a pixel's samples, where wires are covering
  bool marks_wires = false;  ///< FrameSamples::wires is filled
  /// With one sample a pixel: a surface is shaded in the pixel's middle where it covers that, and in the sample where
  /// it does not, as renderers do that have several samples a pixel (with centroid interpolation).
  bool shades_middles = false;
  /// [draw] Only the back faces of so many first triangles of full detail are drawn: the second depth. Null: all that
  /// is seen.
  const std::vector<std::uint32_t>* backs_of = nullptr;
};

/// A frame before it is a picture.
struct FrameSamples {
  FrameSize size = {};                  ///< in samples
  glm::dvec2 shift{0};                  ///< as ReferenceRenderer has it
  std::vector<float> nearness = {};     ///< [sample] 1 / distance, rows from below; 0 where nothing is
  std::vector<glm::vec3> colours = {};  ///< [sample]
  std::vector<float> wires = {};        ///< [sample] what share of the colour is a wire's; empty where nobody asked
  FrameWork work = {};
};

/// Works on one thread and keeps its memory from frame to frame.
class ReferenceRenderer {
 public:
  /// Samples along an edge of the picture, at most.
  static constexpr int most_samples = 16384;

  /// `samples`: along each edge of a pixel, 1 to 16. std::invalid_argument where the picture has none, or too many.
  /// `shift`: of the samples from their places in the middles of equal squares, to the right and upwards, in squares:
  /// other shifts are other pictures of the same frame.
  explicit ReferenceRenderer(FrameSize size, int samples = 1, glm::dvec2 shift = {0, 0});

  /// The objects in their sequence, those with blended surfaces last, the farthest first. Nearest objects should come
  /// first: what is hidden then is not shaded.
  void draw(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
            std::span<const DrawnObject> objects, FrameStyle style = FrameStyle::lit, const FrameDetail& detail = {});

  const FrameWork& work() const { return all_.work; }  ///< of the last frame
  FramePicture picture() const;                        ///< the mean of each pixel's samples
  /// [sample] as picture() has colours, rows from below.
  std::span<const glm::vec3> colours() const { return all_.colours; }
  /// [sample] 1 / distance ahead of the camera, rows from below; 0 where nothing is.
  std::span<const float> nearness() const { return all_.nearness; }
  /// [sample] as FrameSamples has them, rows from below.
  std::span<const float> wires() const { return all_.wires; }

 private:
  FrameSize size_;
  int samples_;
  FrameSamples all_;
};

}  // namespace foredraw
