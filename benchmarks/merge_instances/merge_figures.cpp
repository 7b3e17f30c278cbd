#include "merge_figures.h"

#include <foredraw/instances/merged_instances.h>

#include <algorithm>
#include <chrono>
#include <numeric>

namespace foredraw::bench {

namespace {

template <class Work>
double milliseconds(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

MergeFigures merge(Scene& scene, const MergeSceneOptions& options, int threads, int rounds) {
  const Executor executor(threads);
  std::vector<DrawId> draws(scene.draws.size());
  std::iota(draws.begin(), draws.end(), DrawId{0});
  MergeFigures figures;
  MergedScene merged;
  std::vector<double> whole, packing;
  for (int round = 0; round < rounds; ++round) {
    merged = {};
    whole.push_back(milliseconds([&] { merged = merge_scene(scene, draws, options, executor); }));
    packing.push_back(milliseconds([&] {
      for (const MergedSet& set : merged.merged) packed_instances(scene, set, options, executor);
    }));
  }
  figures.milliseconds = median(whole);
  figures.packing = median(packing);
  double entries = 0, padded = 0, slots = 0;
  MergedDraws made;
  for (const MergedSet& set : merged.merged) {
    made.sets.push_back(merged_instances(scene, set));
    figures.sets += 1;
    figures.groups += set.layout.groups.size();
    figures.merged += set.packed.placed.size();
    entries += static_cast<double>(set.packed.drawn_entries + set.packed.padded_entries);
    padded += static_cast<double>(set.packed.padded_entries);
    slots += static_cast<double>(set.packed.slots.size());
    std::string own;
    for (const std::uint32_t frequency : set.layout.frequencies.frequencies) {
      own += (own.empty() ? "" : "+") + std::to_string(frequency);
    }
    figures.frequencies += (figures.frequencies.empty() ? "" : " ") + own;
  }
  scene.products.set(std::move(made));
  if (figures.merged > 0) {
    figures.padding = padded / entries;
    figures.slot_bytes = sizeof(MergedSlot) * slots / static_cast<double>(figures.merged);
  }
  return figures;
}

}  // namespace foredraw::bench
