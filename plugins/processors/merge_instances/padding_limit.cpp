#include "padding_limit.h"

#include <algorithm>
#include <array>

namespace foredraw::processors::merge_instances {

namespace {

constexpr int most_steps = 5000;

/// A size moved to a class where it needs fewer slots and pads more.
struct Step {
  std::size_t size = 0;
  std::uint8_t to = 0;
  std::uint64_t saved = 0;   ///< slots
  std::uint64_t padded = 0;  ///< entries more, at least 1
};

struct Option {
  std::uint8_t at = 0;
  std::uint64_t slots = 0, padded = 0;
};

/// The classes of a size that a line from the least padded to the fewest slots bends at: what lies above it is not
/// worth its room. Falling in slots, rising in padding.
std::vector<Option> bends(const MeshSize& size, std::span<const std::uint32_t> frequencies) {
  std::vector<Option> options;
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const std::uint64_t slots = slots_of(size.indices, frequencies[k]);
    options.push_back(
        {static_cast<std::uint8_t>(k), size.placed * slots, size.placed * (slots * frequencies[k] - size.indices)});
  }
  std::ranges::sort(options, [](const Option& a, const Option& b) {
    return a.padded != b.padded ? a.padded < b.padded : a.slots < b.slots;
  });
  std::vector<Option> line;
  for (const Option& option : options) {
    if (!line.empty() && option.slots >= line.back().slots) continue;
    while (line.size() > 1) {
      const Option& a = line[line.size() - 2];
      const Option& b = line.back();
      const auto gain = [](const Option& from, const Option& to) {
        return static_cast<double>(from.slots - to.slots) / static_cast<double>(to.padded - from.padded);
      };
      if (gain(a, b) > gain(b, option)) break;
      line.pop_back();
    }
    line.push_back(option);
  }
  return line;
}

/// Which steps to take: the most slots saved in the room there is. Depth first, the best for its room first; what a
/// part of the next step would save at most says where to turn back.
class Knapsack {
 public:
  explicit Knapsack(std::span<const Step> steps) : steps_(steps), taken_(steps.size()) {}

  bool fill(std::uint64_t room, std::uint64_t enough) {
    best_ = enough;
    visit(0, room, 0);
    return left_ > 0;
  }
  bool found() const { return !chosen_.empty(); }
  const std::vector<char>& chosen() const { return chosen_; }

 private:
  double most_from(std::size_t i, std::uint64_t room) const {
    double most = 0;
    for (; i < steps_.size(); ++i) {
      if (steps_[i].padded > room) {
        return most +
               static_cast<double>(steps_[i].saved) * static_cast<double>(room) / static_cast<double>(steps_[i].padded);
      }
      most += static_cast<double>(steps_[i].saved);
      room -= steps_[i].padded;
    }
    return most;
  }

  void visit(std::size_t i, std::uint64_t room, std::uint64_t saved) {
    if (saved >= best_) {
      best_ = saved + 1;
      chosen_ = taken_;
    }
    if (i == steps_.size() || left_ == 0) return;
    if (static_cast<double>(saved) + most_from(i, room) < static_cast<double>(best_)) return;
    --left_;
    if (steps_[i].padded <= room) {
      taken_[i] = 1;
      visit(i + 1, room - steps_[i].padded, saved + steps_[i].saved);
      taken_[i] = 0;
    }
    visit(i + 1, room, saved);
  }

  std::span<const Step> steps_;
  std::vector<char> taken_, chosen_;
  std::uint64_t best_ = 0;  ///< worth taking from here on
  int left_ = most_steps;
};

}  // namespace

std::optional<LimitedSlots> limited_slots(std::span<const MeshSize> sizes, std::span<const std::uint32_t> frequencies,
                                          std::uint64_t most_padded, std::uint64_t fewer_than) {
  LimitedSlots result;
  std::uint64_t padded = 0;
  std::vector<Step> steps;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    const std::vector<Option> line = bends(sizes[i], frequencies);
    result.size_class.push_back(line.front().at);
    result.slots += line.front().slots;
    padded += line.front().padded;
    for (std::size_t k = 1; k < line.size(); ++k) {
      steps.push_back({i, line[k].at, line[k - 1].slots - line[k].slots, line[k].padded - line[k - 1].padded});
    }
  }
  if (padded > most_padded) return std::nullopt;
  std::ranges::stable_sort(steps, [](const Step& a, const Step& b) {
    return static_cast<double>(a.saved) * static_cast<double>(b.padded) >
           static_cast<double>(b.saved) * static_cast<double>(a.padded);
  });

  if (frequencies.size() == 2) {  // one step a size: any of them may be taken
    const std::uint64_t enough = result.slots >= fewer_than ? result.slots - fewer_than + 1 : 0;
    Knapsack knapsack(steps);
    result.proven = knapsack.fill(most_padded - padded, enough);
    if (!knapsack.found()) return std::nullopt;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      if (!knapsack.chosen()[i]) continue;
      result.slots -= steps[i].saved;
      result.size_class[steps[i].size] = steps[i].to;
    }
    return result;
  }
  // A size's steps are in their sequence, as each is worth more for its room than the next one; one that does not fit
  // ends them.
  std::vector<char> ended(sizes.size(), 0);
  for (const Step& step : steps) {
    if (ended[step.size] || padded + step.padded > most_padded) {
      ended[step.size] = 1;
      continue;
    }
    padded += step.padded;
    result.slots -= step.saved;
    result.size_class[step.size] = step.to;
  }
  result.proven = frequencies.size() == 1;
  if (result.slots >= fewer_than) return std::nullopt;
  return result;
}

}  // namespace foredraw::processors::merge_instances
