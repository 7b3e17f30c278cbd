#include <foredraw/overdraw/draw_sequence.h>

#include <foredraw/base/random.h>
#include <foredraw/overdraw/private/run_moves.h>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

std::vector<std::uint32_t> rising(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

/// The parts with the runs of every group in the sequence that `runs_of(group)` says.
template <class RunsOf>
std::vector<std::uint32_t> arranged(std::uint32_t parts, std::span<const PartGroup> groups, RunsOf runs_of) {
  std::vector<std::uint32_t> sequence = rising(parts);
  for (const PartGroup& group : groups) {  // inner groups first, so that runs are whole
    std::vector<std::uint32_t> members;
    for (const std::uint32_t run : runs_of(group)) {
      const auto first = sequence.begin();
      members.insert(members.end(), first + group.offsets[run], first + group.offsets[run + 1]);
    }
    std::ranges::copy(members, sequence.begin() + group.offsets.front());
  }
  return sequence;
}

std::vector<std::uint32_t> reversed(const PartGroup& group) {
  std::vector<std::uint32_t> runs = rising(group.count());
  std::ranges::reverse(runs);
  return runs;
}

std::vector<std::uint32_t> shuffled(const PartGroup& group, Random& random) {
  std::vector<std::uint32_t> runs = rising(group.count());
  for (std::size_t i = runs.size(); i > 1; --i) std::swap(runs[i - 1], runs[random.below(i)]);
  return runs;
}

/// [a * runs + b]: pixels in which run a is before run b.
std::vector<std::int64_t> pixels_before(const PartLists& lists, const PartGroup& group) {
  const std::size_t runs = group.count();
  std::vector<std::int64_t> before(runs * runs, 0);
  std::vector<std::size_t> nearer;
  for (std::size_t l = 0; l < lists.count(); ++l) {
    nearer.clear();
    for (const std::uint32_t part : lists.list(l)) {
      if (part < group.offsets.front() || part >= group.offsets.back()) continue;
      const auto run =
          static_cast<std::size_t>(std::ranges::upper_bound(group.offsets, part) - group.offsets.begin()) - 1;
      if (std::ranges::find(nearer, run) != nearer.end()) continue;
      for (const std::size_t other : nearer) before[other * runs + run] += lists.weights[l];
      nearer.push_back(run);
    }
  }
  return before;
}

/// Again and again the one of those left that is most before the others, and least behind.
std::vector<std::uint32_t> by_feedback_arcs(const PartLists& lists, const PartGroup& group) {
  const std::size_t runs = group.count();
  const std::vector<std::int64_t> before = pixels_before(lists, group);
  std::vector<std::int64_t> lead(runs, 0);
  for (std::size_t a = 0; a < runs; ++a) {
    for (std::size_t b = 0; b < runs; ++b) lead[a] += before[a * runs + b] - before[b * runs + a];
  }
  std::vector<std::uint32_t> left = rising(runs);
  std::vector<std::uint32_t> sequence;
  while (!left.empty()) {
    const auto first = std::ranges::max_element(left, {}, [&](std::uint32_t run) { return lead[run]; });
    const std::uint32_t taken = *first;
    left.erase(first);
    sequence.push_back(taken);
    for (const std::uint32_t run : left) lead[run] -= before[run * runs + taken] - before[taken * runs + run];
  }
  return sequence;
}

/// How many sequences there are, up to `most`.
std::size_t count_sequences(std::span<const PartGroup> groups, std::size_t most) {
  std::size_t count = 1;
  for (const PartGroup& group : groups) {
    for (std::size_t run = 2; run <= group.count() && count < most; ++run) count *= run;
  }
  return std::min(count, most);
}

/// The sequence as it is, its reverse, that by feedback arcs, and random ones.
std::vector<std::vector<std::uint32_t>> starts_of(const PartLists& lists, std::span<const PartGroup> groups,
                                                  const DrawSequenceOptions& options) {
  std::vector<std::vector<std::uint32_t>> starts = {
      rising(lists.parts), arranged(lists.parts, groups, reversed),
      arranged(lists.parts, groups, [&](const PartGroup& group) { return by_feedback_arcs(lists, group); })};
  const std::size_t random = count_sequences(groups, static_cast<std::size_t>(options.restarts) + 2) - 2;
  for (std::size_t start = 0; start < random; ++start) {
    Random chance(derive_seed(options.seed, start, 0));
    starts.push_back(arranged(lists.parts, groups, [&](const PartGroup& group) { return shuffled(group, chance); }));
  }
  return starts;
}

}  // namespace

std::vector<std::uint32_t> draw_sequence(const PartLists& lists, std::span<const PartGroup> groups,
                                         const DrawSequenceOptions& options, const Executor& executor) {
  if (groups.empty()) return rising(lists.parts);
  const ListsOfParts lists_of(lists);
  std::vector<std::vector<std::uint32_t>> found = starts_of(lists, groups, options);
  std::vector<std::int64_t> shaded(found.size());
  executor.for_each(found.size(), [&](std::size_t start) {
    RunMoves moves(lists, lists_of, std::move(found[start]));
    for (std::int64_t saved = 1; saved > 0;) {
      saved = 0;
      for (const PartGroup& group : groups) {
        for (std::uint32_t run = 0; run < group.count(); ++run) saved += moves.improve(group, run);
      }
    }
    for (const PartGroup& group : groups) moves.settle(group);
    found[start] = moves.sequence();
    shaded[start] = fragments_shaded(lists, found[start]);
  });
  return found[static_cast<std::size_t>(std::ranges::min_element(shaded) - shaded.begin())];
}

}  // namespace foredraw
