// module-calls-bench MODULE: what a call of a module that does nothing takes in a process of its own and inside, and
// what of a lookahead's time that is.
#include <foredraw/base/random.h>
#include <foredraw/c/module.h>
#include <foredraw/modules/foreign_runner.h>
#include <foredraw/modules/runs_apart.h>
#include <foredraw/platform/shared_library.h>
#include <plugins/orderers/lookahead/lookahead.h>

#include "../timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <vector>

namespace foredraw {
namespace {

/// Milliseconds: the least of so many times, as two processes take turns and others may run.
template <class Work>
double least_time(int times, Work work) {
  double least = 1e9;
  for (int i = 0; i < times; ++i) {
    const auto begin = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - begin;
    least = std::min(least, taken.count());
  }
  return least;
}

/// A square of about so many triangles in the order of chance, with normals and texture coordinates.
struct Square {
  explicit Square(std::size_t triangles) {
    const auto cells = static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(triangles) / 2)));
    const std::uint32_t vertices = (cells + 1) * (cells + 1);
    positions.resize(3 * vertices);
    normals.resize(3 * vertices);
    coordinates.resize(2 * vertices);
    for (std::uint32_t v = 0; v < vertices; ++v) {
      positions[3 * v] = static_cast<float>(v % (cells + 1)),
                    positions[3 * v + 1] = static_cast<float>(v / (cells + 1));
    }
    for (std::uint32_t y = 0; y < cells; ++y) {
      for (std::uint32_t x = 0; x < cells; ++x) {
        const std::uint32_t a = y * (cells + 1) + x, b = a + cells + 1;
        indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
      }
    }
    Random random(1);
    for (std::size_t t = indices.size() / 3; t > 1; --t) {
      const auto other = static_cast<std::ptrdiff_t>(3 * random.below(t));
      std::swap_ranges(indices.begin() + other, indices.begin() + other + 3,
                       indices.begin() + static_cast<std::ptrdiff_t>(3 * (t - 1)));
    }
    streams[0] = {"NORMAL", normals.data(), 12, FOREDRAW_FLOAT32, 3, 0};
    streams[1] = {"TEXCOORD_0", coordinates.data(), 8, FOREDRAW_FLOAT32, 2, 0};
  }

  foredraw_draw draw() const {
    return {.size = sizeof(foredraw_draw),
            .vertex_count = static_cast<std::uint32_t>(positions.size() / 3),
            .triangle_count = indices.size() / 3,
            .name = "square",
            .indices = indices.data(),
            .positions = positions.data(),
            .stream_count = 2,
            .streams = streams,
            .cluster_count = 0,
            .cluster_offsets = nullptr};
  }

  std::vector<std::uint32_t> indices;
  std::vector<float> positions, normals, coordinates;
  foredraw_stream streams[2];
};

void compare_calls(const char* module) {
  const ModuleLimits limits{.worker = FOREDRAW_WORKER};
  const foredraw_host host{.size = sizeof host, .cancelled = [](void*) { return 0; }};
  const double start = least_time(21, [&] { ModuleWorkers(module, limits).tables(); });
  fmt::print("a process, begun and ended: {:.1f} ms\n\n", start);
  fmt::print("{:>10}{:>14}{:>14}{:>14}{:>16}\n", "triangles", "apart, ms", "inside, ms", "lookahead, ms",
             "of lookahead");
  const auto workers = std::make_shared<ModuleWorkers>(module, limits);
  const LoadedLibrary library(module);
  const foredraw_module& loaded = *library.function<const foredraw_module*()>("foredraw_module_v1")();
  const RunsApart apart(workers, 0, false);
  const RunsInside inside(*loaded.plugins[0]);
  for (const std::size_t triangles : {100, 1'000, 10'000, 100'000, 1'000'000}) {
    const Square square(triangles);
    const foredraw_draw draw = square.draw();
    std::vector<std::uint32_t> order(draw.triangle_count);
    const auto call = [&](const ForeignRunner& runner) {
      foredraw_answer answer{order.data(), order.size(), nullptr, 0};
      runner.run(draw, {}, answer, host);
    };
    const int times = triangles >= 100'000 ? 41 : 1001;
    call(apart);  // pages are touched once
    const double one = least_time(times, [&] { call(apart); });
    const double other = least_time(times, [&] { call(inside); });
    const double work = 1000 * bench::seconds_of([&] { lookahead(square.indices, draw.vertex_count, {}); });
    fmt::print("{:>10}{:>14.3f}{:>14.3f}{:>14.2f}{:>14.1f} %\n", draw.triangle_count, one, other, work,
               100 * (one - other) / work);
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace foredraw

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "module-calls-bench MODULE: module_as_it_is.so, say\n");
    return 1;
  }
  foredraw::compare_calls(argv[1]);
}
