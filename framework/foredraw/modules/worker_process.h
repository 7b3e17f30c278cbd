#pragma once
#include <foredraw/modules/packed_call.h>
#include <foredraw/platform/shared_block.h>
#include <foredraw/platform/watched_process.h>

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace foredraw {

/// What a module may take.
struct ModuleLimits {
  double seconds = 600;                           ///< of a call; to load, 5 at least and 60 at most
  std::uint64_t memory = std::uint64_t{2} << 30;  ///< bytes of a worker; 0: any number
  std::filesystem::path worker = {};              ///< the program foredraw-module; empty: looked for
};

/// What a worker throws that gave no answer and lives no more.
struct WorkerEnded : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A process that has loaded a module. It and all that comes of it ends with its handle.
class WorkerProcess {
 public:
  /// With blocks for questions of so many bytes and answers of so many numbers. Throws WorkerEnded, where the module
  /// was the end of it, std::invalid_argument, where it is none, std::system_error, where no process can be begun.
  WorkerProcess(const std::filesystem::path& module, const ModuleLimits& limits, std::size_t question_bytes,
                std::size_t numbers);

  bool is_ours() const { return process_.is_ours(); }
  bool has_room_for(std::size_t question_bytes, std::size_t numbers) const;
  /// What the module wrote down of itself, at first.
  std::string tables() const;

  struct Answer {
    int status = 0;
    std::uint64_t count = 0;
    std::uint64_t vertex_count = 0;
    std::string said;  ///< messages for its host, as bytes
    std::uint64_t left_out = 0;
  };
  /// Copies of what it answered: the numbers to `answer`, where there is room for those of the question. `host` is
  /// asked meanwhile whether the call is cancelled, and for overdraw. Throws WorkerEnded; afterwards it is of no more
  /// use.
  Answer ask(const ForeignQuestion& question, const foredraw_host& host, const foredraw_answer& answer);
  /// As the destructor, without waiting for the end.
  void begin_to_end() { process_.ask_to_end(); }

 private:
  using Clock = std::chrono::steady_clock;

  /// Until the worker has something for the program.
  void wait_for_turn(Clock::time_point begin, double seconds, const foredraw_host* host);
  void count_overdraw(const ForeignQuestion& question, const foredraw_host& host);
  std::string how_it_ended() const;

  double seconds_;
  std::uint64_t memory_;
  SharedBlock asked_, answered_;
  WatchedProcess process_;
};

/// Where the program foredraw-module is: FOREDRAW_MODULE_WORKER, by the program that runs, or in its installation.
std::filesystem::path module_worker();

}  // namespace foredraw
