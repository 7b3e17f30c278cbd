#include "workshop.h"

#include "result_cache.h"

#include <utility>

namespace foredraw::cli {

Workshop::Workshop(const Arguments& arguments, const Registry& registry, const Executor& executor, Pipeline read,
                   SceneInput input)
    : pipeline(std::move(read)),
      how(std::move(input)),
      lender(how),
      job{arguments, pipeline, registry, executor, lender} {
  job.lent = how.files;
}

Workshop::~Workshop() = default;

std::unique_ptr<Workshop> Workshop::opened(const Arguments& arguments, const Registry& registry,
                                           const Executor& executor, Diagnostics& diagnostics) {
  auto pipeline = one_pipeline(arguments, registry, diagnostics);
  if (!pipeline) return nullptr;
  SceneInput how = input_of(arguments, registry);
  how.files = std::make_shared<FilesRead>();
  std::unique_ptr<Workshop> workshop(new Workshop(arguments, registry, executor, std::move(*pipeline), how));
  if (!is_sound(workshop->pipeline, registry, workshop->lender, diagnostics)) return nullptr;
  workshop->job.pipeline_files = files_of(arguments, workshop->pipeline, registry);
  if (!arguments.cache.empty()) {
    workshop->cache = ResultCache::opened(arguments, workshop->pipeline, registry, diagnostics);
    if (!workshop->cache) return nullptr;
    workshop->job.cache = workshop->cache.get();
  }
  return workshop;
}

}  // namespace foredraw::cli
