#include <foredraw/platform/watched_process.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

extern "C" char** environ;

namespace foredraw {

WatchedProcess::WatchedProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                               std::span<const int> descriptors)
    : owner_(::getpid()) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  for (const int stream : {0, 1, 2}) {
    ::posix_spawn_file_actions_addopen(&actions, stream, "/dev/null", stream == 0 ? O_RDONLY : O_WRONLY, 0);
  }
  int number = 3;
  for (const int descriptor : descriptors) ::posix_spawn_file_actions_adddup2(&actions, descriptor, number++);
  sigset_t none, all;
  ::sigemptyset(&none);
  ::sigfillset(&all);
  ::posix_spawnattr_setsigmask(&attributes, &none);
  ::posix_spawnattr_setsigdefault(&attributes, &all);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF);

  const std::string path = program.string();
  std::vector<char*> words{const_cast<char*>(path.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  pid_t pid = -1;
  const int error = ::posix_spawn(&pid, path.c_str(), &actions, &attributes, words.data(), environ);
  ::posix_spawn_file_actions_destroy(&actions);
  ::posix_spawnattr_destroy(&attributes);
  if (error != 0) throw std::system_error(error, std::generic_category(), path + " can not be run");
  pid_ = pid;
}

bool WatchedProcess::ended_within(std::chrono::milliseconds time) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + time;
  while (!has_ended_) {
    const int found = ::waitpid(pid_, nullptr, WNOHANG);
    // Somebody else in this process may wait for all children: then it ended, and nobody is left to ask.
    has_ended_ = found == pid_ || (found < 0 && errno == ECHILD);
    if (has_ended_ || Clock::now() >= end) break;
    ::usleep(500);
  }
  return has_ended_;
}

void WatchedProcess::ask_to_end() {
  if (!has_ended_ && is_ours()) ::kill(pid_, SIGTERM);
}

bool WatchedProcess::is_ours() const { return owner_ == ::getpid(); }

WatchedProcess::~WatchedProcess() {
  using namespace std::chrono_literals;
  if (!is_ours()) return;
  ask_to_end();
  if (ended_within(2s)) return;
  ::kill(pid_, SIGKILL);
  ended_within(2s);
}

int process_number() { return ::getpid(); }

}  // namespace foredraw
