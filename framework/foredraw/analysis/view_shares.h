#pragma once
#include <foredraw/analysis/overdraw_count.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/views.h>

#include <functional>

namespace foredraw {

/// draw(views) with the views shared out over the threads, one run of them after the other; [part][view] put together
/// again. There are few shares, as each may have to prepare something: twice the threads, for those that end early.
OverdrawCounts draw_in_shares(const Views& views, const Executor& executor,
                              const std::function<OverdrawCounts(const Views&)>& draw);

}  // namespace foredraw
