#include <foredraw/platform/interruption.h>

#include <poll.h>
#include <pthread.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

namespace foredraw {

namespace {

sigset_t endings() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction is {};
    if (::sigaction(signal, nullptr, &is) == 0 && is.sa_handler != SIG_IGN) ::sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

void Interruption::hold() {
  const sigset_t signals = endings();
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

Interruption::Interruption() {
  hold();
  const sigset_t signals = endings();
  enough_ = ::eventfd(0, EFD_CLOEXEC);
  signals_ = ::signalfd(-1, &signals, SFD_CLOEXEC | SFD_NONBLOCK);
  if (enough_ < 0 || signals_ < 0) {
    const int error = errno;
    for (const int opened : {enough_, signals_}) ::close(opened);
    throw std::system_error(error, std::generic_category(), "Ctrl-C can not be waited for");
  }
  waiting_ = std::thread([this] { wait_for_it(); });
}

Interruption::~Interruption() {
  const std::uint64_t once = 1;
  [[maybe_unused]] const ssize_t put = ::write(enough_, &once, sizeof once);
  waiting_.join();
  for (const int opened : {enough_, signals_}) ::close(opened);
}

void Interruption::end_process() const {
  const int signal = signal_;
  ::signal(signal, SIG_DFL);
  sigset_t alone;
  ::sigemptyset(&alone);
  ::sigaddset(&alone, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &alone, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);
}

void Interruption::wait_for_it() {
  std::array<pollfd, 2> events{{{signals_, POLLIN, 0}, {enough_, POLLIN, 0}}};
  while (events[0].revents == 0 && events[1].revents == 0) {
    if (::poll(events.data(), events.size(), -1) < 0 && errno != EINTR) return;
  }
  signalfd_siginfo first{};
  if (::read(signals_, &first, sizeof first) != sizeof first) return;
  signal_ = static_cast<int>(first.ssi_signo);
  came_ = true;
  // This thread alone takes the second one, as if nobody had asked for the first.
  const sigset_t signals = endings();
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
  events[0].fd = -1;
  while (::poll(events.data(), events.size(), -1) < 0 && errno == EINTR) {
  }
}

}  // namespace foredraw
