#include <foredraw/measuring/subject_capture.h>

#include <foredraw/overdraw/cluster_layers.h>
#include <foredraw/overdraw/overdraw_bound.h>

#include <fmt/format.h>

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

void add_looks(SubjectCapture& captured, const SubjectView& view, const SubjectGeometry& drawn, double weight, Run& run) {
  SubjectLayers& seen = captured.seen;
  seen.owners.clear();
  const Clusters atoms = atoms_of_parts(captured, view, drawn, seen.owners);
  const auto layers_of_triangles = run.overdraw->capture(drawn.parts, run.views, run);
  if (!layers_of_triangles) {
    throw std::runtime_error(
        "what hides what can not be captured: let overdraw-raster answer in [services], or let "
        "[views] name fewer or smaller pictures");
  }
  ClusterLayers layers = cluster_layers(*layers_of_triangles, atoms, run.executor);
  seen.layers.owners = layers.owners;
  for (std::size_t v = 0; v < layers.views.size(); ++v) {
    seen.layers.views.push_back(std::move(layers.views[v]));
    seen.directions.push_back(run.views.views[v].direction);
    seen.weights.push_back(run.views.views[v].weight * weight);
  }
}

}  // namespace

std::size_t SubjectCapture::number_of(DrawId draw) const {
  return static_cast<std::size_t>(std::ranges::find(draws, draw) - draws.begin());
}

std::vector<std::uint8_t> SubjectCapture::by_pose(std::span<const std::uint8_t> serving) const {
  std::vector<std::uint8_t> result;
  for (const std::size_t first : first_look) {
    const auto of_pose = serving.subspan(first, views);
    result.insert(result.end(), of_pose.begin(), of_pose.end());
  }
  return result;
}

SubjectCapture capture_subject(const SubjectView& view, const Poses& poses,
                                 const std::function<Clusters(const Draw&)>& atoms_of, Run& run,
                                 const std::function<void(const SubjectLayers&, const SubjectGeometry&)>& see) {
  SubjectCapture captured;
  captured.views = run.views.views.size();
  add_draws(captured, view, atoms_of);
  const DistinctPoses distinct = distinct_poses(view.scene, {&view.subject, 1}, poses, run.executor).front();
  for (std::size_t pose = 0; pose < poses.poses.size(); ++pose) {
    if (run.cancelled()) throw std::runtime_error("cancelled");
    if (distinct.first_alike[pose] != pose) {
      captured.first_look.push_back(captured.first_look[distinct.first_alike[pose]]);
      continue;
    }
    captured.first_look.push_back(captured.seen.layers.views.size());
    const PosedNodes nodes = view.subject.is_placed() ? posed_nodes(view.scene, poses.poses[pose]) : PosedNodes();
    const SubjectGeometry drawn = subject_geometry(view.scene, view.subject, run.overdraw->faces(), nodes, run.analyses);
    add_looks(captured, view, drawn, distinct.weights[pose], run);
    if (see) see(captured.seen, drawn);
  }
  return captured;
}

bool may_overdraw(const SubjectView& view, Run& run) {
  const bool moves = view.subject.is_placed() && run.poses.poses.size() > 1;
  if (moves) return true;
  const PosedNodes nodes =
      view.subject.is_placed() ? posed_nodes(view.scene, run.poses.poses.front()) : PosedNodes();
  const SubjectGeometry drawn = subject_geometry(view.scene, view.subject, run.overdraw->faces(), nodes, run.analyses);
  const auto bound = overdraw_bound(drawn.parts, least_overdraw);
  if (!bound) return true;
  run.keep(fmt::format("it is convex, or nearly so: no order of it overdraws more than {:.4f}", *bound));
  return false;
}

bool has_overdraw(const ViewTally& before, Run& run) {
  if (before.shaded > before.visible) return true;
  run.keep("nothing in it is drawn that does not stay");
  return false;
}

bool lowers_overdraw(const ViewTally& before, const ViewTally& after, Run& run) {
  if (after.shaded < before.shaded) return true;
  run.keep(fmt::format("ordered anew, its overdraw would be {:.4f} and not {:.4f} as it is",
                       after.shaded / after.visible, before.shaded / before.visible));
  return false;
}

}  // namespace foredraw
