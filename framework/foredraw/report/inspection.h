#pragma once
#include <foredraw/analysis/analyses.h>
#include <foredraw/scene/scene.h>

#include <string>

namespace foredraw {

/// What a scene holds and what is odd about it, for people.
std::string inspection_text(const Scene& scene, Analyses& analyses);
std::string inspection_json(const Scene& scene, Analyses& analyses);

}  // namespace foredraw
