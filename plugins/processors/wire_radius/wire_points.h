#pragma once
// Which triangles and points are a wire's, and where its centre line is for each of them.

#include "wire_run.h"

namespace foredraw::processors::wire_radius {

struct WirePoint {
  std::uint32_t point = none;
  glm::dvec3 to_centre{0};
  glm::dvec3 axis{0};
  double half_width = 0;
  bool is_flat = false;  ///< its section: `to_centre` lies along its breadth, and has a direction in the middle too
};

struct WireParts {
  std::vector<std::uint32_t> triangles;
  std::vector<WirePoint> points;  ///< those of the triangles, each once, or where ribbons cross once for each of them
  std::vector<std::array<std::uint32_t, 3>> corners = {};  ///< [triangle] where in points its own are; empty: no choice
  double beyond = 0;  ///< how far they reach beyond the run's first and last sections, both together
};

/// Gathers what lies along runs of chains. It keeps its buffers from one to the next.
class WirePoints {
 public:
  explicit WirePoints(const WeldedMesh& mesh);

  /// Triangles are those whose corners all lie along the run, and hang together with its sections. A point's centre is
  /// that of the section through it.
  WireParts along(const Chain& chain, const WireRun& run);

 private:
  struct Seen {
    std::uint32_t run = 0;  ///< the number of the call that knows of it
    std::uint32_t section = 0;
    std::uint32_t triangle = none;
    bool is_along = false;
    double beyond = 0;
  };
  const Seen& look_at(std::uint32_t point, std::uint32_t triangle, std::uint32_t near, const Chain& chain,
                      const WireRun& run);
  WirePoint centred(const Seen& seen, std::uint32_t point, const Chain& chain, const WireRun& run);

  const WeldedMesh& mesh_;
  Cutter cutter_;
  std::uint32_t run_ = 0;
  std::vector<Seen> points_;
  std::vector<std::uint32_t> triangles_;  ///< [triangle] the last call that saw it
};

}  // namespace foredraw::processors::wire_radius
