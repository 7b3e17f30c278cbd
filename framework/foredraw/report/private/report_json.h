#pragma once
#include <foredraw/report/private/json_writer.h>
#include <foredraw/report/report.h>

namespace foredraw {

/// Described in docs/reference/report.md.
void write(JsonWriter& out, const Report& report);

/// Charts are whole; of a film everything but its pictures.
void write(JsonWriter& out, const AttachmentRecord& attachment);

}  // namespace foredraw
