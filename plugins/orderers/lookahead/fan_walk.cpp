#include "fan_walk.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace foredraw {

namespace {

constexpr std::uint32_t longest_trial = 512;  // entrants
constexpr std::uint32_t farthest_start = 64;  // places behind the first, where a strip begins

/// age^power, of `scale` at an age of 1.
int at_age(int scale, std::uint32_t age, std::uint32_t cache_size, int power) {
  std::int64_t numerator = scale, denominator = 1;
  for (int i = 0; i < power; ++i) {
    numerator *= age;
    denominator *= cache_size;
  }
  return static_cast<int>(numerator / denominator);
}

}  // namespace

FanWalk::FanWalk(std::span<std::uint32_t> order, std::span<const std::uint32_t> indices, std::size_t vertex_count,
                 const BatchModel& cache, const FanWeights& weights, std::pmr::memory_resource& memory)
    : cache_(cache),
      weights_(weights),
      vertices_(&memory),
      corners_(&memory),
      order_(order),
      entrants_(std::bit_ceil(cache.cache_size * (largest_fan + 1) + longest_trial + 3 * largest_fan), &memory),
      time_(cache.cache_size + 1),
      waiting_(cache.cache_size),
      trail_(&memory),
      ranking_(&memory),
      ranked_(&memory),
      done_cost_(cache.cache_size + std::size_t{1}, &memory),
      waiting_cost_(cache.cache_size + std::size_t{1}, &memory),
      changes_(&memory) {
  find_corners(indices, vertex_count, memory);
  std::ranges::fill(entrants_, static_cast<std::uint32_t>(vertices_.size() - 2));  // nobody
  for (std::uint32_t age = 0; age <= cache.cache_size; ++age) {
    done_cost_[age] = at_age(weights.done, age, cache.cache_size, weights.done_power);
    waiting_cost_[age] = weights.waiting + done_cost_[age] + at_age(weights.waiting_old, age, cache.cache_size, 3);
  }
}

std::span<const std::uint32_t> FanWalk::promising(std::size_t most, int margin) {
  ranking_.clear();
  int best = std::numeric_limits<int>::min();
  waiting_.for_each([&](std::uint32_t age) {
    const std::uint32_t v = entrant(time_ - age);
    ranking_.emplace_back(-promise(vertices_[v], age), v);
    best = std::max(best, -ranking_.back().first);
  });
  std::erase_if(ranking_, [&](const auto& ranked) { return -ranked.first < best - margin; });
  const std::size_t count = std::min(most, ranking_.size());
  std::partial_sort(ranking_.begin(), ranking_.begin() + count, ranking_.end());
  ranked_.clear();
  for (std::size_t i = 0; i < count; ++i) ranked_.push_back(ranking_[i].second);
  if (ranked_.empty()) begin_anew(most);
  return ranked_;
}

/// A strip has run dry, or a part of the mesh is done that touches no other. What stands close to the place where it is
/// easiest to begin is on offer too: a strip is the better for a good beginning, such as a corner.
void FanWalk::begin_anew(std::size_t most) {
  const auto is_done = [&](std::uint32_t v) { return vertices_[v].live == 0; };
  const auto offer = [&](std::uint32_t v) {
    const bool is_new = !is_done(v) && std::ranges::find(ranked_, v) == ranked_.end();
    if (is_new && ranked_.size() < most) ranked_.push_back(v);
  };
  const auto nobody = static_cast<std::uint32_t>(vertices_.size() - 2);
  while (!trail_.empty() && is_done(trail_.back())) trail_.pop_back();
  while (cursor_ < nobody && is_done(cursor_)) ++cursor_;
  if (!trail_.empty()) {
    const std::size_t places = std::min<std::size_t>(trail_.size(), farthest_start);
    for (std::size_t i = 1; i <= places; ++i) offer(trail_[trail_.size() - i]);
  } else {
    const std::uint32_t places = std::min(nobody - cursor_, farthest_start);
    for (std::uint32_t i = 0; i < places; ++i) offer(cursor_ + i);
  }
}

std::uint32_t FanWalk::most_promising() const {
  std::uint32_t best = none;
  int most = std::numeric_limits<int>::min();
  waiting_.for_each([&](std::uint32_t age) {
    const std::uint32_t v = entrant(time_ - age);
    const int it = promise(vertices_[v], age);
    best = it >= most ? v : best;
    most = std::max(it, most);
  });
  return best;
}

/// The older the better, as long as it stays in the cache until its fan is drawn; it should bring in little that is
/// new.
int FanWalk::promise(const Vertex& v, std::uint32_t age) const {
  const int open = static_cast<int>(2 * v.live - v.met);
  const int size = static_cast<int>(cache_.cache_size);
  const bool in_time = 2 * static_cast<int>(age) + open + weights_.reserve <= 2 * size;  // in half entries
  const int when = weights_.prefer_old * static_cast<int>(age);
  const int too_late = 1 << 20;
  return (open == 0 ? unopposed : 0) + (in_time ? when : -when - too_late) -
         weights_.avoid_large * static_cast<int>(v.live) - weights_.avoid_new * open;
}

int FanWalk::outlook() const {
  int sum = 0;
  waiting_.for_each([&](std::uint32_t age) {
    const Vertex& v = vertices_[entrant(time_ - age)];
    const int open = static_cast<int>(2 * v.live - v.met);
    sum +=
        waiting_cost_[age] + weights_.waiting_open * open * static_cast<int>(age) / static_cast<int>(cache_.cache_size);
  });
  return sum;
}

std::uint32_t FanWalk::draw(std::uint32_t center) {
  return on_trial_ ? draw_fan<true>(center) : draw_fan<false>(center);
}

template <bool on_trial>
void FanWalk::set(std::uint32_t& what, std::uint32_t value) {
  if constexpr (on_trial) changes_[changed_++] = {&what, what};
  what = value;
}

void FanWalk::allow_changes(std::size_t more) {
  if (changes_.size() < changed_ + more) changes_.resize(2 * changes_.size() + more);
}

/// What is left around a vertex, from the end that has been in the cache for longer: the numbers of the corners.
std::uint32_t FanWalk::fan_around(std::uint32_t center, std::span<std::uint32_t> fan) const {
  const std::uint32_t begin = vertices_[center].corners, end = vertices_[center + 1].corners;
  std::uint32_t count = 0, start = 0;
  bool after_live = is_live(corners_[end - 1]);
  for (std::uint32_t i = begin; i < end; ++i) {
    const bool live = is_live(corners_[i]);
    start = live && !after_live ? count : start;
    fan[count] = i;
    count += live;
    after_live = live;
  }
  const auto drawn = fan.first(count);
  if (start > 0) std::rotate(drawn.begin(), drawn.begin() + start, drawn.end());
  const auto age_in_cache = [&](std::uint32_t v) { return is_cached(vertices_[v]) ? age(vertices_[v]) : 0; };
  if (count > 1 && age_in_cache(corners_[drawn.back()].last) > age_in_cache(corners_[drawn.front()].next)) {
    std::ranges::reverse(drawn);
  }
  return count;
}

template <bool on_trial>
std::uint32_t FanWalk::draw_fan(std::uint32_t center) {
  std::uint32_t fan[largest_fan + 1];
  const std::uint32_t count = fan_around(center, fan);
  if constexpr (on_trial) allow_changes(4 * largest_fan + 1);

  // First the triangles are taken from their vertices, so that whoever enters the cache finds those that will be left.
  const bool held = is_cached(vertices_[center]);
  for (std::uint32_t i = 0; i < count; ++i) {
    Vertex& a = vertices_[corners_[fan[i]].next];
    Vertex& b = vertices_[corners_[fan[i]].last];
    const bool a_held = is_cached(a), b_held = is_cached(b);
    set<on_trial>(a.live, a.live - 1);
    set<on_trial>(b.live, b.live - 1);
    if (a_held) set<on_trial>(a.met, a.met - held - b_held);
    if (b_held) set<on_trial>(b.met, b.met - held - a_held);
    if (a_held && a.live == 0) finish(age(a));
    if (b_held && b.live == 0) finish(age(b));
  }
  set<on_trial>(vertices_[center].live, 0);
  if (held) finish(age(vertices_[center]));

  const std::uint32_t began = time_;
  for (std::uint32_t i = 0; i < count; ++i) {
    const Corner corner = corners_[fan[i]];
    const std::uint32_t place = corner.number % 3;
    std::uint32_t triangle[3];
    triangle[place] = center;
    triangle[(place + 1) % 3] = corner.next;
    triangle[(place + 2) % 3] = corner.last;
    if (cache_.warp_size != 0 || cache_.primitive_group != 0) make_room<on_trial>(triangle);
    for (const std::uint32_t v : triangle) touch<on_trial>(v, began);
    if constexpr (!on_trial) order_[drawn_++] = corner.number / 3;
  }
  return count;
}

/// Empties the cache where the batch can not hold the triangle.
template <bool on_trial>
void FanWalk::make_room(const std::uint32_t (&triangle)[3]) {
  std::uint32_t missing = 0;
  for (const std::uint32_t v : triangle) missing += !is_cached(vertices_[v]);
  const bool full = (cache_.warp_size != 0 && batch_vertices_ + missing > cache_.warp_size) ||
                    (cache_.primitive_group != 0 && batch_triangles_ == cache_.primitive_group);
  if (full) {
    const auto nobody = static_cast<std::uint32_t>(vertices_.size() - 2);
    for (std::uint32_t i = 0; i < cache_.cache_size; ++i) enter<on_trial>(nobody);
    batch_vertices_ = batch_triangles_ = 0;
    missing = 3;
  }
  batch_vertices_ += missing;
  ++batch_triangles_;
}

template <bool on_trial>
void FanWalk::touch(std::uint32_t vertex, std::uint32_t began) {
  const Vertex& v = vertices_[vertex];
  if (is_cached(v) || vertex + 1 == vertices_.size()) return;
  // It was in the cache when its last triangles were taken, and so has not been paid for when it fell out.
  if (v.live == 0 && v.entered != 0 && began - v.entered <= cache_.cache_size) cost_ += 1024;
  enter<on_trial>(vertex);
  if constexpr (!on_trial) trail_.push_back(vertex);
}

/// The last triangle is taken from a vertex of that age.
void FanWalk::finish(std::uint32_t age) {
  cost_ += done_cost_[age];
  waiting_.remove(age);
}

/// Puts a vertex into the cache; who has been in it for longest leaves.
template <bool on_trial>
void FanWalk::enter(std::uint32_t vertex) {
  const bool is_live = vertices_[vertex].live != 0;
  const bool one_is_lost = waiting_.grow_older(is_live);
  if constexpr (on_trial) allow_changes(2);
  set<on_trial>(vertices_[vertex].entered, time_);
  entrant(time_++) = vertex;
  if (one_is_lost) {
    cost_ += 1024 + done_cost_[cache_.cache_size];
    tell_neighbours<on_trial>(entrant(time_ - 1 - cache_.cache_size), ~std::uint32_t{0});
  }
  if (is_live) set<on_trial>(vertices_[vertex].met, tell_neighbours<on_trial>(vertex, 1));
}

/// Tells those around a vertex that are in the cache that it is there too (1), or no longer (-1); how often it did.
template <bool on_trial>
std::uint32_t FanWalk::tell_neighbours(std::uint32_t of, std::uint32_t change) {
  if constexpr (on_trial) allow_changes(2 * largest_fan + 1);
  Vertex* const vertices = vertices_.data();
  Change* changed = changes_.data() + changed_;
  const std::uint32_t time = time_, size = cache_.cache_size;
  std::uint32_t met = 0;
  const auto tell = [&](Vertex& v, bool live) {
    const bool meets = (time - v.entered <= size) && live;  // no branch: there is no pattern
    if constexpr (on_trial) {
      *changed = {&v.met, v.met};
      changed += meets;
    }
    v.met += meets ? change : 0;
    met += meets;
  };
  const Corner* const end = &corners_[0] + vertices[of + 1].corners;
  for (const Corner* corner = &corners_[0] + vertices[of].corners; corner != end; ++corner) {
    Vertex &next = vertices[corner->next], &last = vertices[corner->last];
    const bool live = std::min(next.live, last.live) != 0;
    tell(next, live);
    tell(last, live);
  }
  changed_ = static_cast<std::size_t>(changed - changes_.data());
  return met;
}

FanWalk::Trial::Trial(FanWalk& walk)
    : walk_(walk),
      waiting_(walk.waiting_),
      time_(walk.time_),
      batch_vertices_(walk.batch_vertices_),
      batch_triangles_(walk.batch_triangles_) {
  walk.on_trial_ = true;
  walk.cost_ = 0;
}

bool FanWalk::Trial::is_long() const { return walk_.time_ - time_ > longest_trial; }

FanWalk::Trial::~Trial() {
  for (std::size_t& changed = walk_.changed_; changed > 0; --changed) {
    *walk_.changes_[changed - 1].what = walk_.changes_[changed - 1].before;
  }
  walk_.on_trial_ = false;
  walk_.waiting_ = waiting_;
  walk_.time_ = time_;
  walk_.batch_vertices_ = batch_vertices_;
  walk_.batch_triangles_ = batch_triangles_;
}

}  // namespace foredraw
