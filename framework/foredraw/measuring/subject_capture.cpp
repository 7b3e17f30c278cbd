#include <foredraw/measuring/subject_capture.h>

#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/overdraw/overdraw_bound.h>
#include <foredraw/viewing/shared_views.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

namespace {

/// The subject's draws, each once.
void add_draws(SubjectCapture& captured, const SubjectView& view,
               const std::function<Clusters(const Draw&)>& atoms_of) {
  for (const SubjectPart& part : view.subject.parts) {
    if (std::ranges::find(captured.draws, part.draw) != captured.draws.end()) continue;
    captured.draws.push_back(part.draw);
    const Draw& draw = view.scene.draws[part.draw];
    const IndexStream& stream = draw.full().stream();
    const bool is_ordered = std::ranges::find(view.draws, part.draw) != view.draws.end();
    const auto triangles = static_cast<std::uint32_t>(stream.triangle_count());
    captured.seen.draws.push_back({stream.indices.view(), draw.full().vertices->count,
                                   is_ordered      ? atoms_of(draw)
                                   : triangles > 0 ? Clusters{{0, triangles}}
                                                   : Clusters{{0}}});
  }
}

/// The atoms of all parts that are drawn, one part's behind the other's. Tells who they are.
Clusters atoms_of_parts(const SubjectCapture& captured, const SubjectView& view, const SubjectGeometry& drawn,
                        std::vector<LayerOwner>& owners) {
  Clusters all{{0}};
  for (std::uint32_t part = 0; part < drawn.parts.size(); ++part) {
    if (drawn.parts[part].indices.empty()) continue;
    const auto d = static_cast<std::uint32_t>(captured.number_of(view.subject.parts[part].draw));
    const Clusters& atoms = captured.seen.draws[d].atoms;
    const std::uint32_t first = all.offsets.back();
    for (std::uint32_t atom = 0; atom < atoms.count(); ++atom) {
      all.offsets.push_back(first + atoms.offsets[atom + 1]);
      owners.push_back({part, d, atom});
    }
  }
  return all;
}

/// Of those that are in `share`: [view] its number there, or that of the nearest one.
std::vector<std::size_t> nearest_in(std::span<const std::size_t> share, const Views& views) {
  std::vector<std::size_t> nearest;
  for (const View& view : views.views) {
    const auto cosine = [&](std::size_t i) { return glm::dot(views.views[share[i]].direction, view.direction); };
    std::size_t best = 0;
    for (std::size_t i = 1; i < share.size(); ++i) {
      if (cosine(i) > cosine(best)) best = i;
    }
    nearest.push_back(best);
  }
  return nearest;
}

/// From where each of several poses is looked at.
struct Looks {
  std::vector<std::vector<std::size_t>> shares;  ///< [pose] numbers of views
  int size = 0;                                  ///< of the pictures
};

/// Every pose from all views; or, where the poses share them, so that all pictures have twice the pixels of those of
/// one pose. They are small then: a look from another side, or at another time, tells more than pixels do.
Looks looks_at(const Views& views, std::size_t poses, bool share, std::size_t most) {
  constexpr int small = 96;
  const std::size_t all = poses * views.views.size();
  if (poses == 1) return {shared_views(views.views, poses, all), views.size};
  if (!share) return {shared_views(views.views, poses, std::min(all, std::max(most, poses))), views.size};
  const int size = std::min(views.size, small);
  const double pixels = static_cast<double>(views.views.size()) * views.size * views.size;
  return {shared_views(views.views, poses, static_cast<std::size_t>(2 * pixels / (size * size))), size};
}

void add_looks(SubjectCapture& captured, const SubjectView& view, const SubjectGeometry& drawn, const Views& views,
               std::uint32_t pose, double weight, Run& run) {
  SubjectLayers& seen = captured.seen;
  seen.owners.clear();
  const Clusters atoms = atoms_of_parts(captured, view, drawn, seen.owners);
  const auto layers_of_triangles = run.overdraw->capture(drawn.parts, views, run);
  if (!layers_of_triangles) {
    throw std::runtime_error(
        "its visibility cannot be captured; name overdraw-raster in [services], or fewer or smaller pictures in "
        "[views]");
  }
  ClusterLayers layers = cluster_layers(*layers_of_triangles, atoms, run.executor);
  seen.layers.owners = layers.owners;
  for (std::size_t v = 0; v < layers.views.size(); ++v) {
    seen.layers.views.push_back(std::move(layers.views[v]));
    seen.directions.push_back(views.views[v].direction);
    seen.weights.push_back(views.views[v].weight * weight);
    seen.poses.push_back(pose);
  }
}

}  // namespace

std::size_t SubjectCapture::number_of(DrawId draw) const {
  return static_cast<std::size_t>(std::ranges::find(draws, draw) - draws.begin());
}

std::vector<std::uint8_t> SubjectCapture::by_pose(std::span<const std::uint8_t> serving) const {
  std::vector<std::uint8_t> result;
  for (const auto& of_pose : look) {
    for (const std::size_t shown : of_pose) result.push_back(serving[shown]);
  }
  return result;
}

SubjectCapture capture_subject(const SubjectView& view, const Poses& poses,
                               const std::function<Clusters(const Draw&)>& atoms_of, Run& run,
                               const std::function<void(const SubjectLayers&, const SubjectGeometry&)>& see,
                               std::size_t most_looks) {
  SubjectCapture captured;
  add_draws(captured, view, atoms_of);
  const DistinctPoses distinct = distinct_poses(view.scene, {&view.subject, 1}, poses, run.executor).front();
  const std::size_t different = count_different({&distinct, 1});
  const Looks looks = looks_at(run.views, different, poses.share_views, most_looks);
  std::size_t number = 0;  // among those that look different
  for (std::size_t pose = 0; pose < poses.poses.size(); ++pose) {
    if (run.cancelled()) throw std::runtime_error("cancelled");
    if (distinct.first_alike[pose] != pose) {
      captured.look.push_back(captured.look[distinct.first_alike[pose]]);
      continue;
    }
    const std::vector<std::size_t>& share = looks.shares[number++];
    Views views{{}, looks.size};
    for (const std::size_t v : share) views.views.push_back(run.views.views[v]);
    captured.look.push_back(nearest_in(share, run.views));
    for (std::size_t& shown : captured.look.back()) shown += captured.seen.layers.views.size();
    const PosedNodes nodes = view.subject.is_placed() ? posed_nodes(view.scene, poses.poses[pose]) : PosedNodes();
    const SubjectGeometry drawn =
        subject_geometry(view.scene, view.subject, run.overdraw->faces(), nodes, run.analyses);
    add_looks(captured, view, drawn, views, static_cast<std::uint32_t>(pose), distinct.weights[pose], run);
    if (see) see(captured.seen, drawn);
  }
  if (different > 1) {
    run.note("poses", fmt::format("made for {}, in {} pictures", poses_text(poses.poses.size(), different),
                                  captured.seen.layers.views.size()));
  }
  return captured;
}

bool may_overdraw(const SubjectView& view, Run& run) {
  const bool moves = view.subject.is_placed() && run.poses.poses.size() > 1;
  if (moves) return true;
  const PosedNodes nodes = view.subject.is_placed() ? posed_nodes(view.scene, run.poses.poses.front()) : PosedNodes();
  const SubjectGeometry drawn = subject_geometry(view.scene, view.subject, run.overdraw->faces(), nodes, run.analyses);
  const auto bound = overdraw_bound(drawn.parts, least_overdraw);
  if (!bound) return true;
  run.keep(fmt::format("it is convex or nearly convex: no order has a higher overdraw ratio than {:.4f}", *bound));
  return false;
}

bool has_overdraw(const ViewTally& before, Run& run) {
  if (before.shaded > before.visible) return true;
  run.keep("it has no overdraw: every fragment that is shaded stays visible");
  return false;
}

bool lowers_overdraw(const ViewTally& before, const ViewTally& after, Run& run) {
  if (after.shaded < before.shaded) return true;
  run.keep(fmt::format("the new order would have an overdraw of {:.4f}, its own has {:.4f}",
                       after.shaded / after.visible, before.shaded / before.visible));
  return false;
}

}  // namespace foredraw
