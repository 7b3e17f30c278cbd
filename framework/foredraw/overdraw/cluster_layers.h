#pragma once
// Fragment layers for those who sort clusters: far fewer owners, and what a cluster hides of itself is left out.

#include <foredraw/overdraw/fragment_layers.h>
#include <foredraw/scene/clusters.h>

namespace foredraw {

/// What FragmentLayers hold, of clusters in place of triangles. They judge orders of these clusters, each drawn as it
/// stands, and of nothing else.
struct ClusterLayers : Layers {};

/// The clusters are ranges of the layers' triangles: of several parts, one part's behind the other's. A fragment behind
/// one of its own cluster that is drawn before it never passes, and lists with one cluster left are only counted.
/// std::invalid_argument where the clusters are no partition of the triangles. O(what the layers hold), one view a
/// task.
ClusterLayers cluster_layers(const FragmentLayers& layers, const Clusters& clusters, const Executor& executor);

}  // namespace foredraw
