#pragma once
// What the handles of foredraw.h are.

#include <foredraw/base/parallel.h>
#include <foredraw/c/foredraw.h>
#include <foredraw/job/job.h>
#include <foredraw/scene/scene.h>
#include <foredraw/technique/registry.h>

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

struct foredraw_context {
  explicit foredraw_context(const foredraw_settings& given);

  foredraw::SceneInput input() const { return {registry.products(), false, {}, executor}; }

  foredraw_settings settings;
  foredraw::Registry registry;
  foredraw::Executor executor;

  std::mutex mutex;
  std::set<std::atomic<bool>*> running;  ///< what foredraw_cancel() sets
};

namespace foredraw::c {

/// A call that foredraw_cancel() may end, for as long as this lives.
class Cancellable {
 public:
  explicit Cancellable(foredraw_context& context);
  ~Cancellable();
  Cancellable(const Cancellable&) = delete;
  Cancellable& operator=(const Cancellable&) = delete;

  foredraw_context& context() { return context_; }
  const std::atomic<bool>& is_cancelled() const { return is_cancelled_; }
  /// Tells the caller, who may end it.
  std::function<void(std::string_view, double)> progress();

 private:
  foredraw_context& context_;
  std::atomic<bool> is_cancelled_ = false;
};

/// The setup of a job that the call runs. The call and the lender outlive it.
JobSetup setup_for(Cancellable& call, const Lender& lender);

/// A scene, the file that it was first read from, and what was decoded of it for callers.
struct HeldScene {
  HeldScene(Scene held, FileRecord from, OutputSettings as = {})
      : scene(std::move(held)), file(std::move(from)), output(as), lent(scene.draws.size()) {}

  struct Lent {
    std::once_flag once;
    std::vector<glm::vec3> positions;
    std::vector<foredraw_stream> streams;
  };

  const Scene scene;
  const FileRecord file;           ///< its path is empty for a scene in memory
  const OutputSettings output;     ///< of the pipeline that made it
  mutable std::vector<Lent> lent;  ///< [draw]
};

}  // namespace foredraw::c

struct foredraw_scene {
  std::shared_ptr<const foredraw::c::HeldScene> held;
};
