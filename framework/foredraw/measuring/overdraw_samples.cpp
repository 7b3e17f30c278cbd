#include <foredraw/measuring/overdraw_samples.h>

#include <foredraw/base/random.h>
#include <foredraw/viewing/view_directions.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

OverdrawSamples turned_sets(std::size_t count, std::uint64_t seed, double distance, int size) {
  const Directions even = fibonacci_directions(count);
  OverdrawSamples samples{{{}, size}, count};
  for (std::size_t set = 0; set < sets_of_views; ++set) {
    for (const glm::dvec3& direction : turned_at_random(even, derive_seed(seed, count, set))) {
      samples.views.views.push_back({direction, distance});
    }
  }
  return samples;
}

int balanced_size(std::size_t triangles) {
  return static_cast<int>(std::clamp(std::sqrt(2 * static_cast<double>(triangles)), 64.0, 1024.0));
}

std::size_t views_for(std::size_t count, double error, double wanted) {
  return static_cast<std::size_t>(std::ceil(static_cast<double>(count) * std::clamp(error / wanted, 1.25, 8.0)));
}

std::vector<ViewTally> summed_by_sample(std::span<const ViewTally> tallies, std::size_t views_in_sample) {
  std::vector<ViewTally> samples(tallies.size() / views_in_sample);
  for (std::size_t i = 0; i < tallies.size(); ++i) samples[i / views_in_sample] += tallies[i];
  return samples;
}

}  // namespace foredraw
