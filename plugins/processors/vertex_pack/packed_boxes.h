#pragma once
// Which draws share a lattice, and the boxes that these reach over.

#include "layout_search.h"

#include <foredraw/base/parallel.h>
#include <foredraw/scene/poses.h>
#include <foredraw/scene/subject.h>

#include <span>
#include <vector>

namespace foredraw::processors::vertex_pack {

/// Draws whose stored positions are in one space: of one subject, and of one mesh, one skin, or with one transform. So
/// vertices of two draws that are at one place stay there. Each draw is in one group; draws rise, and so do groups by
/// their first ones.
std::vector<std::vector<DrawId>> stored_groups(const Scene& scene, std::span<const Subject> subjects);

/// Parts that are posed together, for each group with a part that a skin or morph targets move: the subjects that share
/// draws, as one.
std::vector<std::vector<SubjectPart>> posed_groups(const Scene& scene, std::span<const Subject> subjects);

/// Of the stored positions of all levels of the draws. Numbers that are not finite are left out.
Box<glm::dvec3> stored_box(const Scene& scene, std::span<const DrawId> draws);

/// The same of each group in all the poses, in world space where nodes show the parts: with the morph weights of each
/// pose, and with all weights from 0 to 1.
std::vector<Box<glm::dvec3>> posed_boxes(const Scene& scene, std::span<const std::vector<SubjectPart>> groups,
                                         const Poses& poses, const Executor& executor);

/// How many units of the world one of the part's own is, at rest: along the longest of its axes, at its first vertex.
double rest_scale(const Scene& scene, const SubjectPart& part);

}  // namespace foredraw::processors::vertex_pack
