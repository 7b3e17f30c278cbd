// The worker: a process that loads a module, and answers the calls of the program that began it. That program starts
// it by itself; there is nothing here to be typed.
#include <foredraw/modules/serve.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace {

template <class Number>
bool read(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, number).ptr == end;
}

/// Sanitizers map terabytes, and get no memory below any limit.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_limits = false;
#elif defined(__has_feature)
constexpr bool has_limits = !__has_feature(address_sanitizer) && !__has_feature(thread_sanitizer);
#else
constexpr bool has_limits = true;
#endif

}  // namespace

int main(int argc, char** argv) {
  int parent = 0;
  std::uint64_t memory = 0;
  if (argc != 4 || !read(argv[1], parent) || !read(argv[2], memory)) {
    std::fputs("foredraw-module: foredraw starts this program where --module names a module\n", stderr);
    return 1;
  }
  return foredraw::serve_watched(argv[3], parent, has_limits ? memory : 0);
}
