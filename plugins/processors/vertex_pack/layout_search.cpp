#include "layout_search.h"

#include <foredraw/packing/packed_precision.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>
#include <tuple>
#include <vector>

namespace foredraw::processors::vertex_pack {

namespace {

using Bits = std::array<std::uint32_t, FOREDRAW_PACKED_FIELDS>;

constexpr std::int64_t most_coordinate = 1 << 24;
constexpr std::uint32_t most_axis_bits = 24, least_normal_bits = 6, most_normal_bits = 16, most_tangent_bits = 16,
                        least_uv_bits = 6;

/// Whole steps from the first to the last one of an axis.
struct Axis {
  std::int64_t first = 0, last = 0;
  std::uint32_t bits() const {
    return std::max(1u, static_cast<std::uint32_t>(std::bit_width(static_cast<std::uint64_t>(last - first))));
  }
};

/// The lattice with steps of 2^exponent; nothing where its coordinates are too large.
std::optional<std::array<Axis, 3>> lattice(const Box<glm::dvec3>& box, int exponent) {
  std::array<Axis, 3> axes;
  for (int i = 0; i < 3; ++i) {
    const double first = std::nearbyint(std::ldexp(box.min[i], -exponent));
    const double last = std::nearbyint(std::ldexp(box.max[i], -exponent));
    constexpr auto most = static_cast<double>(most_coordinate);
    if (!(std::abs(first) <= most && std::abs(last) <= most)) return std::nullopt;
    axes[static_cast<std::size_t>(i)] = {static_cast<std::int64_t>(first), static_cast<std::int64_t>(last)};
    if (axes[static_cast<std::size_t>(i)].bits() > most_axis_bits) return std::nullopt;
  }
  return axes;
}

/// Puts fields into words, the largest first, each into the first word that takes it.
class Placing {
 public:
  explicit Placing(const Bits& bits) : bits_(bits) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::stable_sort(order_, std::ranges::greater(), [&](std::size_t f) { return bits[f]; });
  }

  bool succeeds() { return place(0); }
  std::uint32_t word(std::size_t field) const { return word_[field]; }
  std::uint32_t left(std::uint32_t word) const { return left_[word]; }

 private:
  bool place(std::size_t at) {
    if (at == order_.size() || bits_[order_[at]] == 0) return true;
    const std::uint32_t wanted = bits_[order_[at]];
    for (std::uint32_t word = 0; word < left_.size(); ++word) {
      const auto* tried = std::find(left_.begin(), left_.begin() + word, left_[word]);
      if (left_[word] < wanted || tried != left_.begin() + word) continue;  // as well as one that was tried
      left_[word] -= wanted;
      word_[order_[at]] = word;
      if (place(at + 1)) return true;
      left_[word] += wanted;
    }
    return false;
  }

  const Bits& bits_;
  std::array<std::size_t, FOREDRAW_PACKED_FIELDS> order_{};
  std::array<std::uint32_t, FOREDRAW_PACKED_FIELDS> word_{};
  std::array<std::uint32_t, 4> left_{32, 32, 32, 32};
};

struct Candidate {
  double error = 0;
  int exponent = 0;
  Bits bits{};
  auto key() const {
    return std::tuple(error, bits[FOREDRAW_PACKED_NORMAL_0], bits[FOREDRAW_PACKED_U], bits, exponent);
  }
};

PackedLayout layout_of(const Candidate& candidate, const Demand& demand) {
  PackedLayout layout{};
  for (std::size_t f = 0; f < candidate.bits.size(); ++f) layout.field[f].bits = candidate.bits[f];
  layout.step = static_cast<float>(std::ldexp(1.0, candidate.exponent));
  layout.is_spherical = demand.is_spherical ? 1 : 0;
  if (candidate.bits[FOREDRAW_PACKED_U] != 0) set_uv_lattice(layout, glm::dvec2(0), demand.uv_extent);
  return layout;
}

double normal_bound(const Demand& demand, std::uint32_t bits) {
  Candidate candidate;
  candidate.bits[FOREDRAW_PACKED_NORMAL_0] = bits;
  return packed_bounds(layout_of(candidate, demand)).normal;
}

/// The fewest bits with which tangents keep their limit; nothing where none suffice.
std::optional<std::uint32_t> tangent_bits(const Demand& demand, std::uint32_t normal_bits) {
  if (!demand.tangents) return 0;
  for (std::uint32_t bits = 3; bits <= most_tangent_bits; ++bits) {
    Candidate candidate;
    candidate.bits[FOREDRAW_PACKED_NORMAL_0] = normal_bits;
    candidate.bits[FOREDRAW_PACKED_TANGENT] = bits;
    if (packed_bounds(layout_of(candidate, demand)).tangent <= demand.most_angle_error) return bits;
  }
  return std::nullopt;
}

std::vector<Candidate> with_positions(const Demand& demand) {
  std::vector<Candidate> candidates;
  for (int exponent = 100; exponent >= -100; --exponent) {
    const auto axes = lattice(demand.box, exponent);
    if (!axes) break;
    Candidate candidate{.exponent = exponent};
    for (std::size_t i = 0; i < 3; ++i) candidate.bits[FOREDRAW_PACKED_X + i] = (*axes)[i].bits();
    candidate.error = packed_bounds(layout_of(candidate, demand)).position;
    candidates.push_back(candidate);
  }
  constexpr std::size_t most_steps = 24;  // coarser ones leave nothing of the box
  if (candidates.size() > most_steps) candidates.erase(candidates.begin(), candidates.end() - most_steps);
  return candidates;
}

std::vector<Candidate> with_normals(const std::vector<Candidate>& positions, const Demand& demand) {
  if (!demand.normals) return positions;
  std::vector<Candidate> candidates;
  for (std::uint32_t bits = least_normal_bits; bits <= most_normal_bits; ++bits) {
    const auto tangent = tangent_bits(demand, bits);
    if (!tangent || normal_bound(demand, bits) > demand.most_angle_error) continue;
    for (Candidate candidate : positions) {
      candidate.bits[FOREDRAW_PACKED_NORMAL_0] = candidate.bits[FOREDRAW_PACKED_NORMAL_1] = bits;
      candidate.bits[FOREDRAW_PACKED_TANGENT] = *tangent;
      candidate.bits[FOREDRAW_PACKED_SIGN] = *tangent > 0 ? 1 : 0;
      candidate.error += demand.displacement * normal_bound(demand, bits) * (std::numbers::pi / 180);
      candidates.push_back(candidate);
    }
  }
  return candidates;
}

std::vector<Candidate> with_uvs(const std::vector<Candidate>& others, const Demand& demand) {
  if (!demand.uvs) return others;
  std::vector<Candidate> candidates;
  for (std::uint32_t u = least_uv_bits; u <= most_uv_bits; ++u) {
    for (std::uint32_t v = least_uv_bits; v <= most_uv_bits; ++v) {
      Candidate alone;
      alone.bits[FOREDRAW_PACKED_U] = u;
      alone.bits[FOREDRAW_PACKED_V] = v;
      const PackedBounds bounds = packed_bounds(layout_of(alone, demand));
      if (bounds.uv() > demand.most_uv_error) continue;
      const double error = demand.slope * std::sqrt(bounds.u * bounds.u + bounds.v * bounds.v);
      for (Candidate candidate : others) {
        candidate.bits[FOREDRAW_PACKED_U] = u;
        candidate.bits[FOREDRAW_PACKED_V] = v;
        candidate.error += error;
        if (std::reduce(candidate.bits.begin(), candidate.bits.end()) <= 128) candidates.push_back(candidate);
      }
    }
  }
  return candidates;
}

/// With the box in the middle of what the bits reach.
void set_origin(PackedLayout& layout, const Box<glm::dvec3>& box, int exponent) {
  const std::array<Axis, 3> axes = lattice(box, exponent).value();
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int64_t reach = foredraw_packed_most(layout.field[FOREDRAW_PACKED_X + i].bits);
    const std::int64_t middle = axes[i].first - (reach - (axes[i].last - axes[i].first)) / 2;
    layout.origin[i] =
        static_cast<std::int32_t>(std::clamp<std::int64_t>(middle, -most_coordinate, most_coordinate - reach));
  }
}

void set_fields(PackedLayout& layout, const Placing& placing, Bits bits) {
  const std::uint32_t left = placing.left(placing.word(FOREDRAW_PACKED_TANGENT));
  std::uint32_t& tangent = bits[FOREDRAW_PACKED_TANGENT];
  if (tangent > 0) tangent = std::min(tangent + left, most_tangent_bits);
  std::array<std::uint32_t, 4> used{};
  for (std::size_t f = 0; f < bits.size(); ++f) {
    if (bits[f] == 0) continue;
    const std::uint32_t word = placing.word(f);
    layout.field[f] = {word, used[word], bits[f]};
    used[word] += bits[f];
  }
}

}  // namespace

std::optional<PackedLayout> best_layout(const Demand& demand) {
  std::vector<Candidate> candidates = with_uvs(with_normals(with_positions(demand), demand), demand);
  std::ranges::sort(candidates, {}, &Candidate::key);
  for (const Candidate& candidate : candidates) {
    if (std::reduce(candidate.bits.begin(), candidate.bits.end()) > 128) continue;
    Placing placing(candidate.bits);
    if (!placing.succeeds()) continue;
    PackedLayout layout = layout_of(candidate, demand);
    set_fields(layout, placing, candidate.bits);
    set_origin(layout, demand.box, candidate.exponent);
    return layout;
  }
  return std::nullopt;
}

bool set_uv_lattice(PackedLayout& layout, const glm::dvec2& least, const glm::dvec2& most) {
  for (int i = 0; i < 2; ++i) {
    const double reach = foredraw_packed_most(layout.field[FOREDRAW_PACKED_U + i].bits);
    const double largest = std::max(std::abs(least[i]), std::abs(most[i]));
    const auto most_origin = static_cast<double>(most_coordinate) - reach - 2;
    const double step = std::max({(most[i] - least[i]) / (reach - 1), largest / most_origin, 1e-12});
    layout.uv_step[i] = static_cast<float>(step);
    // In floats, as vertices are packed: of two whole numbers nearly as near it has to be the same one.
    const float origin = std::nearbyint(static_cast<float>(least[i]) * (1.0f / layout.uv_step[i]));
    if (!(largest < 1e20) || !(std::abs(origin) <= static_cast<float>(most_coordinate))) return false;
    layout.uv_origin[i] = static_cast<std::int32_t>(origin);
  }
  return true;
}

}  // namespace foredraw::processors::vertex_pack
