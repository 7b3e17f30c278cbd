#pragma once
// The program as it runs on its own: what it tells meanwhile, and how it ends when it is interrupted.

#include "support/program.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

namespace foredraw::testing {

/// The program as it runs on its own, until it is ended. `before`: a command that runs the one behind it.
class Running {
 public:
  Running(const std::filesystem::path& folder, const std::string& arguments, const std::string& before = "")
      : log_(folder.string() + ".log") {
    std::filesystem::remove(log_);
    const std::string command = "cd '" + folder.string() + "' && exec " + before + " '" FOREDRAW_PROGRAM "' " +
                                arguments + " >'" + log_.string() + "' 2>&1 </dev/null";
    process_ = ::fork();
    if (process_ == 0) {
      for (const int signal : {SIGINT, SIGHUP}) ::signal(signal, SIG_DFL);  // a background of shells ignores them
      ::execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      ::_exit(127);
    }
  }
  ~Running() {
    if (process_ > 0) ::kill(process_, SIGKILL), ::waitpid(process_, nullptr, 0);
    std::filesystem::remove(log_);
  }

  std::string told() const { return content(log_); }

  /// Until it was told so many times.
  bool tells(const std::string& text, int times = 1) const {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (std::chrono::steady_clock::now() < end) {
      if (count(text) >= times) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    ADD_FAILURE() << "it is never told that " << text << ", but: " << told();
    return false;
  }
  int count(const std::string& text) const {
    const std::string all = told();
    int count = 0;
    for (std::size_t at = 0; (at = all.find(text, at)) != std::string::npos; at += text.size()) ++count;
    return count;
  }

  /// Until it has used so many seconds of a processor: it has begun.
  void has_worked_for(double seconds) const {
    const std::string file = "/proc/" + std::to_string(process_) + "/schedstat";
    for (int tries = 0; tries < 3000 && std::atof(content(file).c_str()) < 1e9 * seconds; ++tries) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
  }

  void interrupt(int signal = SIGINT) const { ::kill(process_, signal); }
  /// What it exits with; 128 and the signal's number where one ended it.
  int ended() {
    int status = 0;
    ::waitpid(process_, &status, 0);
    process_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  int end() {
    interrupt();
    return ended();
  }

 private:
  std::filesystem::path log_;
  pid_t process_ = -1;
};

}  // namespace foredraw::testing
