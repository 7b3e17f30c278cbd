#pragma once
// What both benchmarks of simplifiers do alike.

#include <foredraw/collapses/joined_mesh.h>
#include <foredraw/io/scene_file.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {

/// All triangles of the file, in the draws' own spaces.
inline JoinedMesh read_joined(const std::string& path) {
  Diagnostics diagnostics;
  const auto file = read_scene(path, diagnostics);
  if (!file) throw std::runtime_error(to_text(diagnostics));
  std::vector<DrawId> draws;
  for (DrawId id = 0; id < file->scene.draws.size(); ++id) {
    if (file->scene.draws[id].topology == Topology::triangles) draws.push_back(id);
  }
  Analyses analyses;
  return joined_mesh(file->scene, draws, analyses).value();
}

/// Of the processor, for this thread.
inline double seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double seconds_of(Work work) {
  const double begin = seconds();
  work();
  return seconds() - begin;
}

inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

inline double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

}  // namespace foredraw::bench
