#pragma once
// All draws of a scene packed: those that are seen together by one lattice.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/packing/packed_precision.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace foredraw::processors::vertex_pack {

/// Of surfaces of which the scene says nothing: of cloth, skin and worn metal.
inline constexpr double usual_displacement = 0.002, usual_slope = 0.2;

enum class NormalMethod { octahedral, spherical };

struct PackOptions {
  NormalMethod method = NormalMethod::octahedral;
  std::optional<double> displacement;  ///< the largest one along normals, as part of the box's diagonal; nothing: what
                                       ///< materials say, else usual_displacement
  std::optional<double> slope;      ///< the largest one of its height, in diagonals for 1 of uv; nothing: that of the
                                    ///< materials' maps, else usual_slope
  double most_angle_error = 0.065;  ///< of normals, and of tangents at right angles to them; degrees
  double most_uv_error = 0.5;       ///< texels of 4096: draws that can not keep it are not packed
  double margin = 0.02;             ///< around the posed box, on each side, as part of its extent
};

struct PackedDraw {
  PackedVertices::OfDraw packed;
  PackedBounds bounds;             ///< of the rows
  double diagonal = 0;             ///< of the box that the rows' lattice was made for
  double posed_diagonal = 0;       ///< 0: nothing moves it
  std::uint64_t no_direction = 0;  ///< vertices with a normal or tangent of no direction
  std::string plain;               ///< what stays in plain streams: "COLOR_0, JOINTS_0"; may be empty
};

struct NotPacked {
  DrawId draw = 0;
  std::string why;  ///< whole sentence without a full stop
};

struct PackedScene {
  std::vector<PackedDraw> draws;    ///< rising
  std::vector<NotPacked> left_out;  ///< rising
};

/// Packs these draws, rising. Lattices are those of all draws of a subject, whether they are among these or not. Every
/// vertex of what is packed was measured, and keeps the bounds; std::logic_error otherwise.
PackedScene pack_scene(const Scene& scene, std::span<const DrawId> draws, SubjectUnit unit, const Poses& poses,
                       const PackOptions& options, Analyses& analyses, const Executor& executor);

}  // namespace foredraw::processors::vertex_pack
