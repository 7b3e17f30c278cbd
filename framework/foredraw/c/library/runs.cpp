#include <foredraw/c/library/private/border.h>
#include <foredraw/c/library/private/handles.h>
#include <foredraw/c/library/private/pipeline_text.h>
#include <foredraw/io/file_lender.h>
#include <foredraw/io/image/images.h>
#include <foredraw/pipeline/runner.h>
#include <foredraw/pipeline/usual_measures.h>

namespace foredraw::c {

namespace {

using Work = Result (*)(const Plan&, Scene, const Surroundings&);

/// With what is usual to measure, if it does not say.
std::optional<Pipeline> pipeline_of(const std::string& text, const Registry& registry, Diagnostics& diagnostics) {
  auto pipeline = only_one(pipelines_in(text, diagnostics), "pipeline", diagnostics);
  if (pipeline && pipeline->measure.empty()) pipeline->measure = usual_measures(pipeline->stages, registry);
  return pipeline;
}

/// Plans, works, and hands the report over; the scene that came of it, where the status is done or failed.
int run(foredraw_context& context, const HeldScene& held, const Pipeline* pipeline, const char* command, Work work,
        Diagnostics diagnostics, foredraw_text* report, Scene& result) {
  Report lost{.command = command, .input = {held.path, held.bytes, held.stamp}};
  const auto refuse = [&](int status) {
    lost.diagnostics = diagnostics.all();
    put_made([&] { return to_json(lost); }, report);
    return status;
  };
  if (pipeline == nullptr) return refuse(FOREDRAW_MISTAKE);
  const FileLender lender(context.input());
  const auto planned = plan(*pipeline, context.registry, held.scene, diagnostics, &lender);
  if (!planned) return refuse(FOREDRAW_MISTAKE);

  Cancellable call(context);
  Analyses analyses(image_decoder(held.path));
  Result made = work(*planned, held.scene, {context.executor, analyses, &call.is_cancelled(), call.progress()});
  made.report.command = command;
  made.report.input = lost.input;
  for (const Diagnostic& diagnostic : made.report.diagnostics) diagnostics.add(diagnostic);
  made.report.diagnostics = diagnostics.all();
  put_made([&] { return to_json(made.report); }, report);
  if (call.is_cancelled()) return FOREDRAW_CANCELLED;
  result = std::move(made.scene);
  return made.failed ? FOREDRAW_FAILED : FOREDRAW_DONE;
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
    const auto asked = pipeline_of(pipeline, context->registry, diagnostics);
    const HeldScene& held = *scene->held;
    Scene made;
    const int status =
        run(*context, held, asked ? &*asked : nullptr, "optimize", optimize, std::move(diagnostics), report, made);
    if (result != nullptr && (status == FOREDRAW_DONE || status == FOREDRAW_FAILED)) {
      *result =
          new foredraw_scene{std::make_shared<const HeldScene>(std::move(made), held.path, held.bytes, held.stamp)};
    }
    return status;
  });
}

int foredraw_measure(foredraw_context* context, const foredraw_scene* scene, const char* evaluators,
                     foredraw_text* report) {
  return at_border(report, [&]() -> int {
    if (context == nullptr || scene == nullptr) return FOREDRAW_NULL_POINTER;
    Diagnostics diagnostics;
    std::optional<Pipeline> asked = Pipeline{};
    if (evaluators == nullptr) {
      asked->measure = usual_measures({}, context->registry);
    } else if (auto stages = parse_stages(evaluators, "evaluators", diagnostics)) {
      asked->measure = std::move(*stages);
    } else {
      asked.reset();
    }
    Scene same;
    return run(*context, *scene->held, asked ? &*asked : nullptr, "measure", measure, std::move(diagnostics), report,
               same);
  });
}
