#include "made_kinds.h"

#include <cmath>

namespace foredraw::bench {

std::vector<KnownMesh> made_meshes(std::uint64_t seed) {
  using namespace made;
  Random random(seed);
  std::vector<KnownMesh> all;
  for (int i = 0; i < 4; ++i) all.push_back(catenary(random));
  for (const auto make : {rough_wire, coil, ring, lamp_post, railing, antenna, rope, net}) {
    all.push_back(make(random));
    all.push_back(make(random));
  }
  for (const char* what : {"road marking", "plank", "bumper", "sword", "finger", "sail hem", "bar 5:1:1", "fat ring",
                           "egg", "blade of grass"}) {
    all.push_back(no_wires(random, what));
  }
  return all;
}

KnownMesh fine_tubes(std::uint32_t triangles) {
  using namespace made;
  Random random(1);
  KnownMesh mesh = named("fine tubes");
  constexpr std::uint32_t sides = 16, rings = 200;
  Outline outline = circle(sides);
  for (glm::dvec2& at : outline) at *= 0.05;
  for (std::uint32_t wire = 0; mesh.wire_of.size() < triangles; ++wire) {
    const Line line = hanging(random, rings);
    sweep(mesh, line, outline, {.wire = wire}, random);
    mesh.length.push_back(length_of(line));
  }
  return mesh;
}

KnownMesh turned_bodies(std::uint32_t triangles) {
  using namespace made;
  Random random(1);
  KnownMesh mesh = named("turned bodies");
  constexpr std::uint32_t sides = 48, rings = 100;
  Outline outline = circle(sides);
  for (std::uint32_t body = 0; mesh.wire_of.size() < triangles; ++body) {
    const glm::dvec3 foot(2 * (body % 8), 0, 2 * (body / 8));
    const double waves = between(random, 2, 6), depth = between(random, 0.2, 0.45), beads = between(random, 15, 40);
    Line line;
    Sweep how{.wire = no_wire};
    for (std::uint32_t r = 0; r < rings; ++r) {
      const double t = static_cast<double>(r) / (rings - 1);
      line.push_back(foot + glm::dvec3(0, 2 * t, 0));
      how.scale.push_back(0.4 * (1 + depth * std::cos(waves * t * pi)) * (1 - 0.6 * t) +
                          0.03 * std::abs(std::sin(beads * t)));
    }
    sweep(mesh, line, outline, how, random);
  }
  return mesh;
}

KnownMesh hairs(std::uint32_t count) {
  using namespace made;
  Random random(1);
  KnownMesh mesh = named("hairs");
  for (std::uint32_t wire = 0; wire < count; ++wire) {
    const glm::dvec3 root(between(random, -1, 1), 0, between(random, -1, 1));
    const glm::dvec3 lean(between(random, -1, 1), 0, between(random, -1, 1));
    Line line;
    for (int i = 0; i <= 4; ++i) line.push_back(root + glm::dvec3(0, 0.25 * i, 0) + lean * (0.02 * i * i));
    sweep(mesh, line, {{-0.0005, 0}, {0.0005, 0}}, {.closed_section = false, .wire = wire}, random);
    mesh.length.push_back(1);
  }
  return mesh;
}

}  // namespace foredraw::bench
