#include "wire_radius.h"

#include "decals.h"
#include "nets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace foredraw {

namespace {

using namespace processors::wire_radius;

/// What may be a wire, with all that is known of it.
struct Candidate {
  FoundWire wire;
  WireParts parts;
  std::vector<BackProbe> probes;
};

class Finder {
 public:
  Finder(const WeldedMesh& mesh, const WireOptions& options, const WireSearch& search, std::vector<bool> taken)
      : mesh_(mesh), options_(options), search_(search), taken_(std::move(taken)) {}

  std::vector<Candidate> find() {
    add_nets();
    add_chains();
    return std::move(found_);
  }
  std::vector<RefusedWire> refused() { return std::move(refused_); }

 private:
  void refuse(WireRefusal why, std::uint32_t triangle, double length, double width) {
    refused_.push_back({why, triangle, length, width});
  }

  void add_nets() {
    for (Net& net : find_nets(mesh_)) {
      const auto refuse_net = [&](WireRefusal why) {
        refuse(why, net.parts.triangles.front(), net.length, 2 * net.half_width);
      };
      if (std::ranges::any_of(net.parts.triangles, [&](std::uint32_t t) { return taken_[t]; })) continue;
      for (const std::uint32_t t : net.parts.triangles) taken_[t] = true;  // its ribbons are not looked at one by one
      if (!options_.ribbons) {
        refuse_net(WireRefusal::ribbon);
      } else if (net.length < options_.least_length) {
        refuse_net(WireRefusal::small);
      } else if (!(static_cast<float>(net.half_width) > 0)) {
        refuse_net(WireRefusal::tiny);
      } else {
        Candidate candidate{{WireKind::net, net.length, net.half_width, false}, std::move(net.parts), {}};
        candidate.probes = back_probes(mesh_, candidate.parts.triangles, options_.decal * 2 * net.half_width);
        found_.push_back(std::move(candidate));
      }
    }
  }

  void add_chains() {
    ChainFollower follower(mesh_, {.slender = options_.slender, .aspect = options_.aspect, .taper = options_.taper});
    WirePoints points(mesh_);
    constexpr std::uint32_t between_reports = 4096;
    for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (t % between_reports == 0) {
        if (search_.cancel != nullptr && search_.cancel->load(std::memory_order_relaxed)) return;
        if (search_.progress) search_.progress(static_cast<double>(t) / static_cast<double>(mesh_.triangles.size()));
      }
      for (const glm::dvec3& direction : directions(t)) {
        if (taken_[t]) break;
        add(follower.follow(t, direction), points);
      }
    }
  }

  /// Along its edges, the longest first: on a wire of few sides these lead along it.
  std::vector<glm::dvec3> directions(std::uint32_t triangle) const {
    std::vector<glm::dvec3> edges;
    for (std::size_t e = 0; e < 3; ++e) {
      const glm::dvec3 edge =
          mesh_.points[mesh_.triangles[triangle][(e + 1) % 3]] - mesh_.points[mesh_.triangles[triangle][e]];
      if (glm::length(edge) > 0) edges.push_back(edge);
    }
    std::ranges::stable_sort(edges,
                             [](const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a, a) > glm::dot(b, b); });
    for (glm::dvec3& edge : edges) edge = glm::normalize(edge);
    return edges;
  }

  void add(const Chain& chain, WirePoints& points) {
    const auto run = longest_run(chain, options_.taper);
    if (!run || 2 * run->length < options_.slender * run->mean_width) return;
    const std::uint32_t triangle = chain.sections[run->first].triangle;
    if (const auto why = shape_refusal(chain, *run, options_)) {
      refuse(*why, triangle, run->length, run->mean_width);
      return;
    }
    Candidate candidate{{run->kind, run->length, run->half_width, run->closed}, points.along(chain, *run), {}};
    if (!run->closed) candidate.wire.length += candidate.parts.beyond;
    // What another wire left of it, and what has more elsewhere, is its end.
    const std::size_t all = candidate.parts.triangles.size();
    std::erase_if(candidate.parts.triangles, [&](std::uint32_t t) { return taken_[t]; });
    if (2 * candidate.parts.triangles.size() <= all) return;
    const auto is_tiny = [](const WirePoint& point) { return !(static_cast<float>(point.half_width) > 0); };
    if (std::ranges::any_of(candidate.parts.points, is_tiny)) {
      refuse(WireRefusal::tiny, triangle, run->length, run->mean_width);
      return;
    }
    for (const std::uint32_t t : candidate.parts.triangles) taken_[t] = true;
    if (options_.decal > 0) candidate.probes = back_probes(chain, *run, options_.decal);
    found_.push_back(std::move(candidate));
  }

  const WeldedMesh& mesh_;
  const WireOptions& options_;
  const WireSearch& search_;
  std::vector<bool> taken_;  ///< [triangle]
  std::vector<Candidate> found_;
  std::vector<RefusedWire> refused_;
};

/// Takes out what lies on a surface. Ribbons and channels are no such surface for each other.
void leave_decals_out(const WeldedMesh& mesh, std::vector<Candidate>& found, std::vector<RefusedWire>& refused) {
  if (std::ranges::all_of(found, [](const Candidate& candidate) { return candidate.probes.empty(); })) return;
  std::vector<Blocks> blocks(mesh.triangles.size(), Blocks::both);
  for (const Candidate& candidate : found) {
    const bool is_tube = !candidate.probes.empty() && !candidate.probes.front().outside.empty();
    if (is_tube) continue;
    for (const std::uint32_t t : candidate.parts.triangles) blocks[t] = Blocks::neither;
  }
  std::vector<glm::vec3> points(mesh.points.begin(), mesh.points.end());
  std::vector<std::uint32_t> indices;
  for (const auto& triangle : mesh.triangles) indices.insert(indices.end(), triangle.begin(), triangle.end());
  const RayTree surfaces(points, indices, blocks);
  std::erase_if(found, [&](const Candidate& candidate) {
    if (!is_decal(candidate.probes, surfaces)) return false;
    refused.push_back(
        {WireRefusal::decal, candidate.parts.triangles.front(), candidate.wire.length, 2 * candidate.wire.radius});
    return true;
  });
}

/// Which wire each point and each triangle belongs to. Points that others use too are joints, and triangles between
/// joints alone are no wire's.
class Owners {
 public:
  Owners(const WeldedMesh& mesh, std::span<const std::uint32_t> indices, const std::vector<Candidate>& found)
      : wire_of(indices.size() / 3, FoundWires::none), is_joint(mesh.points.size(), false) {
    std::vector<std::uint32_t> of_welded(mesh.triangles.size(), FoundWires::none);
    for (std::uint32_t w = 0; w < found.size(); ++w) {
      for (const std::uint32_t t : found[w].parts.triangles) of_welded[t] = w;
    }
    std::vector<std::uint32_t> of_point(mesh.points.size(), FoundWires::none);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t point : mesh.triangles[t]) {
        if (of_welded[t] != FoundWires::none) of_point[point] = of_welded[t];
      }
    }
    for (std::size_t t = 0; t < wire_of.size(); ++t) {
      const std::array<std::uint32_t, 3> corners = corners_of(mesh, indices, t);
      if (mesh.triangle_of[t] != FoundWires::none) {
        wire_of[t] = of_welded[mesh.triangle_of[t]];
      } else if (of_point[corners[0]] == of_point[corners[1]] && of_point[corners[1]] == of_point[corners[2]]) {
        wire_of[t] = of_point[corners[0]];  // a line on a wire goes with it
      }
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t t = 0; t < wire_of.size(); ++t) {
        for (const std::uint32_t point : corners_of(mesh, indices, t)) {
          if (of_point[point] != wire_of[t] && of_point[point] != FoundWires::none) is_joint[point] = true;
        }
      }
      for (std::size_t t = 0; t < wire_of.size(); ++t) {
        const auto joins = [&](std::uint32_t point) { return is_joint[point]; };
        if (wire_of[t] == FoundWires::none || !std::ranges::all_of(corners_of(mesh, indices, t), joins)) continue;
        wire_of[t] = FoundWires::none;
        changed = true;
      }
    }
  }

  static std::array<std::uint32_t, 3> corners_of(const WeldedMesh& mesh, std::span<const std::uint32_t> indices,
                                                 std::size_t t) {
    return {mesh.point_of[indices[3 * t]], mesh.point_of[indices[3 * t + 1]], mesh.point_of[indices[3 * t + 2]]};
  }

  std::vector<std::uint32_t> wire_of;  ///< [triangle]
  std::vector<bool> is_joint;          ///< [point]
};

/// For corners whose ribbon is another one than that of their vertex.
void add_copies(const WeldedMesh& mesh, std::span<const std::uint32_t> indices, const std::vector<Candidate>& found,
                std::span<const WirePoint* const> of_point, const auto& half_width, FoundWires& result) {
  struct Own {
    const Candidate* candidate = nullptr;
    std::size_t triangle = 0;
  };
  std::vector<Own> own(mesh.triangles.size());
  for (const Candidate& candidate : found) {
    for (std::size_t t = 0; t < candidate.parts.corners.size(); ++t) {
      own[candidate.parts.triangles[t]] = {&candidate, t};
    }
  }
  std::map<std::pair<std::uint32_t, const WirePoint*>, std::uint32_t> known;
  for (std::uint32_t i = 0; i < indices.size(); ++i) {
    const std::size_t t = i / 3;
    if (result.wire_of[t] == FoundWires::none || mesh.triangle_of[t] == FoundWires::none) continue;
    const Own& of = own[mesh.triangle_of[t]];
    if (of.candidate == nullptr) continue;
    const WireParts& parts = of.candidate->parts;
    const auto& corners = mesh.triangles[mesh.triangle_of[t]];
    const auto corner = std::ranges::find(corners, mesh.point_of[indices[i]]) - corners.begin();
    const WirePoint& point = parts.points[parts.corners[of.triangle][static_cast<std::size_t>(corner)]];
    if (of_point[point.point] == &point) continue;
    const auto [place, is_new] =
        known.try_emplace({indices[i], &point}, static_cast<std::uint32_t>(result.copies.size()));
    if (is_new) result.copies.push_back({indices[i], point.to_centre, point.axis, half_width(point)});
    result.corners.push_back({i, place->second});
  }
}

}  // namespace

FoundWires find_wires(std::span<const glm::vec3> positions, std::span<const std::uint32_t> indices,
                      const WireOptions& options, const WireSearch& search, std::size_t first_fixed) {
  const WeldedMesh mesh = weld_mesh(positions, indices);
  std::vector<bool> is_fixed(mesh.triangles.size(), false);
  for (std::size_t t = first_fixed; t < mesh.triangle_of.size(); ++t) {
    if (mesh.triangle_of[t] != FoundWires::none) is_fixed[mesh.triangle_of[t]] = true;
  }
  Finder finder(mesh, options, search, std::move(is_fixed));
  std::vector<Candidate> found = finder.find();
  FoundWires result;
  result.refused = finder.refused();
  leave_decals_out(mesh, found, result.refused);
  Owners owners(mesh, indices, found);

  // Wires without a triangle of their own go.
  std::vector<std::uint32_t> number(found.size(), FoundWires::none);
  for (const std::uint32_t wire : owners.wire_of) {
    if (wire != FoundWires::none) number[wire] = 0;
  }
  for (std::uint32_t w = 0; w < found.size(); ++w) {
    if (number[w] == FoundWires::none) {
      result.refused.push_back(
          {WireRefusal::joined, found[w].parts.triangles.front(), found[w].wire.length, 2 * found[w].wire.radius});
    } else {
      number[w] = static_cast<std::uint32_t>(result.wires.size());
      result.wires.push_back(found[w].wire);
    }
  }
  result.wire_of = std::move(owners.wire_of);
  std::vector<bool> is_used(mesh.points.size(), false);
  for (std::size_t t = 0; t < result.wire_of.size(); ++t) {
    if (result.wire_of[t] == FoundWires::none) continue;
    result.wire_of[t] = number[result.wire_of[t]];
    for (const std::uint32_t point : Owners::corners_of(mesh, indices, t)) is_used[point] = true;
  }
  std::vector<const WirePoint*> of_point(mesh.points.size(), nullptr);
  for (const Candidate& candidate : found) {
    const std::vector<WirePoint>& points = candidate.parts.points;
    for (auto point = points.rbegin(); point != points.rend(); ++point) {
      if (is_used[point->point]) of_point[point->point] = &*point;
    }
  }
  const auto half_width = [&](const WirePoint& point) {
    return static_cast<float>(owners.is_joint[point.point] ? -point.half_width : point.half_width);
  };
  result.to_centre.assign(positions.size(), glm::vec3(0));
  result.half_width.assign(positions.size(), 0);
  result.axis.assign(positions.size(), glm::vec3(0));
  result.is_flat.assign(positions.size(), false);
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const WirePoint* point = of_point[mesh.point_of[v]];
    if (point == nullptr) continue;
    result.to_centre[v] = point->to_centre;
    result.axis[v] = point->axis;
    result.is_flat[v] = point->is_flat;
    result.half_width[v] = half_width(*point);
  }
  add_copies(mesh, indices, found, of_point, half_width, result);
  return result;
}

}  // namespace foredraw
