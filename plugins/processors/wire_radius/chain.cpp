#include "chain.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace foredraw::processors::wire_radius {

namespace {

constexpr std::size_t most_steps = 128;  // triangles round a wire
constexpr std::size_t most_walk = 512;
constexpr double usual_step = 0.75;  // half widths

/// Which of the 13 lines through a cube's centre, to its faces, edges and corners, the direction is nearest to.
int line_near(const glm::dvec3& direction) {
  static constexpr int lines[13][3] = {{1, 0, 0}, {0, 1, 0},  {0, 0, 1}, {1, 1, 0},  {1, -1, 0}, {1, 0, 1}, {1, 0, -1},
                                       {0, 1, 1}, {0, 1, -1}, {1, 1, 1}, {-1, 1, 1}, {1, -1, 1}, {1, 1, -1}};
  int best = 0;
  double most = -1;
  for (int i = 0; i < 13; ++i) {
    const glm::dvec3 line(lines[i][0], lines[i][1], lines[i][2]);
    const double along = glm::dot(line, direction);
    const double squared = along * along / glm::dot(line, line);
    if (squared > most) {
      most = squared;
      best = i;
    }
  }
  return best;
}

}  // namespace

double Chain::length() const {
  if (sections.empty()) return 0;
  const double way = sections.back().along;
  return closed ? way + glm::distance(sections.back().section.centre, sections.front().section.centre) : way;
}

ChainFollower::ChainFollower(const WeldedMesh& mesh, const ChainLimits& limits)
    : mesh_(mesh),
      limits_(limits),
      cutter_(mesh),
      straight_(mesh),
      tried_(mesh.triangles.size(), 0),
      last_cut_(mesh.triangles.size()),
      between_(mesh.triangles.size(), 0) {}

bool ChainFollower::was_tried(std::uint32_t triangle, const glm::dvec3& direction) const {
  return (tried_[triangle] >> line_near(direction) & 1) != 0;
}

void ChainFollower::mark(std::span<const std::uint32_t> triangles, const glm::dvec3& direction) {
  const auto bit = static_cast<std::uint16_t>(1u << line_near(direction));
  for (const std::uint32_t t : triangles) tried_[t] |= bit;
}

bool ChainFollower::was_followed(const At& at) const {
  return std::ranges::all_of(at.triangles, [&](std::uint32_t t) { return was_tried(t, at.section.axis); });
}

void ChainFollower::mark_between(const At& from, const At& to) {
  const Plane low{from.section.section.centre, from.section.axis}, high{to.section.section.centre, to.section.axis};
  const auto bits = static_cast<std::uint16_t>(1u << line_near(low.normal) | 1u << line_near(high.normal));
  ++calls_;
  waiting_ = from.triangles;
  for (const std::uint32_t t : from.triangles) between_[t] = calls_;
  while (!waiting_.empty()) {
    const std::uint32_t t = waiting_.back();
    waiting_.pop_back();
    for (const std::uint32_t other : mesh_.across[t]) {
      if (other == none || between_[other] == calls_) continue;
      between_[other] = calls_;
      const bool is_between = std::ranges::all_of(mesh_.triangles[other], [&](std::uint32_t point) {
        return low.height(mesh_.points[point]) >= 0 && high.height(mesh_.points[point]) < 0;
      });
      if (!is_between) continue;
      tried_[other] |= bits;
      waiting_.push_back(other);
    }
  }
}

bool ChainFollower::is_steady(const Section& before, const Section& after, double step) const {
  if (before.closed != after.closed) return false;
  const double was = before.half_width(), is = after.half_width();
  if (!(was > 0) || !(is > 0)) return false;
  // As a slope, so that smaller steps towards an end allow for less.
  const double most = limits_.steadiness * std::max(step / usual_step, 0.02 * was);
  return std::abs(is - was) <= most && after.mean_half_width() <= 1.25 * before.mean_half_width() + most;
}

void ChainFollower::keep_cut(Cutter& cutter, std::uint32_t triangle, const Plane& plane, At& at) {
  at.section = {cutter.section(), plane.normal, triangle, 0};
  at.next_corner = cutter.next_corner(plane);
  at.triangles.assign(cutter.triangles().begin(), cutter.triangles().end());
}

bool ChainFollower::cut_at(std::uint32_t triangle, const Plane& plane, At& at) {
  if (!cutter_.cut(triangle, plane, most_steps, most_perimeter_)) {
    mark(cutter_.triangles(), plane.normal);
    return false;
  }
  oblique_ = cutter_.triangles();
  const Plane turned{cutter_.centre(), cutter_.axis(plane)};
  if (glm::dot(turned.normal, plane.normal) <= 0.9999) {
    const std::uint32_t there = cutter_.walk(triangle, turned, most_walk);
    if (there != none && straight_.cut(there, turned, most_steps, most_perimeter_) &&
        straight_.is_closed() == cutter_.is_closed() && straight_.perimeter() <= 1.05 * cutter_.perimeter()) {
      keep_cut(straight_, there, turned, at);
      return true;
    }
  }
  keep_cut(cutter_, triangle, plane, at);
  return true;
}

/// Sections one after the other cut the same triangles; what was cut earlier, and not since, lies behind.
int ChainFollower::turns_back(std::span<const std::uint32_t> triangles, int number) {
  constexpr int most_apart = 4;
  int turns = 0;
  for (const std::uint32_t t : triangles) {
    if (last_cut_[t].chain == chain_ && std::abs(last_cut_[t].number - number) > most_apart) {
      turns = std::max(turns, std::abs(last_cut_[t].number - number));
    }
    last_cut_[t] = {chain_, number};
  }
  return turns;
}

/// Adds sections on one side, from where it ends so far. Where the next one is not like the last, steps are halved so
/// many times.
void ChainFollower::extend(End& end, double began, int halvings) {
  At next;
  while (!end.is_closed) {
    const ChainSection& now = end.last.section;
    const double half = now.section.mean_half_width();
    // Where corners are far apart, sections change evenly up to just before the next ones.
    double step = end.last.next_corner > 2 * usual_step * half ? end.last.next_corner - 0.05 * half : usual_step * half;
    bool found = false;
    for (int halving = 0; halving < halvings && !found; ++halving, step /= 2) {
      const Plane plane{now.section.centre + step * now.axis, now.axis};
      const std::uint32_t there = cutter_.walk(now.triangle, plane, most_walk);
      if (there == none || !cut_at(there, plane, next)) continue;
      const glm::dvec3 moved = next.section.section.centre - now.section.centre;
      found = is_steady(now.section, next.section.section, step) &&
              glm::length(moved - step * now.axis) <= half + 0.5 * step &&
              glm::dot(moved, now.axis) > 0.25 * glm::length(moved);
    }
    const double is = found ? next.section.section.half_width() : 0;
    if (!found || is > limits_.taper * began || began > limits_.taper * is) return;
    mark(next.triangles, next.section.axis);
    mark_between(end.last, next);
    const int number = ++end.steps;
    if (const int turns = turns_back(next.triangles, end.is_behind ? -number : number); turns > 0) {
      end.is_closed = true;
      end.turns = turns;
      return;
    }
    end.length += glm::distance(now.section.centre, next.section.section.centre);
    end.sections.push_back(next.section);
    std::swap(end.last, next);
  }
}

Chain ChainFollower::follow(std::uint32_t triangle, const glm::dvec3& direction) {
  Chain chain;
  if (was_tried(triangle, direction)) return chain;
  const auto& [a, b, c] = mesh_.triangles[triangle];
  const glm::dvec3 middle = (mesh_.points[a] + mesh_.points[b] + mesh_.points[c]) / 3.0;
  const Plane plane{middle, direction};
  if (!cutter_.crosses(triangle, plane)) return chain;
  const double area = mesh_.shell_area[mesh_.shell[triangle]];
  // A tube of circumference P and length l has the area P l, of which the shell has no more.
  most_perimeter_ = 1.2 * std::sqrt(std::numbers::pi * area / limits_.slender);
  At first;
  const bool is_cut = cut_at(triangle, plane, first);
  const bool is_known = is_cut && was_followed(first);
  if (is_cut) mark(oblique_, direction);
  mark(is_cut ? std::span<const std::uint32_t>(first.triangles) : cutter_.triangles(), direction);
  const Section& section = first.section.section;
  if (!is_cut || is_known || !(section.half_width() > 0)) return chain;
  // Sections may be a little oblique, but not so much.
  if (section.closed && section.greatest > 2 * limits_.aspect * section.least) return chain;
  mark(first.triangles, first.section.axis);
  ++chain_;
  turns_back(first.triangles, 0);
  End ahead{.last = first}, behind{.last = first, .is_behind = true};
  const Plane back{first.section.section.centre, -first.section.axis};
  const bool goes_back = cutter_.cut(first.section.triangle, back, most_steps, most_perimeter_);
  if (goes_back) keep_cut(cutter_, first.section.triangle, back, behind.last);
  const double began = first.section.section.half_width();
  // Ends are looked for closely where a wire may have some: most of what was begun is far too short.
  const double least_length = limits_.slender * 2 * first.section.section.mean_half_width() / 8;
  for (const int halvings : {2, 6}) {
    if (halvings > 2 && ahead.length + behind.length < least_length) break;
    extend(ahead, began, halvings);
    chain.closed = ahead.is_closed && ahead.turns >= ahead.steps - 1;
    if (chain.closed || !goes_back) continue;
    extend(behind, began, halvings);
  }
  chain.sections = std::move(behind.sections);
  std::ranges::reverse(chain.sections);
  for (ChainSection& section : chain.sections) section.axis = -section.axis;
  chain.sections.push_back(first.section);
  chain.sections.insert(chain.sections.end(), ahead.sections.begin(), ahead.sections.end());
  for (std::size_t i = 1; i < chain.sections.size(); ++i) {
    chain.sections[i].along = chain.sections[i - 1].along +
                              glm::distance(chain.sections[i - 1].section.centre, chain.sections[i].section.centre);
  }
  return chain;
}

}  // namespace foredraw::processors::wire_radius
