#pragma once
// Files that changed, until they are left alone: programs write a file in several steps, and several files that belong
// together one after the other.

#include <chrono>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace foredraw::cli {

class Settling {
 public:
  using Clock = std::chrono::steady_clock;
  /// Whether somebody has the file open to write; nothing: unknown.
  using IsOpen = std::function<std::optional<bool>(const std::filesystem::path&)>;

  /// Files have settled once nothing has changed for so long, or, where something always does, they themselves have not
  /// while ten times as long went by.
  explicit Settling(Clock::duration quiet) : quiet_(quiet) {}

  /// `is_whole`: whoever wrote it has closed it, or it is gone.
  void changed(const std::filesystem::path& file, bool is_whole, Clock::time_point now);

  /// Those that have settled and are whole, sorted; they are forgotten here. One that is still being written stays
  /// until it is closed.
  std::vector<std::filesystem::path> settled(Clock::time_point now, const IsOpen& is_open);

  bool waits_for(const std::filesystem::path& file) const { return waiting_.contains(file); }

  /// When it is worth to ask again, unless something changes; nothing: not before.
  std::optional<Clock::time_point> next(Clock::time_point now) const;

 private:
  struct Waiting {
    Clock::time_point first, last;
    bool is_whole = false;
  };

  bool is_quiet(const Waiting& waiting, Clock::time_point now) const;

  Clock::duration quiet_;
  Clock::time_point last_;
  std::map<std::filesystem::path, Waiting> waiting_;
};

}  // namespace foredraw::cli
