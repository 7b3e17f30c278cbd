#pragma once
#include <foredraw/report/private/json_values.h>
#include <foredraw/report/report.h>

namespace foredraw {

/// Described in docs/reference/report.md.
Json json_of(const Report& report);

/// Charts are whole; of a film everything but its pictures.
Json json_of(const AttachmentRecord& attachment);

}  // namespace foredraw
