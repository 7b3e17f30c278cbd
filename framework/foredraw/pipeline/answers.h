#pragma once
// What techniques answer, checked, applied and certified. Every function leaves the scene alone and throws
// std::runtime_error, saying what is wrong, where an answer is no answer.

#include <foredraw/scene/order_table.h>
#include <foredraw/scene/vertex_groups.h>
#include <foredraw/technique/plugin.h>

#include <utility>

namespace foredraw {

/// That an answer is one: each of `count` things once; a partition of the triangles; parts that change places as they
/// may; orders of draws that were given.
void check_order(std::span<const std::uint32_t> order, std::size_t count, std::string_view what);
void check_clusters(const Clusters& clusters, std::size_t triangles);
void check_sequence(const SubjectView& subject, std::span<const std::uint32_t> sequence);
void check_orders(const SubjectView& subject, const SubjectOrders& answer);

using ChangedDraws = std::vector<std::pair<DrawId, Draw>>;

/// The draw in the order, made for a vertex cache of `cache_size` entries (0: for the one that it was made for).
Draw ordered(const DrawView& draw, const IndexOrder& order, int cache_size, Analyses& analyses);

/// The draw cut into the clusters.
Draw clustered(const DrawView& draw, Clusters clusters);

struct OrderedSubject {
  ChangedDraws draws;  ///< each with its k orders
  OrderTable table;
  std::vector<SubjectPart> sequence;  ///< of the parts; empty: as it was
};
OrderedSubject ordered(const SubjectView& subject, SubjectOrders answer, Analyses& analyses);

/// Each user of the group with its vertices in the order; of a user's draw only that level is new.
std::vector<std::pair<VertexGroup::User, Draw>> renumbered(const Scene& scene, const VertexGroup& group,
                                                           const VertexOrder& order, Analyses& analyses);

/// Whether both draw from the same memory, with the same material.
bool has_same_handles(const Draw& a, const Draw& b);

/// That every order of every level of `after` draws the triangles that `before` drew at that level.
void certify(const Draw& before, const Draw& after, Analyses& analyses);

}  // namespace foredraw
