#pragma once
// The sequence of slots in a merged draw: any is as good for the GPU, so the one that hides most is free.

#include <foredraw/base/parallel.h>
#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/scene.h>

#include <span>
#include <vector>

namespace foredraw::processors::merge_instances {

/// A group's merged draws as draws of a scene of their own: a triangle list in the world for each, with all attributes,
/// of the set's first material, whose holes those of other materials are taken to be.
Scene group_scene(const Scene& scene, const MergedInstances& merged, std::uint32_t group);

/// The slots with those of each draw sorted by the DotRule within their group: what faces outwards from the group's
/// middle is drawn first. Groups are shared out over the threads. Source: Sander, Nehab, Barczak, SIGGRAPH 2007, "The
/// DotRule".
std::vector<MergedSlot> outward_slots(const MergedInstances& merged, const Executor& executor);

}  // namespace foredraw::processors::merge_instances
