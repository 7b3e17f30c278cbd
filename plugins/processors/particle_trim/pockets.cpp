#include "pockets.h"

#include "plane.h"

namespace foredraw::processors::particle_trim {

namespace {

glm::dvec2 real(const Point& point) { return {static_cast<double>(point.x), static_cast<double>(point.y)}; }

double as_double(std::int64_t number) { return static_cast<double>(number); }

}  // namespace

Pockets::Pockets(std::span<const Point> hull, Allowed allowed)
    : hull_(hull), allowed_(std::move(allowed)), sums_(2 * hull.size() + 1, 0) {
  for (std::size_t i = 0; i < 2 * hull.size(); ++i)
    sums_[i + 1] = sums_[i] + processors::particle_trim::cross(at(i) - at(0), at(i + 1) - at(0));
}

/// Twice the area between the chord from edge i's end to the later edge's begin and the hull.
std::int64_t Pockets::chain(std::size_t i, std::size_t steps) const {
  const std::size_t first = i % hull_.size() + 1, last = first + steps - 1;
  return sums_[last] - sums_[first] + processors::particle_trim::cross(at(last) - at(0), at(first) - at(0));
}

double Pockets::area(std::size_t i, std::size_t steps) const {
  const Point u = direction(i), w = direction(i + steps);
  const std::int64_t turn = processors::particle_trim::cross(u, w);
  if (turn <= 0) return infinity;
  if (steps == 1) return 0;
  const Point chord = at(i + steps) - at(i + 1);
  const double enclosed = as_double(processors::particle_trim::cross(u, chord)) *
                          as_double(processors::particle_trim::cross(chord, w)) / as_double(turn);
  const double area = 0.5 * (enclosed - as_double(chain(i, steps)));
  return area > 0 ? area : 0;
}

bool Pockets::is_allowed(std::size_t i, std::size_t steps) const {
  return steps == 1 || !allowed_ || allowed_(real(at(i + 1)), corner(i, steps), real(at(i + steps)));
}

double Pockets::between(std::size_t from, std::size_t to) const {
  const double between = area(from, steps(from, to));
  return between < infinity && is_allowed(from, steps(from, to)) ? between : infinity;
}

glm::dvec2 Pockets::corner(std::size_t i, std::size_t steps) const {
  if (steps == 1) return real(at(i + 1));
  const Point u = direction(i), w = direction(i + steps);
  const Point chord = at(i + steps) - at(i + 1);
  return real(at(i + 1)) + real(u) * (as_double(processors::particle_trim::cross(chord, w)) /
                                      as_double(processors::particle_trim::cross(u, w)));
}

/// Whether the area grows when a line that lies on `edge` is turned on about the pivot: where it is longer behind the
/// pivot than before it.
bool Pockets::is_growing(std::size_t edge, const Point& pivot, std::size_t i, std::size_t j) const {
  const Point line = direction(edge), u = direction(i), w = direction(j);
  // In lengths of `line` from the pivot to the lines of i and j.
  const double behind = as_double(processors::particle_trim::cross(pivot - at(i + 1), u)) /
                        as_double(processors::particle_trim::cross(line, u));
  const double before = as_double(processors::particle_trim::cross(at(j) - pivot, w)) /
                        as_double(processors::particle_trim::cross(line, w));
  return behind >= before;
}

std::optional<Pockets::Free> Pockets::free(std::size_t i, std::size_t steps) const {
  const std::size_t j = i + steps;
  const Point u = direction(i), w = direction(j);
  const std::int64_t turn = processors::particle_trim::cross(u, w);
  if (turn >= 0) return std::nullopt;
  // Edges between, in whose direction a line meets both others beside the hull: those before `end` meet the first one,
  // for they turn from it by less than half a circle, and from `first` on the second.
  const auto meets_first = [&](std::size_t edge) { return processors::particle_trim::cross(u, direction(edge)) > 0; };
  const auto meets_second = [&](std::size_t edge) { return processors::particle_trim::cross(direction(edge), w) > 0; };
  const auto first_where = [](std::size_t from, std::size_t to, auto&& holds) {
    while (from < to) {
      const std::size_t middle = (from + to) / 2;
      if (holds(middle))
        to = middle;
      else
        from = middle + 1;
    }
    return from;
  };
  const std::size_t end = first_where(i + 1, j, [&](std::size_t edge) { return !meets_first(edge); });
  const std::size_t first = first_where(i + 1, end, meets_second);
  const std::size_t pivot_at =
      first_where(first, end, [&](std::size_t edge) { return is_growing(edge, at(edge), i, j); });
  if (pivot_at > first && is_growing(pivot_at - 1, at(pivot_at), i, j))
    return std::nullopt;  // least on that edge itself
  const Point pivot = at(pivot_at);

  // The edge's ends lie on the lines and equally far from the pivot.
  const Point p = at(i + 1), q = at(j);
  const Point both = pivot + pivot - p - q;
  const double along = as_double(processors::particle_trim::cross(both, w)) / as_double(turn);
  const double back = as_double(processors::particle_trim::cross(both, u)) / as_double(turn);
  if (!(along >= 0) || !(back >= 0)) return std::nullopt;
  const glm::dvec2 a = real(u) * along;  // from p
  const glm::dvec2 b = real(q - p) - real(w) * back;
  const double area = 0.5 * (cross(a, b) + cross(b, real(q - p)) - as_double(chain(i, steps)));
  return Free{area, real(p) + a, real(pivot), real(p) + b};
}

bool Pockets::is_allowed(std::size_t i, std::size_t steps, const Free& free) const {
  return !allowed_ ||
         (allowed_(real(at(i + 1)), free.from, free.touching) && allowed_(free.touching, free.to, real(at(i + steps))));
}

}  // namespace foredraw::processors::particle_trim
