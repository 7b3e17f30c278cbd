#include "settling.h"

#include <algorithm>

namespace foredraw::cli {

namespace {

constexpr int patience = 10;

}  // namespace

void Settling::changed(const std::filesystem::path& file, bool is_whole, Clock::time_point now) {
  Waiting& waiting = waiting_.try_emplace(file, Waiting{now, now}).first->second;
  waiting.last = now;
  waiting.is_whole = is_whole;
  last_ = now;
}

bool Settling::is_quiet(const Waiting& waiting, Clock::time_point now) const {
  return now - last_ >= quiet_ || (now - waiting.last >= quiet_ && now - waiting.first >= patience * quiet_);
}

std::vector<std::filesystem::path> Settling::settled(Clock::time_point now, const IsOpen& is_open) {
  std::vector<std::filesystem::path> files;
  for (auto at = waiting_.begin(); at != waiting_.end();) {
    const bool may_be_taken = is_quiet(at->second, now) && !is_open(at->first).value_or(!at->second.is_whole);
    if (may_be_taken) files.push_back(at->first);
    at = may_be_taken ? waiting_.erase(at) : std::next(at);
  }
  return files;
}

std::optional<Settling::Clock::time_point> Settling::next(Clock::time_point now) const {
  if (waiting_.empty()) return std::nullopt;
  // Who is past its time is being written. Its end is told; but where it is not, as with a file that was mapped, it is
  // looked for.
  return last_ + quiet_ > now ? last_ + quiet_ : now + quiet_;
}

}  // namespace foredraw::cli
