#include "cgal_collapse.h"

#include <foredraw/collapses/surface_fans.h>
#include <foredraw/collapses/unit_frame.h>
#include <foredraw/geometry/finite.h>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"  // gcc 12 sees it inside of boost::optional and of Eigen
#endif

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

namespace simplification = CGAL::Surface_mesh_simplification;
using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using Vertex = SurfaceMesh::Vertex_index;
using Place = boost::optional<Point>;

Point cgal_point(const glm::dvec3& at) { return {at.x, at.y, at.z}; }

/// What the policies below share while CGAL works.
struct Work {
  CollapseRecorder& recorder;
  UnitFrame frame;
  const CgalCollapseOptions& options;
  std::vector<std::uint32_t> name;  ///< [vertex of CGAL's] the point that it stands for
  std::vector<bool> is_held;        ///< [vertex of CGAL's]
  std::uint32_t removed = 0, kept = 0;
  double error = 0;

  bool holds(Vertex v) const { return is_held[v.idx()]; }
};

/// Held vertices stay; other places are those of a policy, as floats can hold them.
template <class Base>
class Placement {
 public:
  Placement(const Base& base, const Work& work) : base_(&base), work_(&work) {}

  template <class Profile>
  Place operator()(const Profile& profile) const {
    const bool is_first_held = work_->holds(profile.v0()), is_second_held = work_->holds(profile.v1());
    if (is_first_held && is_second_held) return boost::none;
    if (is_first_held) return profile.p0();
    if (is_second_held) return profile.p1();
    const Place best = (*base_)(profile);
    if (!best) return boost::none;
    const glm::vec3 place = work_->frame.to_mesh({best->x(), best->y(), best->z()});
    if (!is_finite(place)) return boost::none;
    return cgal_point(work_->frame.from_mesh(place));
  }

 private:
  const Base* base_;
  const Work* work_;
};

/// CGAL asks here right before each collapse.
class Filter {
 public:
  explicit Filter(Work& work) : work_(&work) {}

  template <class Profile>
  Place operator()(const Profile& profile, const Place& place) const {
    if (!place || (work_->options.keep_sides && !keeps_sides_(profile, place))) return boost::none;
    const std::uint32_t first = work_->name[profile.v0().idx()], second = work_->name[profile.v1().idx()];
    if (!work_->recorder.keeps_topology(first, second)) return boost::none;
    if (!work_->holds(profile.v0()) && work_->recorder.pairs_up(first, second)) {
      work_->removed = first, work_->kept = second;
    } else if (!work_->holds(profile.v1()) && work_->recorder.pairs_up(second, first)) {
      work_->removed = second, work_->kept = first;
    } else {
      return boost::none;
    }
    work_->error = work_->frame.unit * distance_from_planes(profile, *place);
    return place;
  }

 private:
  /// Root mean square by area, of all triangles around the edge.
  template <class Profile>
  static double distance_from_planes(const Profile& profile, const Point& place) {
    double sum = 0, area = 0;
    for (const auto& triangle : profile.triangles()) {
      const Point& a = get(profile.vertex_point_map(), triangle.v0);
      const Point& b = get(profile.vertex_point_map(), triangle.v1);
      const Point& c = get(profile.vertex_point_map(), triangle.v2);
      const auto normal = CGAL::cross_product(b - a, c - a);  // its length is twice the area
      const double twice = std::sqrt(normal.squared_length());
      if (!(twice > 0)) continue;
      const double along = normal * (place - a);
      sum += along * along / twice;
      area += twice;
    }
    return area > 0 ? std::sqrt(sum / area) : 0;
  }

  Work* work_;
  simplification::Bounded_normal_change_filter<> keeps_sides_;
};

class Stop {
 public:
  explicit Stop(const Work& work) : work_(&work) {}

  template <class Profile>
  bool operator()(double, const Profile&, std::size_t, std::size_t) const {
    const std::atomic<bool>* cancel = work_->options.cancel;
    return work_->recorder.triangle_count() <= work_->options.least ||
           (cancel != nullptr && cancel->load(std::memory_order_relaxed));
  }

 private:
  const Work* work_;
};

class Recording : public simplification::Edge_collapse_visitor_base<SurfaceMesh> {
 public:
  Recording(Work& work, std::vector<glm::vec3>& places) : work_(&work), places_(&places) {}

  void OnCollapsing(const Profile&, const Place& place) {
    place_ = work_->frame.to_mesh({place->x(), place->y(), place->z()});
  }
  void OnCollapsed(const Profile& profile, const Vertex& left) {
    const auto [removed, kept] = std::pair(work_->removed, work_->kept);
    std::vector<glm::vec3>& places = *places_;
    const bool is_held = work_->holds(profile.v0()) || work_->holds(profile.v1());
    if (is_held) place_ = places[kept];  // to the last bit
    work_->recorder.pairs_up(removed, kept);
    work_->recorder.collapse(removed, kept, {blend_of(places[kept], places[removed], place_), work_->error, place_});
    places[kept] = place_;
    work_->name[left.idx()] = kept;
    work_->is_held[left.idx()] = is_held;
  }

 private:
  Work* work_;
  std::vector<glm::vec3>* places_;  // [point]
  glm::vec3 place_{0};
};

/// Edges that rounding has left without length: CGAL would collapse them unasked.
class Lengthless {
 public:
  using key_type = SurfaceMesh::Edge_index;
  using value_type = bool;
  using reference = bool;
  using category = boost::readable_property_map_tag;

  explicit Lengthless(const SurfaceMesh& mesh) : mesh_(&mesh) {}
  friend bool get(const Lengthless& map, SurfaceMesh::Edge_index edge) {
    const auto side = map.mesh_->halfedge(edge);
    return map.mesh_->point(map.mesh_->source(side)) == map.mesh_->point(map.mesh_->target(side));
  }

 private:
  const SurfaceMesh* mesh_;
};

SurfaceMesh mesh_of(const SurfaceFans& fans, std::span<const glm::vec3> positions, Work& work) {
  SurfaceMesh mesh;
  for (std::size_t fan = 0; fan < fans.point.size(); ++fan) {
    const std::uint32_t p = fans.point[fan];
    const bool is_finite = work.recorder.is_finite(p);
    mesh.add_vertex(is_finite ? cgal_point(work.frame.from_mesh(positions[p])) : Point(0, 0, 0));
    work.is_held.push_back(fans.is_held[fan] || !is_finite);
  }
  for (const auto& [a, b, c] : fans.corners) mesh.add_face(Vertex(a), Vertex(b), Vertex(c));
  return mesh;
}

template <class Cost, class Best>
void run(SurfaceMesh& mesh, Work& work, std::vector<glm::vec3>& places, const Cost& cost, const Best& best) {
  simplification::edge_collapse(mesh, Stop(work),
                                CGAL::parameters::edge_is_constrained_map(Lengthless(mesh))
                                    .get_cost(cost)
                                    .get_placement(Placement<Best>(best, work))
                                    .filter(Filter(work))
                                    .visitor(Recording(work, places)));
}

}  // namespace

CollapseSequence cgal_collapse(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                               const CgalCollapseOptions& options) {
  CollapseRecorder recorder(positions, indices);
  const SurfaceFans fans = surface_fans(recorder.points());
  Work work{recorder, unit_frame(positions, recorder), options, fans.point, {}};
  SurfaceMesh mesh = mesh_of(fans, positions, work);
  std::vector<glm::vec3> places(positions.begin(), positions.end());
  if (options.cost == CgalCost::lindstrom_turk) {
    run(mesh, work, places, simplification::LindstromTurk_cost<SurfaceMesh>(),
        simplification::LindstromTurk_placement<SurfaceMesh>());
  } else {
    const simplification::GarlandHeckbert_plane_policies<SurfaceMesh, Kernel> policies(mesh);
    run(mesh, work, places, policies.get_cost(), policies.get_placement());
  }
  return recorder.take();
}

}  // namespace foredraw
