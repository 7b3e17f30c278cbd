// The worker: a process that loads a module, and answers the calls of the program that began it. That program starts
// it by itself; there is nothing here to be typed.
#include <foredraw/modules/serve.h>

#include <charconv>
#include <cstdio>
#include <cstring>

namespace {

template <class Number>
bool read(const char* text, Number& number) {
  const char* end = text + std::strlen(text);
  return std::from_chars(text, end, number).ptr == end;
}

}  // namespace

int main(int argc, char** argv) {
  int parent = 0;
  std::uint64_t memory = 0;
  if (argc != 4 || !read(argv[1], parent) || !read(argv[2], memory)) {
    std::fputs("foredraw-module: foredraw starts this program where --module names a module\n", stderr);
    return 1;
  }
  return foredraw::serve_watched(argv[3], parent, memory);
}
