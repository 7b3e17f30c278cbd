#include "hidden_search.h"

#include "bodies.h"
#include "camera_views.h"
#include "seen_search.h"
#include "standing_parts.h"

#include <foredraw/base/random.h>
#include <foredraw/viewing/distinct_poses.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/shared_views.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace foredraw::processors::hidden {

namespace {

constexpr std::size_t fewest_rays_in_a_pose = 8;

/// Triangles of a subject that hide each other as they stand, in whatever pose.
struct RigidSight {
  Sight sight;
  std::vector<std::vector<std::uint32_t>> indices;  ///< [part] that the sight looks into
};

class SubjectSearch {
 public:
  SubjectSearch(const Scene& scene, const Subject& subject, const PosedNodes& rest, const std::vector<bool>& is_asked,
                const HiddenSearchOptions& options, std::uint64_t seed, const BetweenSteps& between,
                const Executor& executor)
      : scene_(scene),
        subject_(subject),
        options_(options),
        seed_(seed),
        executor_(executor),
        at_rest_(standing_parts(scene, subject, rest)),
        surface_(at_rest_.parts),
        search_(surface_, what_stays(is_asked), options_, between, executor) {}

  Flags run(FoundHidden& found) {
    if (is_seen_in_clips()) {
      in_all_poses(found);
    } else {
      at_rest(found);
    }
    return search_.hidden();
  }

  /// What of it is hidden without a sample.
  const Flags& proved() const { return search_.proved(); }

 private:
  bool is_seen_in_clips() const {
    return subject_.is_placed() && options_.moving == Moving::clips && !scene_.animations.empty();
  }

  /// What nobody asked for, and what can not be asked.
  Flags what_stays(const std::vector<bool>& is_asked) {
    Flags stays = not_finite(at_rest_.parts);
    std::size_t t = 0;
    for (std::size_t part = 0; part < at_rest_.parts.size(); ++part) {
      for (std::size_t i = 0; i < at_rest_.parts[part].indices.size() / 3; ++i, ++t) {
        if (!is_asked[subject_.parts[part].draw]) stays[t] = 1;
      }
    }
    if (!subject_.is_placed()) {
      const auto cameras = cameras_beside_mesh(options_.cameras, scene_, mesh());
      if (!cameras) return Flags(stays.size(), 1);
      add_body(stands_still, *cameras, std::vector<Body>(stays.size(), stands_still));
      return stays;
    }
    if (is_seen_in_clips()) return stays;
    const std::vector<Body> body = bodies();
    for (std::size_t i = 0; i < stays.size(); ++i) {
      const bool moves = body[i] != stands_still;
      if (body[i] == bends || (moves && !cameras_beside_moving(options_.cameras))) stays[i] = 1;
    }
    const Flags of_several = parts_of_several(body);
    for (const Body one : std::set<Body>(body.begin(), body.end())) {
      if (one == bends) continue;
      const auto cameras = one == stands_still ? std::optional(cameras_beside(options_.cameras))
                                               : cameras_beside_moving(options_.cameras);
      if (cameras) add_body(one, *cameras, body);
    }
    for (std::size_t i = 0; i < stays.size(); ++i) stays[i] |= of_several[i];
    return stays;
  }

  /// Components of which one triangle moves against another stay whole, where they go or stay whole.
  Flags parts_of_several(const std::vector<Body>& body) const {
    Flags flags(body.size(), 0);
    if (options_.unit != Unit::component) return flags;
    std::vector<std::optional<Body>> first(surface_.components());
    const auto component = surface_.component();
    for (std::size_t i = 0; i < body.size(); ++i) {
      auto& its = first[component[i]];
      if (!its) its = body[i];
      flags[i] = *its != body[i];
    }
    return flags;
  }

  std::vector<Body> bodies() const {
    const std::vector<Body> of_nodes = carriers(scene_);
    std::vector<Body> result;
    for (std::size_t part = 0; part < subject_.parts.size(); ++part) {
      if (at_rest_.parts[part].indices.empty()) continue;
      const std::vector<Body> more = bodies_of(scene_, subject_.parts[part], of_nodes);
      result.insert(result.end(), more.begin(), more.end());
    }
    return result;
  }

  MeshId mesh() const {
    const DrawId draw = subject_.parts.front().draw;
    const auto has_draw = [&](const Mesh& one) { return std::ranges::find(one.draws, draw) != one.draws.end(); };
    return static_cast<MeshId>(std::ranges::find_if(scene_.meshes, has_draw) - scene_.meshes.begin());
  }

  void add_body(Body one, const Cameras& cameras, const std::vector<Body>& body) {
    RigidSight& rigid = rigid_.emplace_back();
    rigid.sight.cameras = cameras;
    rigid.sight.hides = at_rest_.hides;
    std::uint32_t number = 0;
    for (const RasterPart& part : at_rest_.parts) {
      std::vector<std::uint32_t>& indices = rigid.indices.emplace_back();
      for (std::size_t i = 0; i + 2 < part.indices.size(); i += 3, ++number) {
        if (body[number] != one) continue;
        const auto corners = part.indices.subspan(i, 3);
        indices.insert(indices.end(), corners.begin(), corners.end());
        rigid.sight.triangles.push_back(number);
      }
      RasterPart of_body = part;
      of_body.indices = indices;
      rigid.sight.parts.push_back(of_body);
    }
  }

  void at_rest(FoundHidden& found) {
    for (std::size_t i = 0; i < rigid_.size(); ++i) {
      const Sight& sight = rigid_[i].sight;
      search_.look(sight, deciding_views(sight.cameras, options_), static_cast<std::size_t>(options_.rays),
                   derive_seed(seed_, 3, i));
    }
    check(found, [&](int round, Pixels& pixels) {
      for (std::size_t i = 0; i < rigid_.size(); ++i) {
        const Sight& sight = rigid_[i].sight;
        pixels += search_.check(sight, checking_views(sight.cameras, options_, round),
                                derive_seed(seed_, 4 + static_cast<std::uint64_t>(round), i));
      }
    });
  }

  /// The whole subject in a pose.
  template <class Look>
  void in_pose(const Pose& pose, const Look& look) const {
    const StandingParts standing = standing_parts(scene_, subject_, posed_nodes(scene_, pose));
    Sight sight{standing.parts, standing.hides, {}, cameras_beside(options_.cameras), false};
    sight.triangles.resize(surface_.component().size());
    std::iota(sight.triangles.begin(), sight.triangles.end(), 0u);
    look(sight);
  }

  void in_all_poses(FoundHidden& found) {
    const Poses all = make_poses(scene_, {.poses = "all"});
    const DistinctPoses distinct = distinct_poses(scene_, {&subject_, 1}, all, executor_).front();
    std::vector<Pose> poses{Pose{}};
    for (std::size_t pose = 0; pose < all.poses.size(); ++pose) {
      if (distinct.first_alike[pose] == pose) poses.push_back(all.poses[pose]);
    }
    found.poses = std::max(found.poses, poses.size());
    const std::vector<View> views = deciding_views(cameras_beside(options_.cameras), options_);
    const auto shares = shared_views(views, poses.size(), std::max(views.size(), poses.size()));
    const std::size_t rays = std::max(fewest_rays_in_a_pose, static_cast<std::size_t>(options_.rays) / poses.size());
    // Pictures of all poses first: rays are for what none of them shows.
    for (const bool by_rays : {false, true}) {
      for (std::size_t pose = 0; pose < poses.size() && search_.hides_any(); ++pose) {
        std::vector<View> share;
        for (const std::size_t v : shares[pose]) share.push_back(views[v]);
        in_pose(poses[pose], [&](const Sight& sight) {
          if (by_rays) return search_.look(sight, {}, rays, derive_seed(seed_, 3, pose));
          search_.look(sight, share, 0, 0);
        });
      }
    }
    check(found, [&](int round, Pixels& pixels) {
      Random random(derive_seed(seed_, 4, static_cast<std::uint64_t>(round)));
      for (const View& view : checking_views(cameras_beside(options_.cameras), options_, round)) {
        in_pose(any_moment(random), [&](const Sight& sight) {
          pixels += search_.check(sight, {&view, 1}, random.next());
        });
      }
    });
  }

  /// Anywhere in any clip.
  Pose any_moment(Random& random) const {
    const auto clip = static_cast<AnimationId>(random.below(scene_.animations.size()));
    double end = 0;
    for (const AnimationChannel& channel : scene_.animations[clip].channels) {
      if (!channel.times.empty()) end = std::max(end, static_cast<double>(channel.times.view().back()));
    }
    return {clip, std::isfinite(end) ? end * random.unit() : 0};
  }

  template <class LookAgain>
  void check(FoundHidden& found, const LookAgain& look_again) {
    Pixels last;
    for (int round = 0; round < most_checks && search_.hides_any(); ++round) {
      last = {};
      look_again(round, last);
      if (last.asked == 0) break;
    }
    found.last_check += last;
  }

  const Scene& scene_;
  const Subject& subject_;
  const HiddenSearchOptions& options_;
  std::uint64_t seed_;
  const Executor& executor_;
  StandingParts at_rest_;
  Connected surface_;
  std::vector<RigidSight> rigid_;
  SeenSearch search_;
};

}  // namespace

FoundHidden find_hidden(const Scene& scene, std::span<const DrawId> asked, const HiddenSearchOptions& options,
                        const BetweenSteps& between, const Executor& executor) {
  FoundHidden found;
  std::vector<bool> is_asked(scene.draws.size(), false);
  for (const DrawId id : asked) {
    is_asked[id] = true;
    found.hidden[id].assign(scene.draws[id].full().stream().triangle_count(), 1);
  }
  const PosedNodes rest = posed_nodes(scene);
  const std::vector<Subject> subjects = subjects_of(scene, options.subjects);
  std::map<DrawId, Flags> proved = found.hidden;
  std::vector<bool> is_looked_at(scene.draws.size(), false);
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const Subject& subject = subjects[s];
    if (std::ranges::none_of(subject.parts, [&](const SubjectPart& part) { return is_asked[part.draw]; })) continue;
    SubjectSearch search(scene, subject, rest, is_asked, options, derive_seed(options.seed, 0, s), between, executor);
    const Flags hidden = search.run(found);
    std::size_t t = 0;
    for (const SubjectPart& part : subject.parts) {
      const Draw& draw = scene.draws[part.draw];
      const std::size_t triangles = drawn_triangles(draw);
      if (is_asked[part.draw] && triangles > 0) {
        is_looked_at[part.draw] = true;
        for (std::size_t i = 0; i < triangles; ++i) {
          found.hidden.at(part.draw)[i] &= hidden[t + i];
          proved.at(part.draw)[i] &= search.proved()[t + i];
        }
      }
      t += triangles;
    }
  }
  for (auto& [id, hidden] : found.hidden) {
    if (!is_looked_at[id]) std::ranges::fill(hidden, 0);  // no mesh has it
    for (std::size_t t = 0; t < hidden.size(); ++t) found.proved += hidden[t] & proved.at(id)[t];
  }
  return found;
}

}  // namespace foredraw::processors::hidden
