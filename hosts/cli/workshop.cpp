#include "workshop.h"

#include <foredraw/job/pipelines.h>

#include <utility>

namespace foredraw::cli {

Workshop::Workshop(const WatchArguments& arguments, const Registry& registry, const Executor& executor, Pipeline read,
                   SceneInput input)
    : pipeline(std::move(read)),
      how(std::move(input)),
      lender(how),
      job{pipeline, setup_of(arguments, registry, executor, lender, how)} {
  job.folder = arguments.inputs[0];
}

Workshop::~Workshop() = default;

std::unique_ptr<Workshop> Workshop::opened(const WatchArguments& arguments, const Registry& registry,
                                           const Executor& executor, Diagnostics& diagnostics) {
  auto pipeline = one_pipeline(arguments, registry, diagnostics);
  if (!pipeline) return nullptr;
  SceneInput how = input_of(arguments, arguments, registry);
  how.files = std::make_shared<FilesRead>();
  std::unique_ptr<Workshop> workshop(new Workshop(arguments, registry, executor, std::move(*pipeline), how));
  if (!is_sound(workshop->pipeline, registry, workshop->lender, diagnostics)) return nullptr;
  workshop->job.pipeline_files = files_of(arguments, workshop->pipeline, registry);
  workshop->cache = cache_of(arguments.cache, arguments.inputs[0], workshop->pipeline, registry, how, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  workshop->job.setup.cache = workshop->cache.get();
  return workshop;
}

}  // namespace foredraw::cli
