#include "openmesh_decimate.h"

#include <foredraw/collapses/surface_fans.h>
#include <foredraw/collapses/unit_frame.h>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModAspectRatioT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModHausdorffT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalDeviationT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Decimater/ModQuadricT.hh>
#include <OpenMesh/Tools/Decimater/ModRoundnessT.hh>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

struct Traits : OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
  using Normal = OpenMesh::Vec3d;
};

/// A mesh of fans that asks the recorder which collapses are right: the decimater asks here right before each.
class FanMesh : public OpenMesh::TriMesh_ArrayKernelT<Traits> {
  using Base = OpenMesh::TriMesh_ArrayKernelT<Traits>;

 public:
  CollapseRecorder* recorder = nullptr;
  const SurfaceFans* fans = nullptr;

  std::uint32_t point_of(VertexHandle fan) const { return fans->point[static_cast<std::size_t>(fan.idx())]; }

  bool is_collapse_ok(HalfedgeHandle edge) {
    const std::uint32_t removed = point_of(from_vertex_handle(edge)), kept = point_of(to_vertex_handle(edge));
    return Base::is_collapse_ok(edge) && recorder->keeps_topology(removed, kept) && recorder->pairs_up(removed, kept);
  }
};

using Decimater = OpenMesh::Decimater::DecimaterT<FanMesh>;
using Quadric = OpenMesh::Decimater::ModQuadricT<FanMesh>;

/// Refuses nothing, and records what is done.
template <class MeshT>
class Recording final : public OpenMesh::Decimater::ModBaseT<MeshT> {
 public:
  DECIMATING_MODULE(Recording, MeshT, Recording);
  explicit Recording(Mesh& mesh) : Base(mesh, true) {}

  double unit = 1;  ///< how long one unit of OpenMesh's mesh is in ours
  Quadric* quadric = nullptr;
  std::vector<double> area;  ///< [fan] of all triangles that its quadric is of

  void preprocess_collapse(const CollapseInfo& collapse) override {
    Mesh& mesh = Base::mesh();
    const std::uint32_t removed = mesh.point_of(collapse.v0), kept = mesh.point_of(collapse.v1);
    double& behind = area[static_cast<std::size_t>(collapse.v1.idx())];
    behind += area[static_cast<std::size_t>(collapse.v0.idx())];
    const double cost = std::max(0.0, static_cast<double>(quadric->collapse_priority(collapse)));
    mesh.recorder->pairs_up(removed, kept);
    mesh.recorder->collapse(removed, kept, {.error = behind > 0 ? unit * std::sqrt(cost / behind) : 0});
  }
};

class Cancelling final : public OpenMesh::Decimater::Observer {
 public:
  explicit Cancelling(const std::atomic<bool>* cancel) : Observer(64), cancel_(cancel) {}
  void notify(std::size_t) override {}
  bool abort() const override { return cancel_ != nullptr && cancel_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* cancel_;
};

/// With more triangles a point stays: after each collapse beside it OpenMesh asks all of them about all of them.
constexpr std::uint32_t most_around = 512;

std::vector<std::uint32_t> triangles_around(const SurfaceFans& fans) {
  std::vector<std::uint32_t> around(fans.point.size(), 0);
  for (const auto& corners : fans.corners) {
    for (const std::uint32_t fan : corners) ++around[fan];
  }
  return around;
}

void fill(FanMesh& mesh, const UnitFrame& frame, std::span<const glm::vec3> positions) {
  const SurfaceFans& fans = *mesh.fans;
  const std::vector<std::uint32_t> around = triangles_around(fans);
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
  mesh.request_face_normals();
  for (std::size_t fan = 0; fan < fans.point.size(); ++fan) {
    const std::uint32_t p = fans.point[fan];
    const bool is_finite = mesh.recorder->is_finite(p);
    const glm::dvec3 at = is_finite ? frame.from_mesh(positions[p]) : glm::dvec3(0);
    const auto vertex = mesh.add_vertex({at.x, at.y, at.z});
    if (fans.is_held[fan] || !is_finite || around[fan] > most_around) mesh.status(vertex).set_locked(true);
  }
  const auto handle = [](std::uint32_t fan) { return FanMesh::VertexHandle(static_cast<int>(fan)); };
  for (const auto& [a, b, c] : fans.corners) mesh.add_face(handle(a), handle(b), handle(c));
  mesh.update_face_normals();
}

std::vector<double> areas_of(const FanMesh& mesh) {
  std::vector<double> area(mesh.n_vertices(), 0);
  for (const auto face : mesh.faces()) {
    const double of_face = mesh.calc_face_area(face);
    for (const auto vertex : mesh.fv_range(face)) area[static_cast<std::size_t>(vertex.idx())] += of_face;
  }
  return area;
}

/// Adds a module that refuses collapses, and answers with it.
template <template <class> class Module>
Module<FanMesh>& add(Decimater& decimater) {
  OpenMesh::Decimater::ModHandleT<Module<FanMesh>> handle;
  decimater.add(handle);
  return decimater.module(handle);
}

void add_modules(Decimater& decimater, const OpenmeshDecimateOptions& options, double diagonal) {
  using namespace OpenMesh::Decimater;
  add<ModNormalFlippingT>(decimater).set_max_normal_deviation(options.normal_flipping);
  if (options.normal_deviation) add<ModNormalDeviationT>(decimater).set_normal_deviation(*options.normal_deviation);
  if (options.aspect_ratio) {
    add<ModAspectRatioT>(decimater).set_aspect_ratio(static_cast<float>(*options.aspect_ratio));
  }
  if (options.roundness) add<ModRoundnessT>(decimater).set_min_roundness(*options.roundness, true);
  if (options.edge_length) add<ModEdgeLengthT>(decimater).set_edge_length(*options.edge_length * diagonal);
  if (options.hausdorff) add<ModHausdorffT>(decimater).set_tolerance(*options.hausdorff * diagonal);
}

}  // namespace

CollapseSequence openmesh_decimate(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                                   const OpenmeshDecimateOptions& options) {
  CollapseRecorder recorder(positions, indices);
  const SurfaceFans fans = surface_fans(recorder.points());
  const UnitFrame frame = unit_frame(positions, recorder);
  FanMesh mesh;
  mesh.recorder = &recorder;
  mesh.fans = &fans;
  fill(mesh, frame, positions);
  Cancelling cancelling(options.cancel);
  if (cancelling.abort()) return recorder.take();
  Decimater decimater(mesh);
  auto& recording = add<Recording>(decimater);
  recording.unit = frame.unit;
  recording.area = areas_of(mesh);
  recording.quadric = &add<OpenMesh::Decimater::ModQuadricT>(decimater);
  add_modules(decimater, options, frame.diagonal);
  decimater.initialize();
  decimater.set_observer(&cancelling);
  decimater.decimate_to_faces(0, options.least);
  return recorder.take();
}

}  // namespace foredraw
