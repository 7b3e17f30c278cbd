#pragma once
#include <foredraw/report/private/json_values.h>
#include <foredraw/report/report.h>

namespace foredraw {

/// Charts are whole; of a film everything but its pictures. Described in docs/reference/report.md.
Json json_of(const AttachmentRecord& attachment);

}  // namespace foredraw
