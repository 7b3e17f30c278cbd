#include <foredraw/platform/memory.h>
#include <foredraw/platform/supervised.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace foredraw {

namespace {

/// The end of a pipe from which what was written last is kept.
class LastWords {
 public:
  explicit LastWords(int from) : from_(from) {}

  void read() {
    std::array<char, 4096> piece{};
    for (ssize_t count = 0; (count = ::read(from_, piece.data(), piece.size())) > 0;) {
      words_.append(piece.data(), static_cast<std::size_t>(count));
      if (words_.size() > most) words_.erase(0, words_.size() - most);
    }
  }
  const std::string& words() const { return words_; }

 private:
  static constexpr std::size_t most = 4096;
  int from_;
  std::string words_;
};

/// The numbers of this process's children, from its one thread.
std::vector<pid_t> children() {
  std::vector<pid_t> found;
  std::error_code error;
  const std::string self = std::to_string(::getpid());
  if (std::ifstream list("/proc/self/task/" + self + "/children"); list) {
    for (pid_t pid = 0; list >> pid;) found.push_back(pid);
    return found;
  }
  // A kernel that keeps no such list: whoever names us as parent.
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    const std::string name = entry.path().filename().string();
    pid_t pid = 0;
    if (std::from_chars(name.data(), name.data() + name.size(), pid).ec != std::errc()) continue;
    std::ifstream file(entry.path() / "stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::size_t behind_name = text.rfind(')');  // "12 (a name) S 1 ..."
    if (behind_name != std::string::npos && text.compare(behind_name + 4, self.size() + 1, self + ' ') == 0) {
      found.push_back(pid);
    }
  }
  return found;
}

/// Children of who ends become ours, so that nobody is left when this has none. Each round ends a generation.
void end_all_below() {
  for (int round = 0; round < 1000; ++round) {
    if (::waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
    for (const pid_t pid : children()) ::kill(pid, SIGKILL);
    while (::waitpid(-1, nullptr, WNOHANG) > 0) {
    }
    ::usleep(200);
  }
}

void close_from(int descriptor) { ::syscall(SYS_close_range, static_cast<unsigned>(descriptor), ~0u, 0u); }

[[noreturn]] void be_the_child(const std::function<void()>& work, pid_t parent, std::uint64_t memory,
                               int standard_error, int descriptors) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  ::dup2(standard_error, 2);
  close_from(descriptors);
  // 1, not 0: a core of 0 bytes is still handed to a program that collects them.
  const rlimit no_core{1, 1};
  ::setrlimit(RLIMIT_CORE, &no_core);
  if (memory != 0) limit_memory(memory);
  work();
  ::_exit(0);
}

/// What became of the child; nothing while it lives.
std::optional<ProcessEnd> end_of(pid_t child) {
  int status = 0;
  rusage usage{};
  if (::wait4(child, &status, WNOHANG | WUNTRACED, &usage) != child) return std::nullopt;
  ProcessEnd end;
  end.by_signal = !WIFEXITED(status);
  end.code = WIFEXITED(status) ? WEXITSTATUS(status) : WIFSTOPPED(status) ? WSTOPSIG(status) : WTERMSIG(status);
  end.peak_memory = static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
  return end;
}

}  // namespace

std::optional<ProcessEnd> supervised(const std::function<void()>& work, int parent, std::uint64_t memory,
                                     int descriptors) {
  ::setsid();
  ::prctl(PR_SET_CHILD_SUBREAPER, 1);
  close_from(descriptors);
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGCHLD, SIGTERM, SIGINT, SIGHUP}) ::sigaddset(&signals, signal);
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  const int signalled = ::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
  const int parent_ended = static_cast<int>(::syscall(SYS_pidfd_open, parent, 0));
  if (::getppid() != parent) return std::nullopt;
  std::array<int, 2> standard_error{};
  if (::pipe2(standard_error.data(), O_CLOEXEC) != 0) return std::nullopt;
  ::fcntl(standard_error[0], F_SETFL, O_NONBLOCK);
  const pid_t self = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) return std::nullopt;
  if (child == 0) be_the_child(work, self, memory, standard_error[1], descriptors);
  ::close(standard_error[1]);

  LastWords words(standard_error[0]);
  std::array<pollfd, 3> events{{{signalled, POLLIN, 0}, {standard_error[0], POLLIN, 0}, {parent_ended, POLLIN, 0}}};
  std::optional<ProcessEnd> end;
  for (bool is_asked_to_end = false; !end && !is_asked_to_end;) {
    if (::poll(events.data(), events.size(), -1) < 0 && errno != EINTR) break;
    words.read();
    if ((events[1].revents & (POLLHUP | POLLIN)) == POLLHUP) events[1].fd = -1;  // closed by all who had it
    for (signalfd_siginfo what{}; ::read(signalled, &what, sizeof what) == sizeof what;) {
      is_asked_to_end = is_asked_to_end || what.ssi_signo != SIGCHLD;
    }
    if (events[2].revents != 0) is_asked_to_end = true;
    end = end_of(child);
  }
  end_all_below();
  words.read();
  if (end) end->last_words = words.words();
  return end;
}

void become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  ::execvp(program.c_str(), words.data());
}

std::string signal_name(int signal) {
#if defined(__GLIBC__) && (__GLIBC__ > 2 || __GLIBC_MINOR__ >= 32)
  if (const char* name = ::sigabbrev_np(signal)) return std::string("SIG") + name;
#endif
  return "signal " + std::to_string(signal);
}

}  // namespace foredraw
