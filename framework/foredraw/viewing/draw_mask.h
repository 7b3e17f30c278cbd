#pragma once
#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>
#include <foredraw/viewing/mask.h>

#include <memory>
#include <string>
#include <variant>

namespace foredraw {

/// The mask of a draw, of its full level; null where it has no holes. Or, as text, why it is not known where its holes
/// are. Images are decoded once.
std::variant<std::shared_ptr<const Mask>, std::string> mask_of(Analyses& analyses, const Scene& scene,
                                                               const Draw& draw);

}  // namespace foredraw
