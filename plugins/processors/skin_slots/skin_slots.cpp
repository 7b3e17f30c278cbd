#include "skin_slots.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace foredraw {

namespace {

struct Influence {
  std::uint32_t joint = 0;
  std::uint32_t weight = 0;  ///< as it is stored
  float amount = 0;          ///< what that stands for
};

/// A set's two streams, by their numbers in VertexStreams::base.
struct SkinSet {
  std::size_t joints = 0, weights = 0;
};

std::vector<SkinSet> sets_of(const VertexStreams& vertices) {
  std::vector<SkinSet> sets;
  const auto number = [&](const std::string& semantic) {
    return static_cast<std::size_t>(std::ranges::find(vertices.base, semantic, &VertexStream::semantic) -
                                    vertices.base.begin());
  };
  for (std::size_t n = 0;; ++n) {
    const SkinSet set{number("JOINTS_" + std::to_string(n)), number("WEIGHTS_" + std::to_string(n))};
    if (std::max(set.joints, set.weights) >= vertices.base.size()) return sets;
    sets.push_back(set);
  }
}

/// One by one, all slots of a vertex being a row.
class Slots {
 public:
  Slots(std::size_t count, const SkinSlotsOptions& options) : options_(options), last_(count), row_(count) {}

  /// Brings the row into the slots of the row before. True where an influence with weight moved.
  bool place(std::vector<Influence>& row) {
    open_.clear();  // those with weight, the greatest first; few, so by insertion, which keeps equal ones in sequence
    for (const Influence& one : row) {
      if (one.amount == 0) continue;
      open_.insert(std::ranges::find_if(open_, [&](const Influence& less) { return less.amount < one.amount; }), one);
    }
    is_taken_.assign(row.size(), false);
    const auto take = [&](const Influence& one, auto fits) {
      for (std::size_t s = 0; s < row_.size(); ++s) {
        if (is_taken_[s] || !fits(s)) continue;
        row_[s] = one;
        is_taken_[s] = true;
        return true;
      }
      return false;
    };
    std::erase_if(open_, [&](const Influence& one) {
      return take(one, [&](std::size_t s) { return last_[s].joint == one.joint; });
    });
    for (const Influence& one : open_) take(one, [](std::size_t) { return true; });
    bool moved = false;
    for (std::size_t s = 0; s < row_.size(); ++s) {
      if (!is_taken_[s]) row_[s] = {options_.zero_unused ? 0 : last_[s].joint, 0, 0};
      if (is_taken_[s]) last_[s] = row_[s];
      moved |= is_taken_[s] && (row[s].joint != row_[s].joint || row[s].weight != row_[s].weight);
    }
    row = row_;
    return moved;
  }

 private:
  SkinSlotsOptions options_;
  std::vector<Influence> last_;  ///< of each slot the last one with weight
  std::vector<Influence> row_;
  std::vector<Influence> open_;  ///< that have no slot yet
  std::vector<bool> is_taken_;
};

std::uint32_t load(const VertexStream& stream, std::size_t vertex, std::size_t component) {
  const std::size_t width = bytes_of(stream.format.component);
  std::uint32_t value = 0;
  std::memcpy(&value, stream.bytes.view().data() + vertex * stream.format.bytes + component * width, width);
  return value;
}

void store(std::vector<std::byte>& bytes, const Format& format, std::size_t vertex, std::size_t component,
           std::uint32_t value) {
  const std::size_t width = bytes_of(format.component);
  std::memcpy(bytes.data() + vertex * format.bytes + component * width, &value, width);
}

/// Weights that are no numbers, or below 0, stand nowhere better than where they are.
bool are_amounts(const VertexStream& weights) {
  for (std::size_t v = 0; v < weights.count(); ++v) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!(decode_component(weights, v, i) >= 0)) return false;
    }
  }
  return true;
}

std::string why_not(const VertexStreams& vertices, const std::vector<SkinSet>& sets) {
  if (sets.empty()) return "it has no skin";
  const Format &joints = vertices.base[sets[0].joints].format, &weights = vertices.base[sets[0].weights].format;
  for (const SkinSet& set : sets) {
    const VertexStream &some_joints = vertices.base[set.joints], &some_weights = vertices.base[set.weights];
    if (some_joints.format != joints || some_weights.format != weights || joints.components != 4 ||
        weights.components != 4) {
      return "its sets of joints have different formats";
    }
    if (!are_amounts(some_weights)) return "some of its weights are below 0 or not finite";
  }
  return {};
}

}  // namespace

SlottedSkin keep_slots(const VertexStreams& vertices, const SkinSlotsOptions& options) {
  const std::vector<SkinSet> sets = sets_of(vertices);
  SlottedSkin result{std::make_shared<const VertexStreams>(vertices), 0, why_not(vertices, sets)};
  if (!result.why_not.empty()) return result;
  const Format joints = vertices.base[sets[0].joints].format, weights = vertices.base[sets[0].weights].format;
  std::vector<std::vector<std::byte>> made(2 * sets.size());
  for (std::size_t n = 0; n < sets.size(); ++n) {
    made[2 * n].resize(vertices.base[sets[n].joints].bytes.size());
    made[2 * n + 1].resize(vertices.base[sets[n].weights].bytes.size());
  }
  Slots slots(4 * sets.size(), options);
  std::vector<Influence> row(4 * sets.size());
  for (std::size_t v = 0; v < vertices.count; ++v) {
    for (std::size_t s = 0; s < row.size(); ++s) {
      const VertexStream& of = vertices.base[sets[s / 4].weights];
      row[s] = {load(vertices.base[sets[s / 4].joints], v, s % 4), load(of, v, s % 4), decode_component(of, v, s % 4)};
    }
    result.moved += slots.place(row) ? 1 : 0;
    for (std::size_t s = 0; s < row.size(); ++s) {
      store(made[s / 4 * 2], joints, v, s % 4, row[s].joint);
      store(made[s / 4 * 2 + 1], weights, v, s % 4, row[s].weight);
    }
  }
  auto to = std::make_shared<VertexStreams>(vertices);
  for (std::size_t n = 0; n < sets.size(); ++n) {
    to->base[sets[n].joints].bytes = Shared<std::byte>(std::move(made[2 * n]));
    to->base[sets[n].weights].bytes = Shared<std::byte>(std::move(made[2 * n + 1]));
  }
  result.vertices = std::move(to);
  return result;
}

}  // namespace foredraw
