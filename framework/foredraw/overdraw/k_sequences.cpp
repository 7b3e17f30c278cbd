#include <foredraw/overdraw/k_sequences.h>

#include <foredraw/overdraw/judging_looks.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace foredraw {

namespace {

using Sequence = std::vector<std::uint32_t>;  // [rank] = part

class SequenceAlternation {
 public:
  SequenceAlternation(const SubjectLayers& seen, std::uint32_t parts, std::span<const PartGroup> groups,
                      const KSequencesOptions& options, const Executor& executor)
      : seen_(seen),
        groups_(groups),
        options_(options),
        executor_(executor),
        k_(static_cast<std::size_t>(options.k)),
        weights_(pixel_weights(seen)),
        as_they_came_(parts),
        lists_(looks()) {
    std::iota(as_they_came_.begin(), as_they_came_.end(), 0u);
    std::vector<std::uint32_t> part_of;
    for (const LayerOwner& owner : seen.owners) part_of.push_back(owner.part);
    executor.for_each(looks(),
                      [&](std::size_t look) { lists_[look] = part_lists(seen.layers.views[look], part_of, parts); });
  }

  KSequences run() {
    KSequences result;
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    for (int start = 0; start < options_.starts; ++start) {
      std::vector<std::uint8_t> serving =
          parted_by_direction(seen_, k_, options_.seed + static_cast<std::uint64_t>(start));
      std::vector<Sequence> sequences;
      const std::int64_t cost = alternate(serving, sequences);
      if (cost >= least && start > 0) continue;
      least = cost;
      result.sequences = std::move(sequences);
      result.serving = std::move(serving);
    }
    judge(result);
    return result;
  }

 private:
  std::size_t looks() const { return seen_.layers.views.size(); }

  /// Until what looks that decide shade falls no further; returns it. The sequences are those that serve the looks.
  std::int64_t alternate(std::vector<std::uint8_t>& serving, std::vector<Sequence>& sequences) const {
    std::int64_t least = std::numeric_limits<std::int64_t>::max();
    std::vector<std::uint8_t> served = serving;
    for (int round = 0; round < options_.rounds; ++round) {
      std::vector<Sequence> made = made_for(served);
      std::vector<std::int64_t> costs;  // [look]
      served = served_by(made, costs);
      std::int64_t cost = 0;
      for (std::size_t look = 0; look < looks(); ++look) cost += judges(look) ? 0 : costs[look];
      if (cost >= least) break;
      least = cost;
      serving = served;
      sequences = std::move(made);
      give_work_to_idle(served, costs);
    }
    return least;
  }

  std::vector<Sequence> made_for(std::span<const std::uint8_t> serving) const {
    std::vector<Sequence> made(k_, as_they_came_);
    executor_.for_each(k_, [&](std::size_t j) {
      std::vector<std::int64_t> weights = weights_;
      for (std::size_t look = 0; look < looks(); ++look) {
        if (judges(look) || serving[look] != j) weights[look] = 0;
      }
      made[j] = draw_sequence(joined(lists_, weights), groups_, {.restarts = 0}, executor_);
    });
    return made;
  }

  /// [look] the sequence that shades least there, and what it shades.
  std::vector<std::uint8_t> served_by(std::span<const Sequence> sequences, std::vector<std::int64_t>& costs) const {
    std::vector<std::uint8_t> serving(looks());
    costs.assign(looks(), 0);
    executor_.for_each(looks(), [&](std::size_t look) {
      for (std::size_t j = 0; j < sequences.size(); ++j) {
        const std::int64_t cost = weights_[look] * fragments_shaded(lists_[look], sequences[j]);
        if (j > 0 && cost >= costs[look]) continue;
        costs[look] = cost;
        serving[look] = static_cast<std::uint8_t>(j);
      }
    });
    return serving;
  }

  /// A sequence that serves nothing gets the look that is served worst.
  void give_work_to_idle(std::vector<std::uint8_t>& serving, std::vector<std::int64_t>& costs) const {
    std::vector<std::size_t> served(k_, 0);
    for (std::size_t look = 0; look < looks(); ++look) served[serving[look]] += judges(look) ? 0 : 1;
    for (std::size_t j = 0; j < k_; ++j) {
      if (served[j] > 0) continue;
      std::optional<std::size_t> worst;
      for (std::size_t look = 0; look < looks(); ++look) {
        if (judges(look) || served[serving[look]] < 2) continue;
        if (!worst || costs[look] > costs[*worst]) worst = look;
      }
      if (!worst) return;
      --served[serving[*worst]];
      ++served[j];
      serving[*worst] = static_cast<std::uint8_t>(j);
      costs[*worst] = 0;
    }
  }

  /// Among the looks of its pose that decide, the one from the nearest side; none where all of them judge.
  std::optional<std::size_t> nearest_deciding(std::size_t look) const {
    std::optional<std::size_t> nearest;
    const auto cosine = [&](std::size_t other) { return glm::dot(seen_.directions[other], seen_.directions[look]); };
    for (std::size_t other = 0; other < looks(); ++other) {
      if (judges(other) || seen_.poses[other] != seen_.poses[look]) continue;
      if (!nearest || cosine(other) > cosine(*nearest)) nearest = other;
    }
    return nearest;
  }

  /// One fragment for each visible pixel, and those that parts draw where a nearer part comes later.
  void judge(KSequences& result) const {
    const auto tally = [&](std::size_t look, const Sequence& sequence) {
      const PartLists& lists = lists_[look];
      const std::int64_t stay = std::accumulate(lists.weights.begin(), lists.weights.end(), std::int64_t{0});
      ViewTally one;
      one.visible = static_cast<double>(weights_[look]) * static_cast<double>(seen_.layers.views[look].always.visible);
      one.shaded = one.visible +
                   static_cast<double>(weights_[look]) * static_cast<double>(fragments_shaded(lists, sequence) - stay);
      return one;
    };
    for (std::size_t look = 0; look < looks(); ++look) {
      if (!judges(look)) continue;
      const auto nearest = nearest_deciding(look);
      result.before += tally(look, as_they_came_);
      result.after += tally(look, nearest ? result.sequences[result.serving[*nearest]] : as_they_came_);
    }
  }

  const SubjectLayers& seen_;
  std::span<const PartGroup> groups_;
  const KSequencesOptions& options_;
  const Executor& executor_;
  std::size_t k_;
  std::vector<std::int64_t> weights_;  // [look] of a pixel
  Sequence as_they_came_;
  std::vector<PartLists> lists_;  // [look]
};

}  // namespace

KSequences k_sequences(const SubjectLayers& seen, std::uint32_t parts, std::span<const PartGroup> groups,
                       const KSequencesOptions& options, const Executor& executor) {
  return SequenceAlternation(seen, parts, groups, options, executor).run();
}

}  // namespace foredraw
