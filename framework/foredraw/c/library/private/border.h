#pragma once
// The border to C: texts that go out, and exceptions that do not.

#include <foredraw/base/diagnostics.h>
#include <foredraw/c/foredraw.h>

#include <exception>
#include <new>
#include <string>
#include <string_view>

namespace foredraw::c {

/// Hands the text over, to be freed by the caller. Nothing happens where `to` is NULL.
void put(std::string_view text, foredraw_text* to);

/// The same of what make() answers, which nobody asks for where `to` is NULL.
template <class Make>
void put_made(Make make, foredraw_text* to) {
  if (to != nullptr) put(make(), to);
}

/// The same of {"diagnostics": [...]}.
void put(const Diagnostics& diagnostics, foredraw_text* to);

/// Calls work(), which returns a status and may set `text`. What it throws becomes a status; memory that ran out leaves
/// no text, anything else says in it what happened.
template <class Work>
int at_border(foredraw_text* text, Work work) noexcept {
  try {
    if (text != nullptr) *text = {nullptr, 0};
    try {
      return work();
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception& problem) {
      Diagnostics diagnostics;
      diagnostics.error({}, "unexpected", problem.what());
      put(diagnostics, text);
      return FOREDRAW_FAILED;
    }
  } catch (...) {
    return FOREDRAW_NO_MEMORY;
  }
}

}  // namespace foredraw::c
