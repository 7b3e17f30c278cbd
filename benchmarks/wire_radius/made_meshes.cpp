#include "made_kinds.h"

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
