#include <foredraw/platform/memory.h>

#include <sys/resource.h>

namespace foredraw {

std::uint64_t peak_memory() {
  struct rusage usage {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace foredraw
