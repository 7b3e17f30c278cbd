#include <foredraw/overdraw/private/run_moves.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace foredraw {

ListsOfParts::ListsOfParts(const PartLists& all) : first(all.parts + 2, 0), lists(all.layers.size()) {
  for (const std::uint32_t part : all.layers) ++first[part + 2];
  std::partial_sum(first.begin(), first.end(), first.begin());
  for (std::uint32_t l = 0; l < all.count(); ++l) {
    for (const std::uint32_t part : all.list(l)) lists[first[part + 1]++] = l;
  }
  first.pop_back();
}

RunMoves::RunMoves(const PartLists& lists, const ListsOfParts& lists_of, std::vector<std::uint32_t> sequence)
    : lists_(lists),
      lists_of_(lists_of),
      sequence_(std::move(sequence)),
      ranks_(inverse_of(sequence_, lists.parts)),
      change_(lists.parts, 0),
      last_asked_(lists.count(), 0) {}

std::vector<std::uint32_t> RunMoves::runs_of(const PartGroup& group) const {
  std::vector<std::uint32_t> runs(group.count());
  std::iota(runs.begin(), runs.end(), 0u);
  std::ranges::sort(runs, {}, [&](std::uint32_t run) { return ranks_[group.offsets[run]]; });  // no run is torn
  return runs;
}

void RunMoves::put(const PartGroup& group, std::span<const std::uint32_t> runs) {
  const auto ranks = ranks_.begin();
  std::uint32_t rank = *std::min_element(ranks + group.offsets.front(), ranks + group.offsets.back());
  for (const std::uint32_t run : runs) {
    const std::uint32_t first = group.offsets[run], end = group.offsets[run + 1];
    const std::uint32_t was = *std::min_element(ranks + first, ranks + end);
    for (std::uint32_t part = first; part < end; ++part) ranks_[part] += rank - was;
    rank += end - first;
  }
  for (std::uint32_t part = group.offsets.front(); part < group.offsets.back(); ++part) sequence_[ranks_[part]] = part;
}

void RunMoves::add_change(std::uint32_t part, std::int64_t change) {
  change_[part] += change;
  changed_.push_back(part);
}

/// A part of the run passes until the run moves behind the first of the others that are nearer. What lies behind the
/// run, and passes all others, passes once the run has moved behind it.
void RunMoves::find_changes_in(std::uint32_t list, std::uint32_t first_part, std::uint32_t end_part) {
  const std::int64_t weight = lists_.weights[list];
  const std::uint32_t none = lists_.parts;
  std::uint32_t earliest = none, earliest_of_run = none;  // ranks, of the nearer ones
  for (const std::uint32_t part : lists_.list(list)) {
    const std::uint32_t rank = ranks_[part];
    if (part >= first_part && part < end_part) {
      if (rank < earliest_of_run && earliest != none) add_change(sequence_[earliest], -weight);
      earliest_of_run = std::min(earliest_of_run, rank);
    } else if (rank < earliest) {
      if (earliest_of_run != none) add_change(part, weight);
      earliest = rank;
    }
  }
}

void RunMoves::find_changes(std::uint32_t first_part, std::uint32_t end_part) {
  for (const std::uint32_t part : changed_) change_[part] = 0;
  changed_.clear();
  ++question_;
  for (std::uint32_t part = first_part; part < end_part; ++part) {
    for (const std::uint32_t list : lists_of_.of(part)) {
      if (std::exchange(last_asked_[list], question_) != question_) find_changes_in(list, first_part, end_part);
    }
  }
}

std::int64_t RunMoves::change_at(const PartGroup& group, std::uint32_t run) const {
  const auto change = change_.begin();
  return std::accumulate(change + group.offsets[run], change + group.offsets[run + 1], std::int64_t{0});
}

std::int64_t RunMoves::improve(const PartGroup& group, std::uint32_t run) {
  find_changes(group.offsets[run], group.offsets[run + 1]);
  std::vector<std::uint32_t> runs = runs_of(group);
  std::int64_t cost = 0, least = 0, now = 0;  // beside drawing it before all others
  std::size_t best = 0;                       // of the others before it
  std::size_t others = 0;
  for (const std::uint32_t other : runs) {
    if (other == run) {
      now = cost;
      continue;
    }
    cost += change_at(group, other);
    ++others;
    if (cost < least) {
      least = cost;
      best = others;
    }
  }
  if (least == now) return 0;
  std::erase(runs, run);
  runs.insert(runs.begin() + static_cast<std::ptrdiff_t>(best), run);
  put(group, runs);
  return now - least;
}

void RunMoves::settle(const PartGroup& group) {
  std::vector<std::uint32_t> runs = runs_of(group);
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const std::uint32_t run = runs[i];
    find_changes(group.offsets[run], group.offsets[run + 1]);
    std::size_t place = i;
    for (; place > 0 && runs[place - 1] > run && change_at(group, runs[place - 1]) == 0; --place) {
      runs[place] = runs[place - 1];
    }
    runs[place] = run;
    if (place != i) put(group, runs);
  }
}

}  // namespace foredraw
