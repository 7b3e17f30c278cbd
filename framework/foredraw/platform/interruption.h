#pragma once
#include <atomic>
#include <thread>

namespace foredraw {

/// Ctrl-C, SIGTERM and SIGHUP for a program that goes on until it is ended, and ends in good order: the first one is
/// told, a second one ends the process at once, as usual. What whoever began the process has it ignore stays ignored.
class Interruption {
 public:
  /// Keeps them from ending this thread, and the threads that it begins from here on. Call it before any are begun: a
  /// thread that was there before would still end the process.
  static void hold();

  /// What is held is told from here on. Throws std::system_error.
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// Becomes true, from another thread.
  const std::atomic<bool>& came() const { return came_; }

  /// Ends the process by the signal that came, as if it had not been held: a shell sees 128 and its number (130 of
  /// Ctrl-C), and ends its loops. Destructors that are due have run before.
  [[noreturn]] void end_process() const;

 private:
  void wait_for_it();

  std::atomic<bool> came_ = false;
  std::atomic<int> signal_ = 0;  ///< the first one, once it came
  int enough_ = -1;              ///< readable when nobody asks any more
  int signals_ = -1;
  std::thread waiting_;
};

}  // namespace foredraw
