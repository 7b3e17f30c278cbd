#include "side_search.h"

#include "side_rays.h"
#include "surface.h"

#include <foredraw/base/random.h>
#include <foredraw/viewing/distinct_poses.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/shared_views.h>
#include <foredraw/viewing/subject_geometry.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>

namespace foredraw::processors::sides {

namespace {

constexpr std::size_t fewest_rays = 2;  // in each pose
constexpr int most_checks = 6;
constexpr int least_check_size = 256;  // pixels
constexpr int fewest_checks = 4;       // the first check is of so many times fewer pictures

/// A subject in a pose.
struct Posed {
  explicit Posed(SubjectGeometry geometry) : drawn(std::move(geometry)), all(drawn.parts) {}

  SubjectGeometry drawn;
  AllSides all;
  std::optional<SideRays> rays;  ///< once they are needed
};

/// A subject in one of its poses, and the views that this pose is looked at from.
using LookAt = std::function<void(Posed&, const Views&)>;

void add(Side& sides, Side more) { sides = static_cast<Side>(sides | more); }

class SubjectSides {
 public:
  SubjectSides(const Scene& scene, const Subject& subject, FoundSides& found, const SideSearchOptions& options,
               std::uint64_t seed, Analyses& analyses, const Executor& executor)
      : scene_(scene),
        subject_(subject),
        found_(found),
        options_(options),
        seed_(seed),
        analyses_(analyses),
        executor_(executor),
        poses_(different_poses()) {}

  /// `progress`: the part done, 0 to 1.
  void search(const std::function<void(double)>& progress) {
    look_at_all(back);
    progress(0.3);
    if (leave_out_fronts()) look_at_all(front);
    progress(0.4);
    grow();
    check([&](double part) { progress(0.4 + 0.6 * part); });
    grow();
    if (!moves()) return;
    for (const DrawId id : asked()) {
      std::vector<Side>& wanted = found_.wanted.at(id);
      if (std::ranges::any_of(wanted, [](Side sides) { return (sides & back) != 0; })) {
        add_rims(found_.surfaces.at(id), wanted);
      }
    }
  }

 private:
  /// Poses that look alike are looked at once. Several poses share the views, so that each view is looked at four times
  /// in all.
  void for_each_pose(const LookAt& look) {
    const Views& views = options_.views;
    const std::size_t looks = std::min(poses_.size(), std::size_t{4}) * views.views.size();
    const auto shares = shared_views(views.views, poses_.size(), looks);
    for (std::size_t i = 0; i < poses_.size() && !is_cancelled(); ++i) {
      Views share{{}, views.size};
      for (const std::size_t v : shares[i]) share.views.push_back(views.views[v]);
      look(*posed(options_.poses.poses[poses_[i]]), share);
    }
  }

  /// Numbers of those poses in which the subject looks as in none before.
  std::vector<std::size_t> different_poses() const {
    const DistinctPoses distinct = distinct_poses(scene_, {&subject_, 1}, options_.poses, executor_).front();
    std::vector<std::size_t> result;
    for (std::size_t pose = 0; pose < options_.poses.poses.size(); ++pose) {
      if (distinct.first_alike[pose] == pose) result.push_back(pose);
    }
    return result;
  }

  std::shared_ptr<Posed> posed(const Pose& pose) {
    if (still_) return still_;
    const PosedNodes nodes = subject_.is_placed() ? posed_nodes(scene_, pose) : PosedNodes();
    const auto made = std::make_shared<Posed>(
        subject_geometry(scene_, subject_, Faces::material, nodes, analyses_, ShownSurface::stored));
    if (!moves()) still_ = made;
    return made;
  }

  const SideRays& rays_of(Posed& posed) const {
    if (!posed.rays) posed.rays.emplace(posed.drawn.parts, surfaces_of_parts(), executor_);
    return *posed.rays;
  }

  bool is_asked(std::size_t part) const { return found_.wanted.contains(subject_.parts[part].draw); }

  /// What is wanted so far.
  SidesOfParts kept(const SubjectGeometry& drawn) const { return sides_of_parts(subject_, drawn.parts, found_.wanted); }

  void want(const SidesOfParts& kept) {
    for (std::size_t part = 0; part < kept.size(); ++part) {
      if (!is_asked(part)) continue;
      std::vector<Side>& wanted = found_.wanted.at(subject_.parts[part].draw);
      for (std::size_t t = 0; t < kept[part].size(); ++t) add(wanted[t], kept[part][t]);
    }
  }

  void look_at_all(Side side) {
    const auto rays = std::max(fewest_rays, static_cast<std::size_t>(options_.rays) / poses_.size());
    std::uint64_t pose = 0;
    for_each_pose([&](Posed& posed, const Views& views) {
      const std::uint64_t seed = derive_seed(seed_, side, pose++);
      SidesOfParts sides = kept(posed.drawn);
      const Needed needed = add_needed_by_pictures(posed.all, sides, views, executor_);
      const SideRays& cast = rays_of(posed);
      cast.beside(needed.seen, sides, derive_seed(seed, 1, 0));
      // Few rays at first: most of what more would find lies beside what these find.
      for (std::size_t done = 0, some; done < rays; done += some) {
        some = std::min(std::max(fewest_rays, done), rays - done);
        const std::vector<Seen> through = cast.through_openings(unknown(sides, side), some, derive_seed(seed, 2, done));
        for (const Seen& one : through) add(sides[one.part][one.triangle], one.side);
        cast.beside(through, sides, derive_seed(seed, 3, done));
      }
      want(sides);
    });
  }

  std::vector<const Surface*> surfaces_of_parts() const {
    std::vector<const Surface*> result;
    for (std::size_t part = 0; part < subject_.parts.size(); ++part) {
      result.push_back(is_asked(part) ? &surface(part) : nullptr);
    }
    return result;
  }

  /// Those of the subject.
  std::set<DrawId> asked() const {
    std::set<DrawId> ids;
    for (std::size_t part = 0; part < subject_.parts.size(); ++part) {
      if (is_asked(part)) ids.insert(subject_.parts[part].draw);
    }
    return ids;
  }

  void grow() {
    for (const DrawId id : asked()) add_neighbours(found_.surfaces.at(id), found_.wanted.at(id));
  }

  /// The sides that will not be kept by what is known: of backs those of open components.
  SidesOfParts unknown(SidesOfParts sides, Side side) const {
    for (std::size_t part = 0; part < sides.size(); ++part) {
      if (is_asked(part) && !sides[part].empty()) add_neighbours(surface(part), sides[part]);
      for (std::size_t t = 0; t < sides[part].size(); ++t) {
        const bool is_open = is_asked(part) && (side == front || !surface(part).is_closed[t]);
        sides[part][t] = is_open && (sides[part][t] & side) == 0 ? side : neither;
      }
    }
    return sides;
  }

  const Surface& surface(std::size_t part) const { return found_.surfaces.at(subject_.parts[part].draw); }

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

  bool moves() const { return subject_.is_placed() && !scene_.animations.empty(); }
  bool is_cancelled() const { return options_.cancel != nullptr && options_.cancel->load(std::memory_order_relaxed); }

  void check(const std::function<void(double)>& progress) {
    Needed last;
    int pictures = std::max(1, options_.checks / fewest_checks);
    for (int round = 0; round < most_checks && !is_cancelled(); ++round) {
      const auto before = found_.wanted;
      last = checked(round, pictures);
      if (last.pixels == 0 && pictures == options_.checks) break;
      pictures = last.pixels == 0 ? options_.checks : std::min(2 * pictures, options_.checks);
      for (const DrawId id : asked()) {
        std::vector<Side>& wanted = found_.wanted.at(id);
        if (wanted == before.at(id)) continue;
        add_neighbours(found_.surfaces.at(id), wanted);
        add_rims(found_.surfaces.at(id), wanted);
      }
      progress((round + 1.0) / most_checks);
    }
    found_.wrong += last.pixels;
    found_.shown += last.shown;
  }

  /// A picture of many triangles has a pixel for each of their sides, as it costs no more then; and there are fewer.
  int check_size() const {
    const auto sides = 2 * static_cast<double>(count_triangles(scene_, subject_));
    return std::max(least_check_size, static_cast<int>(std::sqrt(sides)));
  }

  /// What so many pictures need from other views, and at other times in each round, is added.
  Needed checked(int round, int pictures) {
    const Poses poses = moves() ? make_poses(scene_, {.poses = std::to_string(40 + 7 * round)}) : rest_pose;
    const int size = check_size();
    const int fewer = std::max(1, pictures * least_check_size * least_check_size / (size * size));
    std::vector<View> views;
    for (const glm::dvec3& direction : turned_at_random(fibonacci_directions(static_cast<std::size_t>(fewer)),
                                                        derive_seed(seed_, 4, static_cast<std::uint64_t>(round)))) {
      views.push_back({direction});
    }
    const auto shares = shared_views(views, poses.poses.size(), views.size());
    struct OfPose {
      Needed needed;
      SidesOfParts sides;  // none where nothing was added
    };
    std::vector<OfPose> of_poses(poses.poses.size());
    executor_.for_each(of_poses.size(), [&](std::size_t pose) {
      if (shares[pose].empty()) return;
      Views share{{}, size};
      for (const std::size_t v : shares[pose]) share.views.push_back(views[v]);
      const auto posed = this->posed(poses.poses[pose]);
      SidesOfParts sides = kept(posed->drawn);
      Needed& needed = of_poses[pose].needed;
      needed = add_needed_by_pictures(posed->all, sides, share, executor_);
      if (needed.pixels == 0) return;
      rays_of(*posed).beside(needed.seen, sides, derive_seed(seed_, 5, static_cast<std::uint64_t>(round)));
      of_poses[pose].sides = std::move(sides);
    });
    Needed sum;
    for (const OfPose& one : of_poses) {
      sum.shown += one.needed.shown;
      sum.pixels += one.needed.pixels;
      want(one.sides);
    }
    return sum;
  }

  const Scene& scene_;
  const Subject& subject_;
  FoundSides& found_;
  const SideSearchOptions& options_;
  std::uint64_t seed_;
  Analyses& analyses_;
  const Executor& executor_;
  std::vector<std::size_t> poses_;  ///< of the options, those that look different
  std::shared_ptr<Posed> still_;    ///< of a subject that does not move: made once
};

}  // namespace

FoundSides find_sides(const Scene& scene, std::span<const DrawId> asked, const SideSearchOptions& options,
                      Analyses& analyses, const Executor& executor) {
  FoundSides found;
  for (const DrawId id : asked) {
    const Level& level = scene.draws[id].full();
    const std::vector<glm::vec3> positions = decode_vec3(*level.vertices->find("POSITION"));
    found.surfaces[id] = surface_of(positions, level.stream().indices.view());
    found.wanted[id].assign(level.stream().triangle_count(), front);
  }
  const std::vector<Subject> subjects = subjects_of(scene, options.subjects);
  const auto triangles_of = [&](const Subject& subject) {
    const bool any =
        std::ranges::any_of(subject.parts, [&](const SubjectPart& part) { return found.wanted.contains(part.draw); });
    return any ? static_cast<double>(count_triangles(scene, subject)) : 0;
  };
  double all = 0, done = 0;
  for (const Subject& subject : subjects) all += triangles_of(subject);
  const auto is_cancelled = [&] {
    return options.cancel != nullptr && options.cancel->load(std::memory_order_relaxed);
  };
  const Executor until_cancelled(executor.threads(),
                                 [&](std::size_t count, const std::function<void(std::size_t)>& task) {
                                   executor.for_each(count, [&](std::size_t i) {
                                     if (!is_cancelled()) task(i);
                                   });
                                 });
  for (std::size_t s = 0; s < subjects.size() && !is_cancelled(); ++s) {
    const double triangles = triangles_of(subjects[s]);
    if (triangles == 0) continue;
    SubjectSides(scene, subjects[s], found, options, derive_seed(options.seed, 0, s), analyses, until_cancelled)
        .search([&](double part) {
          if (options.progress) options.progress((done + part * triangles) / all);
        });
    done += triangles;
  }
  return found;
}

}  // namespace foredraw::processors::sides
