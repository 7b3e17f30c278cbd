#pragma once
#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace foredraw {

/// A process that this one began. It ends with its handle, but not with the copies of it that forks of this one have.
class WatchedProcess {
 public:
  /// `descriptors` become its 3, 4 and so on. Its standard streams lead nowhere, and it begins with no signal blocked
  /// or ignored. Throws std::system_error.
  WatchedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                 std::span<const int> descriptors);
  WatchedProcess(const WatchedProcess&) = delete;
  WatchedProcess& operator=(const WatchedProcess&) = delete;
  ~WatchedProcess();

  /// Whether it ended, once it has or the time is over.
  bool ended_within(std::chrono::milliseconds time);
  /// Asks it to end (SIGTERM). The destructor does, too, waits for two seconds, then kills it.
  void ask_to_end();
  /// Whether this process began it, and no other one of which this is a fork.
  bool is_ours() const;

 private:
  int owner_;
  int pid_ = -1;
  bool has_ended_ = false;
};

/// Of this process, for who watches it.
int process_number();

}  // namespace foredraw
