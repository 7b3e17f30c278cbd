#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/c/library/private/pipeline_text.h>
#include <foredraw/io/file_lender.h>
#include <foredraw/job/pipelines.h>

namespace foredraw::c {

namespace {

/// Hands the report of the job over.
int ended(Job& job, foredraw_text* report) {
  put_made([&] { return to_json(job.report()); }, report);
  switch (job.status()) {
    case JobStatus::done: return FOREDRAW_DONE;
    case JobStatus::mistake: return FOREDRAW_MISTAKE;
    case JobStatus::cancelled: return FOREDRAW_CANCELLED;
    case JobStatus::in_part:
    case JobStatus::unreadable:
    case JobStatus::unwritable: break;
  }
  return FOREDRAW_FAILED;
}

}  // namespace

}  // namespace foredraw::c

using namespace foredraw;
using namespace foredraw::c;

int foredraw_optimize(foredraw_context* context, const foredraw_scene* scene, const char* pipeline,
                      foredraw_scene** result, foredraw_text* report) {
  return at_border(report, [&]() -> int {
    if (result != nullptr) *result = nullptr;
    if (context == nullptr || scene == nullptr || pipeline == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    const auto asked = changed(pipelines_in(pipeline, diagnostics), "pipeline", {}, context->registry, diagnostics);
    const HeldScene& held = *scene->held;
    Cancellable call(*context);
    const FileLender lender(context->input());
    const JobSetup setup = setup_for(call, lender);
    Job job(setup, JobKind::optimize, held.file.path, diagnostics);
    job.take(held.file, held.scene);
    const bool is_made = asked ? job.plan(*asked) && job.run() : job.refuse({});
    const int status = ended(job, report);
    if (is_made && result != nullptr) {
      *result = new foredraw_scene{std::make_shared<const HeldScene>(std::move(job.scene()), held.file, asked->output)};
    }
    return status;
  });
}

int foredraw_measure(foredraw_context* context, const foredraw_scene* scene, const char* evaluators,
                     foredraw_text* report) {
  return at_border(report, [&]() -> int {
    if (context == nullptr || scene == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    std::vector<NamedPipeline> only(1);
    bool is_sound = true;
    if (evaluators != nullptr) {
      auto stages = parse_stages(evaluators, "evaluators", diagnostics);
      is_sound = stages.has_value();
      if (is_sound) only[0].pipeline.measure = std::move(*stages);
    }
    is_sound = is_sound && change(only, {}, context->registry, diagnostics);
    Cancellable call(*context);
    const FileLender lender(context->input());
    const JobSetup setup = setup_for(call, lender);
    Job job(setup, JobKind::measure, scene->held->file.path, diagnostics);
    job.take(scene->held->file, scene->held->scene);
    if (!is_sound) {
      job.refuse({});
    } else if (job.plan(only[0].pipeline)) {
      job.run();
    }
    return ended(job, report);
  });
}
