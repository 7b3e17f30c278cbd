#pragma once
#include <atomic>
#include <cstdint>

namespace foredraw {

/// A number in a SharedBlock that processes wait on.
using SharedWord = std::atomic<std::uint32_t>;
static_assert(SharedWord::is_always_lock_free && sizeof(SharedWord) == sizeof(std::uint32_t));

/// Sleeps while it has that value, until somebody wakes those who wait on it, or for so many milliseconds. May return
/// early.
void wait_while(const SharedWord& word, std::uint32_t value, int milliseconds);

/// Sets it, and wakes all who wait on it in any process.
void set_and_wake(SharedWord& word, std::uint32_t value);

/// The same where it has that value; else it stays, and nobody is woken.
void replace_and_wake(SharedWord& word, std::uint32_t value, std::uint32_t with);

}  // namespace foredraw
