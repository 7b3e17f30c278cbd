#pragma once
#include <foredraw/measuring/overdraw_service.h>
#include <foredraw/measuring/subjects_in_poses.h>
#include <foredraw/viewing/drawn_orders.h>

#include <string>
#include <vector>

namespace foredraw {

/// Captures the subjects in their poses and tells where their overdraw comes from: counts `shaded-times.N` of the
/// scene's pixels (the last one with all that are shaded more often), a note for each draw that causes a hundredth of
/// the overdraw or more, with the clusters that cause the most where it is clustered. One more names the draws that
/// cause none. One note instead where the service can not capture, or where it would take too much memory.
void tell_overdraw_details(const SubjectsInPoses& subjects, const OverdrawService& service, const Views& views,
                           SequenceFrom said_by, Run& run);

/// "3 draws (Glass, Smoke, Flame/1)", with the first few names.
std::string listed_draws(const std::vector<std::string>& names);

}  // namespace foredraw
