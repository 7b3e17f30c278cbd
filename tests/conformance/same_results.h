#pragma once
// What has to be the same in two runs.

#include <foredraw/pipeline/runner.h>

#include <vector>

namespace foredraw::testing {

/// Stamps of all that a scene draws.
std::vector<Stamp> content(const Scene& scene);

/// Every figure after the stages: numerator, denominator (or -1), error.
std::vector<double> figures(const Result& result);

/// Pictures and curves that techniques attached, in their sequence.
std::vector<AttachmentRecord> attachments(const Result& result);
bool same_attachments(const Result& a, const Result& b);

}  // namespace foredraw::testing
