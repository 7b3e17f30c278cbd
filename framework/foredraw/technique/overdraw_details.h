#pragma once
#include <foredraw/technique/overdraw_service.h>

#include <span>

namespace foredraw {

/// Captures the subjects and tells where their overdraw comes from: counts `shaded-times.N` of the scene's pixels (the
/// last one with all that are shaded more often), a note for each draw that causes a hundredth of the overdraw or
/// more, with the clusters that cause the most where it is clustered. One note instead where the service can not capture, or
/// where it would take too much memory.
void tell_overdraw_details(const Scene& scene, std::span<const Subject> subjects, std::span<const DrawnSubject> drawn,
                           OverdrawService& service, const Views& views, Run& run);

}  // namespace foredraw
