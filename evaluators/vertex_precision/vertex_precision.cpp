#include "vertex_precision.h"

#include <foredraw/geometry/box.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

namespace foredraw {

namespace {

using PositionBox = Box<glm::dvec3>;

void add_finite(PositionBox& box, const glm::dvec3& point) {
  if (std::isfinite(glm::dot(point, point))) box.add(point);
}

/// What decides where positions lie: draws with equal ones share a box.
bool same_lattice(const PackedLayout& a, const PackedLayout& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.origin[i] != b.origin[i] || a.field[i].bits != b.field[i].bits) return false;
  }
  return a.step == b.step;
}

/// The draw's own box, and then that of all draws with its lattice.
template <class LayoutOf>
std::vector<double> diagonals(const std::vector<PackedVertices::OfDraw>& draws, const std::vector<PositionBox>& boxes,
                              LayoutOf layout_of) {
  std::vector<double> result;
  for (const PackedVertices::OfDraw& draw : draws) {
    PositionBox box;
    for (std::size_t other = 0; other < draws.size(); ++other) {
      const PackedLayout *mine = layout_of(draw), *its = layout_of(draws[other]);
      if (mine != nullptr && its != nullptr && same_lattice(*mine, *its)) box.add(boxes[other]);
    }
    result.push_back(box.diagonal());
  }
  return result;
}

PositionBox stored_box(const VertexStreams& vertices) {
  PositionBox box;
  if (const VertexStream* positions = vertices.find("POSITION")) {
    for (const glm::vec3& position : decode_vec3(*positions)) add_finite(box, glm::dvec3(position));
  }
  return box;
}

struct InPose {
  PosedPrecision precision;
  PositionBox box;
};

/// Without what else a row holds.
PackedLayout of_positions(PackedLayout layout) {
  for (int f = FOREDRAW_PACKED_NORMAL_0; f < FOREDRAW_PACKED_FIELDS; ++f) layout.field[f].bits = 0;
  return layout;
}

void add(InPose& sum, const PackedLayout& layout, std::span<const glm::vec3> positions) {
  for (const glm::vec3& position : positions) {
    foredraw_packed_vertex vertex{{position.x, position.y, position.z}, {}, {}, {}}, decoded;
    std::uint32_t row[4];
    const bool is_outside = foredraw_packed_encode(&layout, &vertex, row) != 0;
    foredraw_packed_decode(&layout, row, &decoded);
    const glm::dvec3 is(decoded.position[0], decoded.position[1], decoded.position[2]);
    add_finite(sum.box, glm::dvec3(position));
    sum.precision.outside += is_outside ? 1 : 0;
    sum.precision.vertices += 1;
    const double error = glm::length(is - glm::dvec3(position));
    if (!is_outside) sum.precision.position = std::max(sum.precision.position, error);
  }
}

void add(InPose& sum, const InPose& other) {
  sum.box.add(other.box);
  sum.precision.position = std::max(sum.precision.position, other.precision.position);
  sum.precision.outside += other.precision.outside;
  sum.precision.vertices += other.precision.vertices;
}

/// [packed draw], with nothing where the draw has no posed layout.
std::vector<InPose> in_all_poses(const Scene& scene, const std::vector<PackedVertices::OfDraw>& draws, SubjectUnit unit,
                                 const Poses& poses, const Executor& executor) {
  std::vector<std::vector<SubjectPart>> parts(draws.size());
  for (const Subject& subject : subjects_of(scene, unit)) {
    for (const SubjectPart& part : subject.parts) {
      const auto packed = std::ranges::lower_bound(draws, part.draw, {}, &PackedVertices::OfDraw::draw);
      if (packed == draws.end() || packed->draw != part.draw || !packed->posed) continue;
      parts[static_cast<std::size_t>(packed - draws.begin())].push_back(part);
    }
  }
  std::vector<std::vector<InPose>> found(poses.poses.size(), std::vector<InPose>(draws.size()));
  executor.for_each(found.size(), [&](std::size_t p) {
    const PosedNodes nodes = posed_nodes(scene, poses.poses[p]);
    for (std::size_t d = 0; d < draws.size(); ++d) {
      if (parts[d].empty()) continue;
      const PackedLayout layout = of_positions(*draws[d].posed);
      for (const SubjectPart& part : parts[d]) add(found[p][d], layout, posed_positions(scene, part, nodes));
    }
  });
  std::vector<InPose> sums(draws.size());
  for (const std::vector<InPose>& pose : found) {
    for (std::size_t d = 0; d < draws.size(); ++d) add(sums[d], pose[d]);
  }
  return sums;
}

std::uint64_t plain_bytes(const VertexStreams& vertices, const PackedLayout& layout) {
  std::uint64_t bytes = 0;
  for (const auto& [semantic, field] : {std::pair<std::string_view, int>{"POSITION", FOREDRAW_PACKED_X},
                                        {"NORMAL", FOREDRAW_PACKED_NORMAL_0},
                                        {"TANGENT", FOREDRAW_PACKED_TANGENT},
                                        {"TEXCOORD_0", FOREDRAW_PACKED_U}}) {
    const VertexStream* stream = vertices.find(semantic);
    if (stream != nullptr && layout.field[field].bits != 0) bytes += stream->bytes.size();
  }
  return bytes;
}

}  // namespace

std::vector<DrawPrecision> vertex_precision(const Scene& scene, SubjectUnit unit, const Poses& poses,
                                            const Executor& executor) {
  const PackedVertices* packed = scene.products.find<PackedVertices>();
  if (packed == nullptr) return {};
  const std::vector<PackedVertices::OfDraw>& draws = packed->draws;
  std::vector<DrawPrecision> result(draws.size());
  std::vector<PositionBox> boxes(draws.size());
  executor.for_each(draws.size(), [&](std::size_t d) {
    const VertexStreams& vertices = *scene.draws[draws[d].draw].full().vertices;
    const auto rows = draws[d].rows.front().view();
    boxes[d] = stored_box(vertices);
    result[d].draw = draws[d].draw;
    result[d].errors = packed_errors(vertices, draws[d].layout, rows);
    result[d].bounds = packed_bounds(draws[d].layout, result[d].errors.skew);
    result[d].packed_bytes = rows.size_bytes();
    result[d].plain_bytes = plain_bytes(vertices, draws[d].layout);
  });
  const auto posed_layout = [](const PackedVertices::OfDraw& draw) { return draw.posed ? &*draw.posed : nullptr; };
  const std::vector<double> stored =
      diagonals(draws, boxes, [](const PackedVertices::OfDraw& draw) { return &draw.layout; });
  const std::vector<InPose> posed = in_all_poses(scene, draws, unit, poses, executor);
  for (std::size_t d = 0; d < draws.size(); ++d) boxes[d] = posed[d].box;
  const std::vector<double> moving = diagonals(draws, boxes, posed_layout);
  for (std::size_t d = 0; d < draws.size(); ++d) {
    result[d].diagonal = stored[d];
    if (!draws[d].posed) continue;
    result[d].posed = posed[d].precision;
    result[d].posed->bound = packed_bounds(*draws[d].posed).position;
    result[d].posed->diagonal = moving[d];
  }
  return result;
}

}  // namespace foredraw
