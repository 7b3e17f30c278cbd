// glTF files, read from the disk by us and by tinygltf, one thread each. The peer is what Debian packages, and its
// images are taken as they are, without being decoded, as ours are. Ours checks all that a file claims, and makes the
// scene; the peer keeps what it parsed. Every round does both, so that a noisy moment hits both; medians of seven.
//   reading-bench FILES.glb

#include <foredraw/io/gltf/gltf.h>

#include <tiny_gltf.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <stdexcept>

namespace foredraw::bench {
namespace {

constexpr std::size_t rounds = 7;

struct Milliseconds {
  double processor = 0, clock = 0;
};

/// Freeing what was made counts, too. `work` is done until it took a while, because small files take little.
template <class Work>
Milliseconds timed(Work work) {
  using Clock = std::chrono::steady_clock;
  const std::clock_t processor_begin = std::clock();
  const Clock::time_point begin = Clock::now();
  int times = 0;
  double seconds = 0;
  while (times == 0 || seconds < 0.05) {
    work();
    ++times;
    seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  }
  const double processor = static_cast<double>(std::clock() - processor_begin) / CLOCKS_PER_SEC;
  return {1000 * processor / times, 1000 * seconds / times};
}

void ours(const std::string& path) {
  Diagnostics diagnostics;
  if (!read_gltf(path, diagnostics)) throw std::runtime_error(to_text(diagnostics));
}

bool keep_as_it_is(tinygltf::Image* image, const int, std::string*, std::string*, int, int, const unsigned char* bytes,
                   int size, void*) {
  image->image.assign(bytes, bytes + size);
  return true;
}

void peer(const std::string& path) {
  tinygltf::TinyGLTF reader;
  reader.SetImageLoader(keep_as_it_is, nullptr);
  tinygltf::Model model;
  std::string problem, warning;
  const bool is_read = path.ends_with(".glb") ? reader.LoadBinaryFromFile(&model, &problem, &warning, path)
                                              : reader.LoadASCIIFromFile(&model, &problem, &warning, path);
  if (!is_read) throw std::runtime_error(problem);
}

double median(std::array<double, rounds> values) {
  std::ranges::sort(values);
  return values[rounds / 2];
}

void measure(const std::string& path) {
  std::array<double, rounds> of_ours, of_peer, by_processor, by_clock;
  for (std::size_t r = 0; r < rounds; ++r) {
    const Milliseconds theirs = timed([&] { peer(path); });
    const Milliseconds own = timed([&] { ours(path); });
    of_peer[r] = theirs.processor;
    of_ours[r] = own.processor;
    by_processor[r] = own.processor / theirs.processor;
    by_clock[r] = own.clock / theirs.clock;
  }
  fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | **{:.2f}** | {:.2f} |\n",
             std::filesystem::path(path).filename().string(),
             static_cast<double>(std::filesystem::file_size(path)) / 1e6, median(of_ours), median(of_peer),
             median(by_processor), median(by_clock));
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  fmt::print("| file | MB | ours, ms on the processor | tinygltf, ms | ours / tinygltf | on the clock |\n");
  fmt::print("|---|---:|---:|---:|---:|---:|\n");
  for (int i = 1; i < argc; ++i) foredraw::bench::measure(argv[i]);
  return 0;
}
