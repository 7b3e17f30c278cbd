#include <foredraw/platform/memory.h>

#include <sys/resource.h>

#include <algorithm>
#include <fstream>
#include <string>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace foredraw {

namespace {

/// "VmHWM:  12345 kB" of /proc/self/status, in bytes.
std::optional<std::uint64_t> status_of(std::string_view name) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == name && status >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

bool begin_peak_anew() {
  std::ofstream clear("/proc/self/clear_refs");
  clear << '5' << std::flush;  // proc(5): the peak resident set size
  return clear.good();
}

}  // namespace

std::uint64_t peak_memory() {
  if (const auto peak = status_of("VmHWM:")) return *peak;
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

MemoryWatch::MemoryWatch() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
  if (begin_peak_anew()) at_first_ = status_of("VmRSS:");
}

std::optional<std::uint64_t> MemoryWatch::growth() const {
  const auto peak = status_of("VmHWM:");
  if (!at_first_ || !peak) return std::nullopt;
  return *peak - std::min(*peak, *at_first_);
}

void keep_freed_memory() {
#if defined(__GLIBC__)
  ::mallopt(M_MMAP_THRESHOLD, 8 << 20);
  ::mallopt(M_TRIM_THRESHOLD, 256 << 20);
#endif
}

bool limit_memory(std::uint64_t bytes) {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return false;
  limit.rlim_cur = limit.rlim_max == RLIM_INFINITY ? bytes : std::min<rlim_t>(bytes, limit.rlim_max);
  return ::setrlimit(RLIMIT_DATA, &limit) == 0;
}

}  // namespace foredraw
