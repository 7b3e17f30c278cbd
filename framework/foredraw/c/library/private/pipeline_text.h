#pragma once
#include <foredraw/pipeline/parse.h>

namespace foredraw::c {

/// "@preset", the text of a file, which may hold several, or a line of stages.
std::optional<std::vector<NamedPipeline>> pipelines_in(const std::string& text, Diagnostics& diagnostics);

}  // namespace foredraw::c
