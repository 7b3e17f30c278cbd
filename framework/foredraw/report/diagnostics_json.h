#pragma once
#include <foredraw/base/diagnostics.h>

#include <string>

namespace foredraw {

/// {"diagnostics": [...]}, as a report has them: of what has no report.
std::string to_json(const Diagnostics& diagnostics);

}  // namespace foredraw
