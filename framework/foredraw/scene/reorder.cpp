#include <foredraw/scene/reorder.h>

#include <foredraw/scene/taken_vertices.h>

#include <algorithm>
#include <array>
#include <numeric>

namespace foredraw {

bool is_permutation(std::span<const std::uint32_t> order, std::size_t count) {
  if (order.size() != count) return false;
  std::vector<bool> seen(count, false);
  for (std::uint32_t old : order) {
    if (old >= count || seen[old]) return false;
    seen[old] = true;
  }
  return true;
}

namespace {

std::optional<Clusters> moved_clusters(const Clusters& clusters, std::span<const std::uint32_t> order) {
  std::vector<std::uint32_t> cluster_of(order.size());
  for (std::uint32_t c = 0; c < clusters.count(); ++c) {
    std::fill(cluster_of.begin() + clusters.offsets[c], cluster_of.begin() + clusters.offsets[c + 1], c);
  }
  Clusters moved{{0}};
  for (std::uint32_t i = 1; i < order.size(); ++i) {
    if (cluster_of[order[i]] != cluster_of[order[i - 1]]) moved.offsets.push_back(i);
  }
  if (!order.empty()) moved.offsets.push_back(static_cast<std::uint32_t>(order.size()));
  if (moved.count() != clusters.count()) return std::nullopt;  // some cluster starts twice: torn
  return moved;
}

/// For each new vertex an old one that goes there.
std::vector<std::uint32_t> sources(std::span<const std::uint32_t> destination, std::uint32_t count) {
  std::vector<std::uint32_t> from(count, 0);
  for (std::uint32_t v = static_cast<std::uint32_t>(destination.size()); v-- > 0;) {
    if (destination[v] != no_vertex) from[destination[v]] = v;
  }
  return from;
}

}  // namespace

namespace {

/// A triangle with its corners turned so that the sequence is the least there is, and its number.
using NumberedTriangle = std::array<std::uint32_t, 4>;

std::vector<NumberedTriangle> sorted_triangles(std::span<const std::uint32_t> indices) {
  std::vector<NumberedTriangle> triangles;
  triangles.reserve(indices.size() / 3);
  for (std::uint32_t t = 0; t < indices.size() / 3; ++t) {
    const auto corner = [&](std::size_t i) { return indices[3 * std::size_t{t} + i % 3]; };
    NumberedTriangle least = {corner(0), corner(1), corner(2), t};
    for (const std::size_t turn : {1, 2}) {
      least = std::min(least, {corner(turn), corner(turn + 1), corner(turn + 2), t});
    }
    triangles.push_back(least);
  }
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

std::optional<IndexOrder> order_between(std::span<const std::uint32_t> from, std::span<const std::uint32_t> to) {
  if (from.size() != to.size()) return std::nullopt;
  const std::vector<NumberedTriangle> old = sorted_triangles(from);
  const std::vector<NumberedTriangle> now = sorted_triangles(to);
  IndexOrder order(now.size());
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (!std::equal(now[i].begin(), now[i].end() - 1, old[i].begin())) return std::nullopt;
    order[now[i][3]] = old[i][3];
  }
  return order;
}

IndexStream with_triangle_order(const IndexStream& stream, std::span<const std::uint32_t> order) {
  const std::span<const std::uint32_t> old = stream.indices.view();
  const std::span<const std::uint32_t> old_origin = stream.triangle_origin.view();
  std::vector<std::uint32_t> indices(old.size());
  std::vector<std::uint32_t> origin(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    std::copy_n(old.begin() + 3 * std::size_t{order[i]}, 3, indices.begin() + 3 * i);
    origin[i] = old_origin.empty() ? order[i] : old_origin[order[i]];
  }
  IndexStream result = stream;
  result.indices = Shared<std::uint32_t>(std::move(indices));
  result.triangle_origin = Shared<std::uint32_t>(std::move(origin));
  if (stream.clusters) result.clusters = moved_clusters(*stream.clusters, order);
  return result;
}

Draw with_triangle_order(const Draw& draw, std::span<const std::uint32_t> order) {
  Draw result = draw;
  IndexStream& stream = result.full().stream();
  const bool had_clusters = stream.clusters.has_value();
  stream = with_triangle_order(stream, order);
  if (had_clusters && !stream.clusters) result.full().made.remove(traits::clustered);
  return result;
}

VertexStreams with_vertices_moved(const VertexStreams& streams, std::span<const std::uint32_t> destination,
                                  std::uint32_t count) {
  return taken_vertices(streams, sources(destination, count));
}

Draw with_vertices_moved(const Draw& draw, std::size_t level, std::shared_ptr<const VertexStreams> moved,
                         std::span<const std::uint32_t> destination) {
  Draw result = draw;
  Level& changed = result.levels[level];
  for (IndexStream& stream : changed.orders) {
    std::vector<std::uint32_t> indices(stream.indices.view().begin(), stream.indices.view().end());
    for (std::uint32_t& index : indices) index = destination[index];
    stream.indices = Shared<std::uint32_t>(std::move(indices));
  }
  const std::span<const std::uint32_t> before = changed.vertex_destination.view();
  std::vector<std::uint32_t> whole(destination.begin(), destination.end());
  if (!before.empty()) {
    whole.assign(before.begin(), before.end());
    for (std::uint32_t& v : whole) v = v == no_vertex ? no_vertex : destination[v];
  }
  changed.vertex_destination = Shared<std::uint32_t>(std::move(whole));
  changed.vertices = std::move(moved);
  return result;
}

}  // namespace foredraw
