#pragma once
#include <foredraw/modules/foreign_runner.h>
#include <foredraw/modules/worker_process.h>

#include <memory>
#include <mutex>
#include <vector>

namespace foredraw {

/// The workers of a module: as many as calls are made at once. Each call costs one of them at most.
class ModuleWorkers {
 public:
  ModuleWorkers(std::filesystem::path module, ModuleLimits limits)
      : module_(std::move(module)), limits_(std::move(limits)) {}
  ~ModuleWorkers() { rest(); }
  ModuleWorkers(const ModuleWorkers&) = delete;
  ModuleWorkers& operator=(const ModuleWorkers&) = delete;

  /// What the module wrote down of itself. Throws as WorkerProcess does.
  std::string tables();
  /// Throws std::runtime_error where there is no answer. After three workers that ended the module is left out.
  WorkerProcess::Answer ask(const ForeignQuestion& question, const foredraw_host& host, const foredraw_answer& answer);
  /// Ends those who have nothing to do. The next call begins others.
  void rest();

 private:
  std::unique_ptr<WorkerProcess> worker_for(std::size_t question_bytes, std::size_t numbers);

  std::filesystem::path module_;
  ModuleLimits limits_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<WorkerProcess>> idle_;
  int deaths_ = 0;
};

/// A technique of a module, run by its workers.
class RunsApart final : public ForeignRunner {
 public:
  /// `may_count`: whether it asks for overdraw.
  RunsApart(std::shared_ptr<ModuleWorkers> workers, std::uint32_t plugin, bool may_count)
      : workers_(std::move(workers)), plugin_(plugin), may_count_(may_count) {}
  int run(const foredraw_draw& draw, std::span<const foredraw_value> options, foredraw_answer& answer,
          const foredraw_host& host) const override;

 private:
  std::shared_ptr<ModuleWorkers> workers_;
  std::uint32_t plugin_;
  bool may_count_;
};

}  // namespace foredraw
