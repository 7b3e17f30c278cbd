#include "side_rays.h"

#include <foredraw/analysis/ray_samples.h>

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

namespace foredraw::processors::sides {

namespace {

RayTree tree_of(std::span<const RasterPart> parts) {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  std::vector<Blocks> blocks;
  for (const RasterPart& part : parts) {
    const auto base = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), part.positions.begin(), part.positions.end());
    for (const std::uint32_t index : part.indices) indices.push_back(base + index);
    const Blocks of_part = part.mask                ? Blocks::neither
                           : !part.culls_back_faces ? Blocks::both
                           : part.is_mirrored       ? Blocks::back
                                                    : Blocks::front;
    blocks.resize(indices.size() / 3, of_part);
  }
  return {positions, indices, blocks};
}

/// 1 / 1024 to 1, small ones as likely as large ones: openings have any size.
double any_scale(Random& random) {
  double scale = 1 - random.unit() / 2;
  for (std::uint64_t halvings = random.below(10); halvings > 0; --halvings) scale /= 2;
  return scale;
}

}  // namespace

/// A side, and where it is in the pose.
struct SideRays::Question {
  Seen about;
  std::uint32_t number;  ///< of the triangle, in the tree
  std::array<glm::dvec3, 3> corners;
  glm::dvec3 outwards;  ///< from the side
  double nearest;       ///< what is no farther does not block

  /// Nothing where the triangle covers nothing.
  static std::optional<Question> make(const RasterPart& part, const Seen& about, std::uint32_t number) {
    Question question{about, number, {}, {}, 0};
    for (std::size_t c = 0; c < 3; ++c) {
      question.corners[c] = glm::dvec3(part.positions[part.indices[3 * std::size_t{about.triangle} + c]]);
    }
    const auto& [a, b, c] = question.corners;
    question.outwards = glm::cross(b - a, c - a);
    const double area = glm::dot(question.outwards, question.outwards);
    if (!(area > 0) || !std::isfinite(area)) return std::nullopt;
    if ((about.side == back) != part.is_mirrored) question.outwards = -question.outwards;
    question.nearest = 1e-4 * std::sqrt(std::sqrt(area));
    return question;
  }
};

SideRays::SideRays(std::span<const RasterPart> parts, std::vector<const Surface*> surfaces, const Executor& executor)
    : parts_(parts), surfaces_(std::move(surfaces)), tree_(tree_of(parts)), executor_(executor) {
  for (const RasterPart& part : parts) {
    first_.push_back(first_.back() + static_cast<std::uint32_t>(part.indices.size() / 3));
  }
}

bool SideRays::escapes(const Question& question, const glm::dvec3& from, const glm::dvec3& direction) const {
  const double squared = glm::dot(direction, direction);
  if (!(squared > 0) || !(glm::dot(direction, question.outwards) > 0)) return false;
  return tree_.escapes({from, direction, question.nearest / std::sqrt(squared), question.number});
}

std::vector<Seen> SideRays::through_openings(const SidesOfParts& asked, std::size_t rays, std::uint64_t seed) const {
  std::vector<Question> questions;
  for (std::uint32_t part = 0; part < parts_.size(); ++part) {
    for (std::uint32_t t = 0; t < asked[part].size(); ++t) {
      for (const Side side : {front, back}) {
        if ((asked[part][t] & side) == 0) continue;
        if (const auto question = Question::make(parts_[part], {part, t, side}, first_[part] + t)) {
          questions.push_back(*question);
        }
      }
    }
  }
  std::vector<std::uint8_t> is_seen(questions.size(), 0);
  const auto ask = [&](std::size_t q) {
    Question& question = questions[q];
    const Surface& surface = *surfaces_[question.about.part];
    const std::span<const glm::vec3> positions = parts_[question.about.part].positions;
    const auto rims = surface.rims_of(surface.component[question.about.triangle]);
    Random random(derive_seed(seed, question.number, question.about.side));
    for (std::size_t i = 0; i < rays && is_seen[q] == 0; ++i) {
      const glm::dvec3 from = random_point(question.corners, random);
      glm::dvec3 direction = random_direction(random);
      if (i % 2 == 0 || rims.empty()) {
        if (glm::dot(direction, question.outwards) < 0) direction = -direction;
      } else {
        // Into the opening, from a point of its rim towards another one.
        const auto any_of = [&](std::span<const Surface::Rim> edges) {
          const Surface::Rim& rim_edge = edges[random.below(edges.size())];
          const glm::dvec3 a(positions[rim_edge.low]), b(positions[rim_edge.high]);
          return std::pair(a + random.unit() * (b - a), rim_edge.opening);
        };
        const auto [rim, opening] = any_of(rims);
        const glm::dvec3 across = any_of(surface.opening(opening)).first;
        direction = rim + any_scale(random) * (across - rim) - from;
      }
      if (escapes(question, from, direction)) {
        is_seen[q] = 1;
        question.about.direction = direction;
      }
    }
  };
  constexpr std::size_t at_once = 64;
  executor_.for_each((questions.size() + at_once - 1) / at_once, [&](std::size_t task) {
    for (std::size_t q = task * at_once; q < std::min(questions.size(), (task + 1) * at_once); ++q) ask(q);
  });
  std::vector<Seen> seen;
  for (std::size_t q = 0; q < questions.size(); ++q) {
    if (is_seen[q] != 0) seen.push_back(questions[q].about);
  }
  return seen;
}

std::vector<Seen> SideRays::beside(std::vector<Seen> seen, SidesOfParts& kept, std::uint64_t seed) const {
  constexpr std::size_t most_directions = 8, most_apart = 2;
  std::vector<Seen> added;
  for (std::uint64_t round = 0; !seen.empty(); ++round) {
    std::vector<Seen> near;  // what touches them, with the direction that they are seen from
    for (const Seen& one : seen) {
      if (surfaces_[one.part] == nullptr) continue;
      const Surface& surface = *surfaces_[one.part];
      for (std::size_t c = 0; c < 3; ++c) {
        for (const std::uint32_t t : surface.around(surface.indices[3 * std::size_t{one.triangle} + c])) {
          if ((kept[one.part][t] & one.side) == 0) near.push_back({one.part, t, one.side, one.direction});
        }
      }
    }
    const auto side_of = [](const Seen& s) { return std::tuple(s.part, s.triangle, s.side); };
    std::ranges::stable_sort(near, {}, side_of);
    std::vector<std::size_t> first;  // [question] of `near`
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (i == 0 || side_of(near[i]) != side_of(near[i - 1])) first.push_back(i);
    }
    first.push_back(near.size());
    std::vector<std::uint8_t> is_seen(first.size() - 1, 0);
    const auto ask = [&](std::size_t q) {
      Seen& about = near[first[q]];
      const auto question = Question::make(parts_[about.part], about, first_[about.part] + about.triangle);
      if (!question) return;
      Random random(derive_seed(seed + round, question->number, about.side));
      const std::size_t count = first[q + 1] - first[q];
      const std::size_t step = (count + most_directions - 1) / most_directions;
      for (std::size_t i = first[q]; i < first[q + 1]; i += step) {
        const glm::dvec3 direction = near[i].direction;
        const double length = std::sqrt(glm::dot(direction, direction));
        for (std::size_t k = 0; k < most_apart; ++k) {
          const double apart = k == 0 ? 0 : 0.5 * any_scale(random);
          const glm::dvec3 turned = direction + apart * length * random_direction(random);
          if (!escapes(*question, random_point(question->corners, random), turned)) continue;
          is_seen[q] = 1;
          about.direction = turned;
          return;
        }
      }
    };
    constexpr std::size_t at_once = 32;
    executor_.for_each((is_seen.size() + at_once - 1) / at_once, [&](std::size_t task) {
      for (std::size_t q = task * at_once; q < std::min(is_seen.size(), (task + 1) * at_once); ++q) ask(q);
    });
    seen.clear();
    for (std::size_t q = 0; q < is_seen.size(); ++q) {
      if (is_seen[q] == 0) continue;
      const Seen& found = near[first[q]];
      Side& sides = kept[found.part][found.triangle];
      sides = static_cast<Side>(sides | found.side);
      seen.push_back(found);
    }
    added.insert(added.end(), seen.begin(), seen.end());
  }
  return added;
}

}  // namespace foredraw::processors::sides
