// How well wires are found, and how fast.
//   wire-radius-bench LABELS FOLDER      models labelled by hand: recall and precision by length, mesh by mesh
//   wire-radius-bench made SEED...       made meshes: recall, precision, and errors of centre lines and half widths
//   wire-radius-bench options LABELS FOLDER SEED...   all of these, at other options than the usual ones
//   wire-radius-bench time               seconds for 200,000 triangles of several kinds, and for 1,000,000 hairs

#include "wire_scores.h"

#include <benchmarks/timing.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string_view>

namespace foredraw::bench {
namespace {

double part_of(std::vector<double> values, double part) {
  if (values.empty()) return 0;
  std::ranges::sort(values);
  return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
}

void print_heading(const char* what) {
  fmt::print("{:<48} {:>9} {:>7} {:>7} {:>9} {:>8} {:>8} {:>8} {:>7}\n", what, "length", "recall", "precis.", "wrong",
             "either", "centre", "radius", "seconds");
}

void print(const std::string& name, const WireScore& of, double took) {
  fmt::print("{:<48} {:>9.2f} {:>7.3f} {:>7.3f} {:>9.2f} {:>8.2f} {:>8.4f} {:>8.4f} {:>7.3f}\n", name, of.known,
             of.recall(), of.precision(), of.found - of.right, of.either, part_of(of.centre_error, 0.5),
             part_of(of.radius_error, 0.5), took);
}

struct Sum {
  WireScore score;
  double seconds = 0;
};

Sum run(const std::vector<KnownMesh>& meshes, const WireOptions& options, bool prints) {
  Sum sum;
  for (const KnownMesh& mesh : meshes) {
    FoundWires found;
    const double took = seconds_of([&] { found = find_wires(mesh.positions, mesh.indices, options); });
    const WireScore of = score(mesh, found);
    if (prints) print(mesh.name, of, took);
    sum.score.add(of);
    sum.seconds += took;
  }
  return sum;
}

std::vector<KnownMesh> made(std::span<char*> seeds) {
  std::vector<KnownMesh> meshes;
  for (const char* seed : seeds) {
    for (KnownMesh& mesh : made_meshes(std::stoull(seed))) {
      mesh.name = fmt::format("{} {}", seed, mesh.name);
      meshes.push_back(std::move(mesh));
    }
  }
  return meshes;
}

void print_sum(const Sum& sum) {
  print("all", sum.score, sum.seconds);
  if (sum.score.centre_error.empty()) return;
  fmt::print("centre, of the half width: median {:.4f}, 95 % {:.4f}, worst {:.4f}\n",
             part_of(sum.score.centre_error, .5), part_of(sum.score.centre_error, .95),
             part_of(sum.score.centre_error, 1));
  fmt::print("half width: median {:.4f}, 95 % {:.4f}, worst {:.4f}\n", part_of(sum.score.radius_error, .5),
             part_of(sum.score.radius_error, .95), part_of(sum.score.radius_error, 1));
}

void print_options(const std::vector<KnownMesh>& labelled, const std::vector<KnownMesh>& made) {
  const auto row = [&](const std::string& name, const WireOptions& options) {
    const Sum hand = run(labelled, options, false), seed = run(made, options, false);
    fmt::print("| {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.4f} | {:.4f} | {:.2f} |\n", name, hand.score.recall(),
               hand.score.precision(), seed.score.recall(), seed.score.precision(),
               part_of(seed.score.centre_error, .5), part_of(seed.score.radius_error, .5), hand.seconds + seed.seconds);
    std::fflush(stdout);  // a row takes seconds
  };
  fmt::print("| options | recall | precision | made: recall | precision | centre | half width | seconds |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  row("usual", {});
  for (const double slender : {4.0, 6.0, 12.0, 20.0}) row(fmt::format("slender = {}", slender), {.slender = slender});
  for (const double aspect : {1.5, 3.0, 4.0}) row(fmt::format("aspect = {}", aspect), {.aspect = aspect});
  for (const double taper : {1.5, 2.0, 5.0}) row(fmt::format("taper = {}", taper), {.taper = taper});
  for (const double decal : {0.0, 0.5, 2.0}) row(fmt::format("decal = {}", decal), {.decal = decal});
  row("ribbons = false", {.ribbons = false});
}

void print_times() {
  for (const std::uint32_t triangles : {200'000u, 2'000'000u}) {
    const KnownMesh tubes = fine_tubes(triangles);
    fmt::print("fine tubes, {} triangles: {:.2f} s\n", tubes.wire_of.size(),
               seconds_of([&] { find_wires(tubes.positions, tubes.indices); }));
  }
  const KnownMesh bodies = turned_bodies(200'000);
  fmt::print("turned bodies, {} triangles: {:.2f} s\n", bodies.wire_of.size(),
             seconds_of([&] { find_wires(bodies.positions, bodies.indices); }));
  for (const std::uint32_t count : {25'000u, 1'000'000u}) {
    const KnownMesh mesh = hairs(count);
    fmt::print("hairs, {} triangles: {:.2f} s\n", mesh.wire_of.size(),
               seconds_of([&] { find_wires(mesh.positions, mesh.indices); }));
  }
}

int main_of(std::span<char*> arguments) {
  const std::string_view what = arguments.size() > 1 ? arguments[1] : "";
  if (what == "time") {
    print_times();
  } else if (what == "made" && arguments.size() > 2) {
    print_heading("made from a seed");
    print_sum(run(made(arguments.subspan(2)), {}, true));
  } else if (what == "options" && arguments.size() > 4) {
    print_options(labelled_meshes(arguments[2], arguments[3]), made(arguments.subspan(4)));
  } else if (arguments.size() == 3) {
    print_heading("labelled by hand");
    print_sum(run(labelled_meshes(arguments[1], arguments[2]), {}, true));
  } else {
    fmt::print(stderr,
               "usage: wire-radius-bench LABELS FOLDER | made SEED... | options LABELS FOLDER SEED... | time\n");
    return 1;
  }
  return 0;
}

}  // namespace
}  // namespace foredraw::bench

int main(int count, char** arguments) {
  try {
    return foredraw::bench::main_of({arguments, static_cast<std::size_t>(count)});
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
