#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

namespace foredraw {

/// Stops the fuzzer where a claim does not hold; what it then writes down is the input.
inline void claim(bool holds, const std::string& otherwise) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", otherwise.c_str());
  std::abort();
}

}  // namespace foredraw
