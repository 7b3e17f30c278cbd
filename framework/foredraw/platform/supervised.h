#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace foredraw {

/// How a process ended.
struct ProcessEnd {
  bool by_signal = false;         ///< or it was stopped by one
  int code = 0;                   ///< of the signal, or what it exited with
  std::uint64_t peak_memory = 0;  ///< bytes
  std::string last_words;         ///< the last of what it wrote to standard error, up to 4096 bytes
};

/// Does the work in a child of this process, and waits for its end. The child and all that comes of it have ended
/// afterwards, whatever they did to get away, and nothing comes of them where this process is killed. The child has
/// neither a terminal nor output but standard error, which is kept; it leaves no core, and may hold so many bytes of
/// data (0: any number).
/// Nothing is returned where `parent`, the process that began this one, ended, or SIGTERM came.
/// This process does nothing else; it keeps the first `descriptors` of its descriptors and closes the others.
std::optional<ProcessEnd> supervised(const std::function<void()>& work, int parent, std::uint64_t memory,
                                     int descriptors);

/// Becomes another program, looked for in PATH. Returns where there is none.
void become(const std::string& program, const std::vector<std::string>& arguments);

/// "SIGSEGV"; "signal 64" where it has no name.
std::string signal_name(int signal);

}  // namespace foredraw
