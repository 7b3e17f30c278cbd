#pragma once
#include <foredraw/report/report.h>

#include <string>

namespace foredraw {

/// A chart whole; of a film everything but its pictures. Described in docs/reference/report.md.
std::string to_json(const AttachmentRecord& attachment);

}  // namespace foredraw
