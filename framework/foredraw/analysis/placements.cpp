#include <foredraw/analysis/placements.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace foredraw {

namespace {

struct Placement {
  DrawId draw = 0;
  std::uint32_t skin = ~std::uint32_t{0};
  std::array<float, 12> rows{};  ///< of the transform to the world; its translation first, so that it sorts by it
  auto key() const { return std::tie(draw, skin, rows[0], rows[1], rows[2]); }
  friend auto operator<=>(const Placement&, const Placement&) = default;
};

Placement placement(DrawId draw, std::optional<SkinId> skin, const glm::mat4& world) {
  Placement made{draw, skin.value_or(~SkinId{0}), {}};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 3; ++row)
      made.rows[static_cast<std::size_t>(3 * ((column + 1) % 4) + row)] = world[column][row];
  }
  return made;
}

std::vector<Placement> placements_of(const Scene& scene) {
  const std::vector<glm::mat4> worlds = world_transforms(scene);
  std::vector<Placement> placements;
  for (NodeId n = 0; n < scene.nodes.size(); ++n) {
    const Node& node = scene.nodes[n];
    if (!node.mesh || !node.is_shown) continue;
    for (const DrawId draw : scene.meshes[*node.mesh].draws) {
      if (node.instances.empty()) placements.push_back(placement(draw, node.skin, worlds[n]));
      for (const Transform& one : node.instances.view()) {
        placements.push_back(placement(draw, node.skin, worlds[n] * one.matrix()));
      }
    }
  }
  std::ranges::sort(placements);
  return placements;
}

bool is_near(const Placement& a, const Placement& b) {
  for (std::size_t row = 0; row < 3; ++row) {
    float most = 0;
    for (std::size_t i = row; i < 12; i += 3) most = std::max(most, std::abs(a.rows[i]));
    for (std::size_t i = row; i < 12; i += 3) {
      const bool same = a.rows[i] == b.rows[i] || std::abs(a.rows[i] - b.rows[i]) <= 1e-5f * most;
      const bool neither_is_one = std::isnan(a.rows[i]) && std::isnan(b.rows[i]);
      if (!same && !neither_is_one) return false;
    }
  }
  return true;
}

/// Of placements with one translation, whose turns may be rounded otherwise and so sorted otherwise.
bool same_at_a_point(std::span<const Placement> a, std::span<Placement> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto found = std::find_if(b.begin() + static_cast<std::ptrdiff_t>(i), b.end(),
                                    [&](const Placement& one) { return is_near(a[i], one); });
    if (found == b.end()) return false;
    std::rotate(b.begin() + static_cast<std::ptrdiff_t>(i), found, found + 1);
  }
  return true;
}

bool is_placed_alike(const Node& a, const Node& b) {
  return a.mesh == b.mesh && a.skin == b.skin && a.is_shown == b.is_shown && a.children == b.children &&
         a.instances.is(b.instances) && a.matrix == b.matrix && a.transform.translation == b.transform.translation &&
         a.transform.rotation == b.transform.rotation && a.transform.scale == b.transform.scale;
}

}  // namespace

std::string placement_difference(const Scene& before, const Scene& after) {
  const bool same_meshes = std::ranges::equal(before.meshes, after.meshes, {}, &Mesh::draws, &Mesh::draws);
  if (same_meshes && std::ranges::equal(before.nodes, after.nodes, is_placed_alike)) return {};
  const std::vector<Placement> was = placements_of(before);
  std::vector<Placement> is = placements_of(after);
  const auto name_of = [&](DrawId id) {
    return id < before.draws.size() ? before.draws[id].name : after.draws[id].name;
  };
  for (std::size_t first = 0; first < std::min(was.size(), is.size());) {
    std::size_t end = first;
    while (end < was.size() && was[end].key() == was[first].key()) ++end;
    if (end > is.size() ||
        !same_at_a_point(std::span(was).subspan(first, end - first), std::span(is).subspan(first, end - first))) {
      return "it no longer draws " + name_of(was[first].draw) + " at the same places";
    }
    first = end;
  }
  if (was.size() != is.size()) {
    return "it places " + std::to_string(is.size()) + " draws, but there were " + std::to_string(was.size()) +
           " before";
  }
  return {};
}

}  // namespace foredraw
