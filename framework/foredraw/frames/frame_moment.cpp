#include <foredraw/frames/frame_moment.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace foredraw {

namespace {

/// How much longer a unit becomes at most.
double stretch_of(const glm::dmat4& by) {
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) most = std::max(most, glm::dot(glm::dvec3(by[axis]), glm::dvec3(by[axis])));
  return std::sqrt(most);
}

BoundingSphere moved(const BoundingSphere& sphere, const glm::dmat4& by) {
  return {glm::dvec3(by * glm::dvec4(sphere.centre, 1)), sphere.radius * stretch_of(by)};
}

glm::dmat3 moved(const glm::dvec3& half_box, const glm::dmat3& by) {
  return {by[0] * half_box.x, by[1] * half_box.y, by[2] * half_box.z};
}

/// Around the spheres of what each joint holds: a vertex lies between where its joints take it.
PlacedBounds moved_by_joints(std::span<const BoundingSphere> of_joints, const Skin& skin, const PosedNodes& nodes) {
  std::vector<BoundingSphere> each;
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (std::size_t i = 0; i < std::min(skin.joints.size(), of_joints.size()); ++i) {
    if (of_joints[i].radius < 0) continue;
    const glm::dmat4 from_bind = i < skin.inverse_bind_matrices.size() ? skin.inverse_bind_matrices[i] : glm::mat4(1);
    each.push_back(moved(of_joints[i], glm::dmat4(nodes.world[skin.joints[i]]) * from_bind));
    low = glm::min(low, each.back().centre - each.back().radius);
    high = glm::max(high, each.back().centre + each.back().radius);
  }
  if (each.empty()) return {};
  PlacedBounds all{{(low + high) / 2.0, 0}, glm::dmat3(0)};
  for (int axis = 0; axis < 3; ++axis) all.half_box[axis][axis] = (high[axis] - low[axis]) / 2;
  for (const BoundingSphere& one : each) {
    all.sphere.radius = std::max(all.sphere.radius, glm::length(one.centre - all.sphere.centre) + one.radius);
  }
  return all;
}

}  // namespace

FrameMoment frame_moment(const FrameScene& frames, double seconds) {
  const Scene& scene = frames.scene();
  FrameMoment moment;
  moment.nodes = posed_nodes_of_all_clips(scene, seconds);
  const auto objects = frames.objects();
  moment.world.reserve(objects.size());
  moment.bounds.reserve(objects.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const Node& node = scene.nodes[objects[i].node];
    glm::mat4 world = moment.nodes.world[objects[i].node];
    if (!node.instances.empty()) world = world * node.instances.view()[objects[i].instance].matrix();
    const FrameMesh& mesh = frames.mesh_of(i);
    moment.world.push_back(world);
    moment.bounds.push_back(node.skin
                                ? moved_by_joints(mesh.of_joints, scene.skins[*node.skin], moment.nodes)
                                : PlacedBounds{moved(mesh.sphere, world), moved(mesh.half_box, glm::dmat3(world))});
  }
  return moment;
}

bool is_mirrored(const FrameScene& scene, const FrameMoment& moment, std::size_t object) {
  const PlacedObject& placed = scene.objects()[object];
  const glm::mat4& world = placed.is_posed ? moment.nodes.world[placed.node] : moment.world[object];
  return glm::determinant(glm::dmat3(world)) < 0;
}

std::vector<SeenObject> seen_objects(const FrameScene& scene, const FrameMoment& moment, const FrameCamera& camera,
                                     FrameSize size) {
  const double half_width = camera.half_height * size.width / size.height;
  const double corner = std::sqrt(half_width * half_width + camera.half_height * camera.half_height);
  const double all_pixels = static_cast<double>(size.width) * size.height;
  // Planes through the eye, inwards; and the near one, which lies before it.
  const std::array<glm::dvec3, 5> inwards = {
      camera.ahead, camera.ahead * half_width - camera.right, camera.ahead * half_width + camera.right,
      camera.ahead * camera.half_height - camera.up, camera.ahead * camera.half_height + camera.up};
  std::vector<SeenObject> seen;
  for (std::size_t i = 0; i < moment.bounds.size(); ++i) {
    const PlacedBounds& bounds = moment.bounds[i];
    const glm::dvec3 to = bounds.sphere.centre - camera.eye;
    const auto reaches_in = [&](const glm::dvec3& plane, double from) {
      const glm::dvec3 reach = glm::abs(plane * bounds.half_box);
      return glm::dot(plane, to) + reach.x + reach.y + reach.z >= from;  // never, where something is not a number
    };
    bool is_seen = reaches_in(inwards[0], camera.near);
    for (std::size_t p = 1; p < inwards.size() && is_seen; ++p) is_seen = reaches_in(inwards[p], 0);
    if (!is_seen) continue;

    const double radius = bounds.sphere.radius, ahead = glm::dot(to, camera.ahead);
    const double nearest = std::max(ahead - radius, camera.near), middle = std::max(ahead, nearest);
    const double scale = camera.pixels_a_unit(middle, size);
    const glm::dvec2 place = glm::dvec2(glm::dot(to, camera.right), glm::dot(to, camera.up)) / middle;
    SeenObject object;
    object.object = static_cast<std::uint32_t>(i);
    object.distance = static_cast<float>(nearest);
    object.across = static_cast<float>(2 * radius * scale);
    object.pixels = static_cast<float>(
        std::min(all_pixels, scene.mesh_of(i).fill * glm::pi<double>() * (radius * scale) * (radius * scale)));
    object.shown = object.pixels;
    const double own_radius = scene.mesh_of(i).sphere.radius;
    object.pixels_a_unit =
        static_cast<float>(own_radius > 0 ? camera.pixels_a_unit(nearest, size) * radius / own_radius : 0);
    object.place = place * (size.height / (2 * camera.half_height));
    object.from_middle = static_cast<float>(std::min(1.0, glm::length(place) / corner));
    seen.push_back(object);
  }
  std::ranges::sort(seen, [](const SeenObject& a, const SeenObject& b) {
    return a.distance != b.distance ? a.distance < b.distance : a.object < b.object;
  });
  return seen;
}

}  // namespace foredraw
