// Our vertex codec against a newer meshoptimizer's: bytes, and the speed of both directions on the same streams. Every
// round does all of it one behind the other, so that a noisy moment hits all alike; the median of seven rounds' ratios
// counts.
//   vertex-codec-bench [MODEL...]    tables; models of the corpus where none is named
//   vertex-codec-bench --exact       whether each decodes the other's streams, at every stride, at many counts and
//   levels

#include "codec_streams.h"

#include <foredraw/io/meshopt/vertex_codec.h>

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <functional>
#include <random>
#include <stdexcept>

namespace foredraw::bench {
namespace {

using Bytes = std::vector<std::byte>;
using meshopt::VertexVersion;

constexpr std::size_t rounds = 7;
constexpr double least_seconds = 0.02;  // of what is timed at once

using Figures = std::array<double, rounds>;

double median(Figures figures) {
  std::ranges::sort(figures);
  return figures[rounds / 2];
}

/// Of the processor.
double seconds(const std::function<void()>& work, std::size_t times) {
  const std::clock_t begin = std::clock();
  for (std::size_t i = 0; i < times; ++i) work();
  return static_cast<double>(std::clock() - begin + 1) / CLOCKS_PER_SEC;
}

int number_of(VertexVersion version) { return version == VertexVersion::v0 ? 0 : 1; }

Bytes peers(const Bytes& elements, std::size_t stride, VertexVersion version, int level) {
  Bytes stream(meshopt_encodeVertexBufferBound(elements.size() / stride, stride));
  stream.resize(meshopt_encodeVertexBufferLevel(reinterpret_cast<unsigned char*>(stream.data()), stream.size(),
                                                elements.data(), elements.size() / stride, stride, level,
                                                number_of(version)));
  return stream;
}

bool peer_decodes(const Bytes& stream, std::size_t stride, Bytes& elements) {
  return meshopt_decodeVertexBuffer(elements.data(), elements.size() / stride, stride,
                                    reinterpret_cast<const unsigned char*>(stream.data()), stream.size()) == 0;
}

void require(bool holds, const std::string& otherwise) {
  if (!holds) throw std::runtime_error(otherwise);
}

/// Both decode our stream, and the peer's of each level; ours is never longer.
void compare(const Bytes& elements, std::size_t stride, VertexVersion version) {
  const std::string what =
      fmt::format("{} elements of {} bytes, version {}", elements.size() / stride, stride, number_of(version));
  std::vector<Bytes> streams{meshopt::encode_vertices(elements, stride, version)};
  for (int level = version == VertexVersion::v0 ? 3 : 0; level <= 3; ++level) {  // version 0 has but one
    streams.push_back(peers(elements, stride, version, level));
  }
  Bytes again(elements.size());
  for (const Bytes& stream : streams) {
    require(streams[0].size() <= stream.size(), what + ": ours is longer");
    require(meshopt::decode_vertices(stream, stride, again) && again == elements, what + ": we decode it wrongly");
    std::ranges::fill(again, std::byte{0});
    require(peer_decodes(stream, stride, again) && again == elements, what + ": the peer decodes it otherwise");
  }
}

void contest(const StreamSet& set, VertexVersion version) {
  std::size_t plain = set.bytes(), ours = 0, theirs = 0;
  std::vector<Bytes> coded;
  std::vector<Bytes> room;
  for (const Bytes& elements : set.streams) {
    compare(elements, set.stride, version);
    coded.push_back(peers(elements, set.stride, version, 3));
    theirs += coded.back().size();
    ours += meshopt::encode_vertices(elements, set.stride, version).size();
    room.emplace_back(elements.size());
  }
  const auto each = [&](auto work) {
    return [&set, work] {
      for (std::size_t i = 0; i < set.streams.size(); ++i) work(i);
    };
  };
  const std::function<void()> works[] = {
      each([&](std::size_t i) { meshopt::decode_vertices(coded[i], set.stride, room[i]); }),
      each([&](std::size_t i) { peer_decodes(coded[i], set.stride, room[i]); }),
      each([&](std::size_t i) { meshopt::encode_vertices(set.streams[i], set.stride, version); }),
      each([&](std::size_t i) { peers(set.streams[i], set.stride, version, 2); }),
      each([&](std::size_t i) { peers(set.streams[i], set.stride, version, 3); })};
  std::array<std::size_t, std::size(works)> times;
  for (std::size_t w = 0; w < times.size(); ++w) {
    const double once = seconds(works[w], 1);
    times[w] = static_cast<std::size_t>(std::clamp(least_seconds / once, 1.0, 1e5));
  }
  times[0] = times[1] = std::max(times[0], times[1]);
  Figures speed, decode, encode_2, encode_3;
  for (std::size_t i = 0; i < rounds; ++i) {
    std::array<double, std::size(works)> took;
    for (std::size_t w = 0; w < took.size(); ++w) {
      took[w] = seconds(works[w], times[w]) / static_cast<double>(times[w]);
    }
    speed[i] = static_cast<double>(plain) / took[0] / 1e9;
    decode[i] = took[1] / took[0];
    encode_2[i] = took[3] / took[2];
    encode_3[i] = took[4] / took[2];
  }
  fmt::print("| {} | {} | {} | {:.4f} | {:.2f} | {:.2f} | **{:.2f}** | {:.2f} | {:.2f} |\n", set.name, plain,
             number_of(version), static_cast<double>(ours) / static_cast<double>(theirs),
             static_cast<double>(plain) / static_cast<double>(ours), median(speed), median(decode), median(encode_2),
             median(encode_3));
  std::fflush(stdout);
}

/// Bytes that mostly change by little.
Bytes walk(std::size_t bytes, std::size_t stride, std::mt19937& random) {
  Bytes elements(bytes);
  for (std::size_t i = 0; i < bytes; ++i) {
    const unsigned before = i < stride ? 0 : std::to_integer<unsigned>(elements[i - stride]);
    const unsigned step = (i % stride) % 3 == 0 ? random() % 4 : random() % 40 == 0 ? random() : random() % 24;
    elements[i] = static_cast<std::byte>(i % stride % 7 == 0 ? before : before + step);
  }
  return elements;
}

void compare_all() {
  std::mt19937 random(1);
  std::size_t done = 0;
  for (std::size_t stride = 4; stride <= 256; stride += 4) {
    for (const VertexVersion version : {VertexVersion::v0, VertexVersion::v1}) {
      for (std::size_t count = 1; count * stride <= 280'000; count += 1 + count / 2 + random() % (1 + count / 4)) {
        compare(walk(count * stride, stride, random), stride, version);
        ++done;
      }
    }
  }
  fmt::print("{} lists of elements: each decoder gives those of both encoders, and our streams are never longer\n",
             done);
}

std::vector<std::string> corpus_files() {
  std::vector<std::string> files;
  for (const char* folder : {"static", "animated", "scenes"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(FOREDRAW_SOURCE_DIR) /
                                                                 "benchmarks/corpus" / folder)) {
      if (entry.path().extension() == ".glb") files.push_back(entry.path());
    }
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::vector<std::string> files(argv + 1, argv + argc);
  if (files == std::vector<std::string>{"--exact"}) {
    compare_all();
    return 0;
  }
  fmt::print(
      "| streams | plain bytes | version | bytes, ours / peer | plain / ours | our decoder, GB/s | decoding, ours / "
      "peer | "
      "encoding, ours / level 2 | ours / level 3 |\n|---|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  std::vector<StreamSet> sets = streams_of(files.empty() ? corpus_files() : files);
  if (files.empty()) std::ranges::move(growing_streams(), std::back_inserter(sets));
  for (const StreamSet& set : sets) {
    for (const auto version : {foredraw::meshopt::VertexVersion::v0, foredraw::meshopt::VertexVersion::v1}) {
      contest(set, version);
    }
  }
}
