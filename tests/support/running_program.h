#pragma once
// The program as it runs on its own: what it tells meanwhile, and how it ends when it is interrupted.

#include "support/process_time.h"
#include "support/program.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

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
    const bool is_told = comes_true([&] { return count(text) >= times; });
    EXPECT_TRUE(is_told) << "it is never told that " << text << ", but: " << told();
    return is_told;
  }
  int count(const std::string& text) const {
    const std::string all = told();
    int count = 0;
    for (std::size_t at = 0; (at = all.find(text, at)) != std::string::npos; at += text.size()) ++count;
    return count;
  }

  /// Seconds of a processor that it has used.
  double worked() const { return seconds_worked(std::to_string(process_)); }
  /// Until it has used so many: it has begun.
  void has_worked_for(double seconds) const {
    EXPECT_TRUE(comes_true([&] { return worked() >= seconds; }));
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
