#include "settling.h"

namespace foredraw::cli {

namespace {

constexpr int patience = 10;

}  // namespace

void Settling::look(Seen seen, Clock::time_point now) {
  for (const auto& [file, facts] : seen) {
    const auto before = seen_.find(file);
    if (before == seen_.end() || before->second != facts) changed(file, now);
  }
  for (const auto& [file, facts] : seen_) {
    if (!seen.contains(file)) changed(file, now);
  }
  seen_ = std::move(seen);
}

void Settling::changed(const std::string& file, Clock::time_point now) {
  waiting_.try_emplace(file, Waiting{now, now}).first->second.last = now;
  last_ = now;
}

bool Settling::is_quiet(const Waiting& waiting, Clock::time_point now) const {
  return now - last_ >= quiet_ || (now - waiting.last >= quiet_ && now - waiting.first >= patience * quiet_);
}

std::vector<std::string> Settling::settled(Clock::time_point now, const IsOpen& is_open) {
  std::vector<std::string> files;
  for (auto at = waiting_.begin(); at != waiting_.end();) {
    const bool may_be_taken = is_quiet(at->second, now) && !is_open(at->first);
    if (may_be_taken) files.push_back(at->first);
    at = may_be_taken ? waiting_.erase(at) : std::next(at);
  }
  return files;
}

}  // namespace foredraw::cli
