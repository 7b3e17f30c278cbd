#include "side_search.h"

#include <foredraw/analysis/closed_surfaces.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/base/random.h>
#include <foredraw/viewing/distinct_poses.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/shared_views.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>
#include <functional>
#include <map>

namespace foredraw::sides {

namespace {

constexpr std::size_t fewest_rays = 2;  // in each pose
constexpr std::size_t first_rays = 4;   // of every side, over all poses
constexpr int most_checks = 6;
constexpr int check_size = 256;  // pixels

/// A subject in one of its poses, and the views that this pose is looked at from.
using LookAt = std::function<void(const SubjectGeometry&, const Views&)>;

struct Surface {
  std::vector<std::uint32_t> indices;  ///< of welded vertices
  std::size_t vertices = 0;            ///< that there are, welded or not
  std::vector<bool> is_closed;         ///< [triangle]
};
using Surfaces = std::map<DrawId, Surface>;  ///< of the draws asked for

class SubjectSides {
 public:
  SubjectSides(const Scene& scene, const Subject& subject, const Surfaces& surfaces, FoundSides& found,
               const SideSearchOptions& options, std::uint64_t seed, Analyses& analyses, const Executor& executor)
      : scene_(scene),
        subject_(subject),
        surfaces_(surfaces),
        found_(found),
        options_(options),
        seed_(seed),
        analyses_(analyses),
        executor_(executor) {}

  void search() {
    auto before = found_.wanted;
    for_each_pose(options_.poses, options_.views,
                  [&](const SubjectGeometry& drawn, const Views& views) { add_by_pictures(drawn, views); });
    add_by_rays(back);
    add_ring(before);
    if (leave_out_fronts()) {
      before = found_.wanted;
      for_each_pose(options_.poses, options_.views,
                    [&](const SubjectGeometry& drawn, const Views& views) { add_by_pictures(drawn, views); });
      add_by_rays(front);
      add_ring(before);
    }
    check();
  }

 private:
  /// Poses that look alike are looked at once. Several poses share the views, so that each view is looked at four times
  /// in all.
  void for_each_pose(const Poses& poses, const Views& views, const LookAt& look) {
    const DistinctPoses distinct = distinct_poses(scene_, {&subject_, 1}, poses, executor_).front();
    const auto different =
        static_cast<std::size_t>(std::ranges::count_if(distinct.weights, [](double w) { return w > 0; }));
    const std::size_t looks = std::min(different, std::size_t{4}) * views.views.size();
    const auto shares = shared_views(views.views, different, looks);
    std::size_t number = 0;
    for (std::size_t pose = 0; pose < poses.poses.size(); ++pose) {
      if (distinct.first_alike[pose] != pose) continue;
      Views share{{}, views.size};
      for (const std::size_t v : shares[number++]) share.views.push_back(views.views[v]);
      const PosedNodes nodes = subject_.is_placed() ? posed_nodes(scene_, poses.poses[pose]) : PosedNodes();
      look(subject_geometry(scene_, subject_, Faces::material, nodes, analyses_), share);
    }
  }

  bool is_asked(std::size_t part) const { return found_.wanted.contains(subject_.parts[part].draw); }

  /// What is wanted so far, of each part; of parts that are not asked for, all that they draw.
  SidesOfParts kept(const SubjectGeometry& drawn) const {
    SidesOfParts result;
    for (std::size_t part = 0; part < drawn.parts.size(); ++part) {
      const std::size_t triangles = drawn.parts[part].indices.size() / 3;
      if (is_asked(part) && triangles > 0) {
        result.push_back(found_.wanted.at(subject_.parts[part].draw));
      } else {
        result.emplace_back(triangles, drawn.parts[part].culls_back_faces ? front : both);
      }
    }
    return result;
  }

  void want(const SidesOfParts& kept) {
    for (std::size_t part = 0; part < kept.size(); ++part) {
      if (!is_asked(part)) continue;
      std::vector<Side>& wanted = found_.wanted.at(subject_.parts[part].draw);
      for (std::size_t t = 0; t < kept[part].size(); ++t) wanted[t] = static_cast<Side>(wanted[t] | kept[part][t]);
    }
  }

  Needed add_by_pictures(const SubjectGeometry& drawn, const Views& views) {
    SidesOfParts sides = kept(drawn);
    const Needed needed = add_needed_by_pictures(AllSides(drawn.parts), sides, views, executor_);
    if (needed.pixels > 0) want(sides);
    return needed;
  }

  /// Asks for what is not known to be seen.
  void add_by_rays(Side side) {
    std::size_t poses = 0;
    for_each_pose(options_.poses, {{View{}}, 1}, [&](const SubjectGeometry&, const Views&) { ++poses; });
    const auto in_a_pose = [&](std::size_t rays) { return std::max(fewest_rays, rays / poses); };
    std::uint64_t pose = 0;
    for_each_pose(options_.poses, {{View{}}, 1}, [&](const SubjectGeometry& drawn, const Views&) {
      const RayTree tree = tree_of(drawn.parts);
      const std::uint64_t seed = derive_seed(seed_, side, pose++);
      SidesOfParts open = unknown(drawn, side);
      ask(drawn, tree, open, {in_a_pose(first_rays), seed});
      for (;;) {
        const SidesOfParts near = next_to_seen(drawn, open, side);
        if (!ask(drawn, tree, near, {in_a_pose(static_cast<std::size_t>(options_.rays)), seed})) break;
        for (std::size_t part = 0; part < near.size(); ++part) {
          for (std::size_t t = 0; t < near[part].size(); ++t) {
            if (near[part][t] != neither) open[part][t] = neither;
          }
        }
      }
    });
  }

  /// What touches a side that was found since `before` counts as seen too: samples find the rest of what is seen
  /// through a gap last.
  void add_ring(const std::map<DrawId, std::vector<Side>>& before) {
    for (const auto& [id, surface] : surfaces_) {
      std::vector<Side>& wanted = found_.wanted.at(id);
      std::vector<std::uint8_t> touched(surface.vertices, neither);
      for (std::size_t i = 0; i < surface.indices.size(); ++i) {
        touched[surface.indices[i]] |= static_cast<std::uint8_t>(wanted[i / 3] & ~before.at(id)[i / 3]);
      }
      for (std::size_t i = 0; i < surface.indices.size(); ++i) {
        wanted[i / 3] = static_cast<Side>(wanted[i / 3] | touched[surface.indices[i]]);
      }
    }
  }

  /// The sides that are not known to be seen: of backs those of open components.
  SidesOfParts unknown(const SubjectGeometry& drawn, Side side) const {
    SidesOfParts sides = kept(drawn);
    for (std::size_t part = 0; part < sides.size(); ++part) {
      for (std::size_t t = 0; t < sides[part].size(); ++t) {
        const bool is_open = is_asked(part) && (side == front || !surface(part).is_closed[t]);
        sides[part][t] = is_open && (sides[part][t] & side) == 0 ? side : neither;
      }
    }
    return sides;
  }

  const Surface& surface(std::size_t part) const { return surfaces_.at(subject_.parts[part].draw); }

  /// Whether any was added.
  bool ask(const SubjectGeometry& drawn, const RayTree& tree, const SidesOfParts& about, const RayOptions& rays) {
    SidesOfParts sides = kept(drawn);
    if (add_needed_by_rays(tree, drawn.parts, about, sides, rays, executor_) == 0) return false;
    want(sides);
    return true;
  }

  /// Of open sides those of triangles that share a vertex with one of which that side is seen.
  SidesOfParts next_to_seen(const SubjectGeometry& drawn, const SidesOfParts& open, Side side) const {
    const SidesOfParts sides = kept(drawn);
    SidesOfParts result;
    for (std::size_t part = 0; part < sides.size(); ++part) {
      result.emplace_back(sides[part].size(), neither);
      if (!is_asked(part)) continue;
      const std::vector<std::uint32_t>& indices = surface(part).indices;
      std::vector<bool> is_touched(drawn.parts[part].positions.size(), false);
      for (std::size_t i = 0; i < 3 * sides[part].size(); ++i) {
        if ((sides[part][i / 3] & side) != 0) is_touched[indices[i]] = true;
      }
      for (std::size_t i = 0; i < 3 * sides[part].size(); ++i) {
        const bool may_be_seen = open[part][i / 3] != neither && (sides[part][i / 3] & side) == 0;
        if (may_be_seen && is_touched[indices[i]]) result[part][i / 3] = side;
      }
    }
    return result;
  }

  /// Of triangles whose back is seen, the front may not be: it is asked for anew.
  bool leave_out_fronts() {
    bool any = false;
    for (std::size_t part = 0; part < subject_.parts.size(); ++part) {
      if (!is_asked(part)) continue;
      for (Side& sides : found_.wanted.at(subject_.parts[part].draw)) {
        if (sides != both) continue;
        sides = back;
        any = true;
      }
    }
    return any;
  }

  void check() {
    const bool moves = subject_.is_placed() && !scene_.animations.empty();
    Needed last;
    for (int round = 0; round < most_checks; ++round) {
      const Poses poses = moves ? make_poses(scene_, {.poses = std::to_string(40 + 7 * round)}) : rest_pose;
      Views views{{}, check_size};
      for (const glm::dvec3& direction :
           turned_at_random(fibonacci_directions(static_cast<std::size_t>(options_.checks)),
                            derive_seed(seed_, 2, static_cast<std::uint64_t>(round)))) {
        views.views.push_back({direction});
      }
      Needed needed;
      const auto before = found_.wanted;
      const auto shares = shared_views(views.views, poses.poses.size(), views.views.size());
      for (std::size_t pose = 0; pose < poses.poses.size(); ++pose) {
        Views share{{}, check_size};
        for (const std::size_t v : shares[pose]) share.views.push_back(views.views[v]);
        const PosedNodes nodes = subject_.is_placed() ? posed_nodes(scene_, poses.poses[pose]) : PosedNodes();
        const Needed more =
            add_by_pictures(subject_geometry(scene_, subject_, Faces::material, nodes, analyses_), share);
        needed.pixels += more.pixels;
        needed.shown += more.shown;
      }
      last = needed;
      if (needed.pixels == 0) break;
      add_ring(before);
    }
    found_.last_check.pixels += last.pixels;
    found_.last_check.shown += last.shown;
  }

  const Scene& scene_;
  const Subject& subject_;
  const Surfaces& surfaces_;
  FoundSides& found_;
  const SideSearchOptions& options_;
  std::uint64_t seed_;
  Analyses& analyses_;
  const Executor& executor_;
};

}  // namespace

FoundSides find_sides(const Scene& scene, std::span<const DrawId> asked, const SideSearchOptions& options,
                      Analyses& analyses, const Executor& executor) {
  FoundSides found;
  Surfaces surfaces;
  for (const DrawId id : asked) {
    const Level& level = scene.draws[id].full();
    const std::vector<glm::vec3> positions = decode_vec3(*level.vertices->find("POSITION"));
    const std::vector<std::uint32_t> at = welded(positions);
    Surface& surface = surfaces[id];
    for (const std::uint32_t index : level.stream().indices.view()) surface.indices.push_back(at[index]);
    surface.vertices = positions.size();
    surface.is_closed = closed_outwards(positions, level.stream().indices.view());
    found.wanted[id].assign(level.stream().triangle_count(), front);
    found.is_closed[id] = std::ranges::all_of(surface.is_closed, [](bool is) { return is; });
  }
  const std::vector<Subject> subjects = subjects_of(scene, options.subjects);
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const bool any = std::ranges::any_of(subjects[s].parts,
                                         [&](const SubjectPart& part) { return found.wanted.contains(part.draw); });
    if (!any) continue;
    SubjectSides(scene, subjects[s], surfaces, found, options, derive_seed(options.seed, 0, s), analyses, executor)
        .search();
  }
  return found;
}

}  // namespace foredraw::sides
