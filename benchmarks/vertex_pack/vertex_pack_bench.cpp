// Vertices of 128 bits: how far they are off, beside what gltfpack makes by default, and how long packing and unpacking
// take, beside copying as many bytes as unpacking writes. One thread; medians of seven rounds, in turn.
//   vertex-pack-bench [MODEL...]    models of the corpus where none is named

#include "plain_peer.h"

#include <benchmarks/timing.h>

#include <foredraw/base/random.h>

#include <foredraw/io/scene_file.h>
#include <foredraw/viewing/pose_set.h>
#include <plugins/processors/vertex_pack/layout_search.h>
#include <plugins/processors/vertex_pack/pack_scene.h>
#include <plugins/processors/vertex_pack/vertex_pack.h>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <array>
#include <cstdio>
#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace foredraw::bench {
namespace {

std::string figures(double ours, double theirs) {
  return theirs == 0 ? " | | " : fmt::format("{:.2g} | {:.2g} | {:.1f}", ours, theirs, theirs / ours);
}

void compare_precision(const std::string& file) {
  Diagnostics diagnostics;
  const auto read = read_scene(file, diagnostics);
  if (!read) throw std::runtime_error(to_text(diagnostics));
  const Scene& scene = read->scene;
  std::vector<DrawId> draws(scene.draws.size());
  std::iota(draws.begin(), draws.end(), DrawId{0});
  const Executor executor(1);
  Analyses analyses;
  const processors::vertex_pack::PackedScene packed = processors::vertex_pack::pack_scene(
      scene, draws, SubjectUnit::character, make_poses(scene, {.poses = "all"}), {}, analyses, executor);
  PackedBounds ours;
  PeerErrors theirs;
  std::size_t vertices = 0;
  for (const processors::vertex_pack::PackedDraw& draw : packed.draws) {
    const VertexStreams& streams = *scene.draws[draw.packed.draw].full().vertices;
    const PackedErrors is = packed_errors(streams, draw.packed.layout, draw.packed.rows[0].view());
    const PeerErrors peer = peer_errors(streams);
    vertices += streams.count;
    ours.position = std::max(ours.position, is.most.position / draw.diagonal);
    theirs.position = std::max(theirs.position, peer.position / draw.diagonal);
    ours.normal = std::max(ours.normal, is.most.normal);
    theirs.normal = std::max(theirs.normal, peer.normal);
    ours.tangent = std::max(ours.tangent, is.most.tangent);
    theirs.tangent = std::max(theirs.tangent, peer.tangent);
    ours.u = std::max(ours.u, is.most.uv() * 4096);
    theirs.uv = std::max(theirs.uv, peer.uv * 4096);
  }
  fmt::print("| {} | {} | {} | {} | {} | {} |\n", file.substr(file.rfind('/') + 1), vertices,
             figures(ours.position, theirs.position), figures(ours.normal, theirs.normal),
             figures(ours.tangent, theirs.tangent), figures(ours.u, theirs.uv));
  std::fflush(stdout);
}

struct Vertices {
  std::vector<glm::vec3> positions, normals;
  std::vector<glm::vec4> tangents;
  std::vector<glm::vec2> uvs;
};

Vertices random_vertices(std::size_t count) {
  Random random(1);
  const auto unit = [&] { return static_cast<float>(random.unit()); };
  const auto direction = [&] {
    for (;;) {
      const glm::vec3 v(2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1);
      if (glm::dot(v, v) > 0.01f && glm::dot(v, v) < 1) return glm::normalize(v);
    }
  };
  Vertices vertices;
  for (std::size_t v = 0; v < count; ++v) {
    vertices.positions.emplace_back(unit(), unit(), unit());
    vertices.normals.push_back(direction());
    const glm::vec3 tangent = glm::normalize(glm::cross(vertices.normals.back(), direction()));
    vertices.tangents.emplace_back(tangent, v % 2 == 0 ? 1.0f : -1.0f);
    vertices.uvs.emplace_back(unit(), unit());
  }
  return vertices;
}

void measure_speed(std::size_t count) {
  const Vertices plain = random_vertices(count);
  Vertices again = plain, copied = plain;
  processors::vertex_pack::Demand demand{.displacement = 0.002, .slope = 0.2, .most_angle_error = 0.065};
  demand.box.add({0, 0, 0});
  demand.box.add({1, 1, 1});
  demand.normals = demand.tangents = demand.uvs = true;
  demand.uv_extent = {1, 1};
  const PackedLayout layout = processors::vertex_pack::best_layout(demand).value();
  std::vector<std::uint32_t> rows(4 * count);
  const auto copy = [](auto& to, const auto& from) {
    std::memcpy(to.data(), from.data(), from.size() * sizeof from[0]);
  };
  const auto each = [&](const auto& work) {
    for (std::size_t v = 0; v < count; ++v) work(v);
  };
  const std::array<std::function<void()>, 5> works = {
      [&] {
        pack_vertices(layout, {plain.positions, plain.normals, plain.tangents, plain.uvs}, rows);
      },
      [&] {
        unpack_vertices(layout, rows, {again.positions, again.normals, again.tangents, again.uvs});
      },
      [&] {
        copy(copied.positions, plain.positions), copy(copied.normals, plain.normals);
        copy(copied.tangents, plain.tangents), copy(copied.uvs, plain.uvs);
      },
      [&] {
        each([&](std::size_t v) {
          foredraw_packed_vertex vertex;
          std::memcpy(vertex.position, &plain.positions[v], 12), std::memcpy(vertex.normal, &plain.normals[v], 12);
          std::memcpy(vertex.tangent, &plain.tangents[v], 16), std::memcpy(vertex.uv, &plain.uvs[v], 8);
          foredraw_packed_encode(&layout, &vertex, &rows[4 * v]);
        });
      },
      [&] {
        each([&](std::size_t v) {
          foredraw_packed_vertex vertex;
          foredraw_packed_decode(&layout, &rows[4 * v], &vertex);
          std::memcpy(&again.positions[v], vertex.position, 12), std::memcpy(&again.normals[v], vertex.normal, 12);
          std::memcpy(&again.tangents[v], vertex.tangent, 16), std::memcpy(&again.uvs[v], vertex.uv, 8);
        });
      }};
  std::array<std::vector<double>, works.size()> rates;
  const std::size_t times = std::max<std::size_t>(1, 2'000'000 / count);
  for (int round = 0; round < 7; ++round) {
    for (std::size_t w = 0; w < works.size(); ++w) {
      const double took = seconds_of([&] {
        for (std::size_t i = 0; i < times; ++i) works[w]();
      });
      rates[w].push_back(static_cast<double>(count * times) / took / 1e6);
    }
  }
  std::vector<double> parts;
  for (std::size_t i = 0; i < 7; ++i) parts.push_back(rates[1][i] / rates[2][i]);
  fmt::print("| {} | {:.0f} | {:.0f} | {:.0f} | {:.2f} | {:.0f} | {:.0f} |\n", count, median(rates[0]),
             median(rates[1]), median(rates[2]), median(parts), median(rates[3]), median(rates[4]));
}

std::vector<std::string> corpus_files() {
  std::vector<std::string> files;
  for (const char* file : {"static/head", "static/flight_helmet_notex", "animated/cesium_man_notex", "animated/fox",
                           "animated/kaykit_knight", "animated/mannequiny", "animated/quaternius_smooth_female_dress",
                           "animated/robot_expressive"}) {
    files.push_back(std::string(FOREDRAW_SOURCE_DIR "/benchmarks/corpus/") + file + ".glb");
  }
  return files;
}

}  // namespace
}  // namespace foredraw::bench

int main(int argc, char** argv) {
  using namespace foredraw::bench;
  std::vector<std::string> files(argv + 1, argv + argc);
  if (files.empty()) files = corpus_files();
  fmt::print(
      "| model | vertices | position, of the diagonal | peer | finer | normal, degrees | peer | finer | tangent, "
      "degrees | peer | finer | uv, texels of 4096 | peer | finer |\n"
      "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::string& file : files) compare_precision(file);
  fmt::print(
      "\n| vertices | packed, millions a second | unpacked | copied | unpacked / copied | packed one by one, in C | "
      "unpacked |\n|---:|---:|---:|---:|---:|---:|---:|\n");
  for (const std::size_t count : {4096u, 65536u, 1048576u}) measure_speed(count);
}
