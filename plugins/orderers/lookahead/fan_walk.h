#pragma once
// A mesh while fans of its triangles are drawn through a vertex cache: which triangles are left, what the cache holds,
// and what it has cost. Fans can be drawn on trial and taken back.

#include "age_set.h"

#include <foredraw/analysis/vertex_cache.h>

#include <algorithm>
#include <cstdint>
#include <memory_resource>
#include <span>
#include <vector>

namespace foredraw {

/// What the walk goes by. Costs are in 1/1024 of a vertex shaded once more; an age is the number of vertices that have
/// entered the cache since, and `age` below is that over the cache's size, so 0 to 1.
struct FanWeights {
  // A vertex is paid for when it leaves the cache with triangles left, for then it is shaded again: 1024. A smaller
  // cache than the one that is modelled would have lost it before, so that even a vertex that is done costs something
  // by its age.
  int done;        ///< times age^done_power: a vertex whose last triangle is drawn
  int done_power;  ///< the higher, the fewer smaller caches are minded
  // The outlook is what the vertices in the cache that have triangles left will probably cost.
  int waiting;       ///< for each such vertex
  int waiting_old;   ///< times age^3
  int waiting_open;  ///< times age, for each end of its remaining triangles that is not in the cache
  // How promising a vertex is as the next fan's centre.
  int prefer_old;   ///< for each entry of age
  int avoid_large;  ///< for each triangle left
  int avoid_new;    ///< for each end that is not in the cache
  int reserve;      ///< half entries to spare when its fan is drawn; else it will be too late
};

class FanWalk {
 public:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  /// How promising a centre is whose fan brings in nothing new: more than all else that makes promising.
  static constexpr int unopposed = 1 << 21;

  /// The triangles' numbers go into `order` as they are drawn. The spans must outlive the walk.
  FanWalk(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
          const BatchModel& cache, const FanWeights& weights, std::pmr::memory_resource& memory);

  /// Where to go on: of the vertices with triangles left those in the cache, the most promising first, `most` of them
  /// at most; where there are none, those that entered it last; where they are done too, the next in input order.
  /// Left out is who is less promising than the first by more than `margin`. None when all is drawn. Valid until the
  /// next call.
  std::span<const std::uint32_t> promising(std::size_t most, int margin);
  /// The most promising in the cache, or none.
  std::uint32_t most_promising() const;

  /// Draws the triangles left around a vertex: how many.
  std::uint32_t draw(std::uint32_t center);

  /// What the vertices in the cache will probably cost.
  int outlook() const;

  /// What is drawn while it lives is taken back when it dies.
  class Trial {
   public:
    explicit Trial(FanWalk& walk);
    ~Trial();
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    int cost() const { return walk_.cost_; }  ///< since it began
    bool is_long() const;                     ///< so much has been drawn that it should end

   private:
    FanWalk& walk_;
    AgeSet waiting_;
    std::uint32_t time_, batch_vertices_, batch_triangles_;
  };

 private:
  /// A vertex with more triangles is walked as several, so that no step is longer than others.
  static constexpr std::uint32_t largest_fan = 32;

  struct Vertex {
    std::uint32_t corners = 0;  ///< where its corners begin; they end where the next vertex's begin
    std::uint32_t entered = 0;  ///< the time at which it last entered the cache
    std::uint32_t live = 0;     ///< its triangles not yet drawn
    std::uint32_t met = 0;      ///< of their other corners, two each, those in the cache
  };

  /// A triangle as seen from one of its vertices: the other two, as the triangle goes around.
  struct Corner {
    std::uint32_t number;  ///< 3 * triangle + place in the triangle
    std::uint32_t next, last;

    Corner() {}  // written before it is read
    Corner(std::uint32_t number, std::uint32_t next, std::uint32_t last) : number(number), next(next), last(last) {}
  };

  struct Change {
    std::uint32_t* what;
    std::uint32_t before;
  };

  void find_corners(std::span<const std::uint32_t> indices, std::size_t vertex_count,
                    std::pmr::memory_resource& memory);
  void sort_around(std::span<Corner> corners) const;
  std::uint32_t fan_around(std::uint32_t center, std::span<std::uint32_t> fan) const;

  std::uint32_t age(const Vertex& v) const { return time_ - v.entered; }
  bool is_cached(const Vertex& v) const { return age(v) <= cache_.cache_size; }
  bool is_live(const Corner& c) const { return std::min(vertices_[c.next].live, vertices_[c.last].live) != 0; }
  std::uint32_t& entrant(std::uint32_t time) { return entrants_[time & (entrants_.size() - 1)]; }
  std::uint32_t entrant(std::uint32_t time) const { return entrants_[time & (entrants_.size() - 1)]; }
  void begin_anew(std::size_t most);
  int promise(const Vertex& v, std::uint32_t age) const;

  template <bool on_trial>
  std::uint32_t draw_fan(std::uint32_t center);
  template <bool on_trial>
  void touch(std::uint32_t vertex, std::uint32_t began);
  template <bool on_trial>
  void enter(std::uint32_t vertex);
  template <bool on_trial>
  std::uint32_t tell_neighbours(std::uint32_t of, std::uint32_t change);
  template <bool on_trial>
  void make_room(const std::uint32_t (&triangle)[3]);
  template <bool on_trial>
  void set(std::uint32_t& what, std::uint32_t value);
  void finish(std::uint32_t age);
  void allow_changes(std::size_t more);

  BatchModel cache_;
  FanWeights weights_;
  std::pmr::vector<Vertex> vertices_;  ///< two more at the end: nobody, somebody
  std::pmr::vector<Corner> corners_;
  std::span<std::uint32_t> order_;
  std::size_t drawn_ = 0;
  std::pmr::vector<std::uint32_t> entrants_;  ///< who entered the cache at which time: a ring
  std::uint32_t time_;                        ///< how many have entered
  AgeSet waiting_;                            ///< the ages of the cached vertices with triangles left
  std::uint32_t batch_vertices_ = 0, batch_triangles_ = 0;
  std::pmr::vector<std::uint32_t> trail_;  ///< who entered, the latest last: the way back
  std::uint32_t cursor_ = 0;               ///< all vertices before it are used up
  std::pmr::vector<std::pair<int, std::uint32_t>> ranking_;
  std::pmr::vector<std::uint32_t> ranked_;
  std::pmr::vector<int> done_cost_, waiting_cost_;  ///< by age

  bool on_trial_ = false;
  int cost_ = 0;
  std::pmr::vector<Change> changes_;  ///< what the trial changed: room for it, of which
  std::size_t changed_ = 0;           ///< so much is used
};

}  // namespace foredraw
