#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/c/library/private/pipeline_text.h>
#include <foredraw/io/file_lender.h>
#include <foredraw/job/pipelines.h>

#include <algorithm>

using namespace foredraw;
using namespace foredraw::c;

int foredraw_compare(foredraw_context* context, const foredraw_scene* const* scenes, uint64_t scene_count,
                     const char* const* pipelines, uint64_t pipeline_count, uint32_t rounds,
                     foredraw_text* comparison) {
  return at_border(comparison, [&]() -> int {
    const auto holds_null = [](const auto* pointers, std::uint64_t count) {
      return pointers == nullptr ? count > 0 : std::find(pointers, pointers + count, nullptr) != pointers + count;
    };
    if (context == nullptr || holds_null(scenes, scene_count) || holds_null(pipelines, pipeline_count)) {
      return FOREDRAW_NULL_POINTER;
    }
    Diagnostics diagnostics;
    std::vector<NamedPipeline> contestants;
    for (const char* text : std::span(pipelines, pipeline_count)) {
      if (auto some = pipelines_in(text, diagnostics)) std::ranges::move(*some, std::back_inserter(contestants));
    }
    if (diagnostics.has_errors() || !change(contestants, {}, context->registry, diagnostics)) {
      put(diagnostics, comparison);
      return FOREDRAW_MISTAKE;
    }
    Cancellable call(*context);
    const FileLender lender(context->input());
    const JobSetup setup = setup_for(call, lender);
    const int times = static_cast<int>(std::clamp<std::uint32_t>(rounds, 1, 1000));
    std::vector<Comparison> comparisons;
    bool is_whole = true;
    for (const foredraw_scene* scene : std::span(scenes, scene_count)) {
      const HeldScene& held = *scene->held;
      Job job(setup, JobKind::compare, held.file.path);
      job.take(held.file, held.scene);
      comparisons.push_back(job.compare(contestants, times).comparison);
      is_whole = is_whole && job.status() == JobStatus::done;
    }
    put(to_json(comparisons), comparison);
    if (call.is_cancelled()) return FOREDRAW_CANCELLED;
    return is_whole ? FOREDRAW_DONE : FOREDRAW_FAILED;
  });
}
