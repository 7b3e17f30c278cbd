#include <foredraw/platform/folder_watch.h>

#include <foredraw/platform/private/descriptor.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <utility>

namespace foredraw {

namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t asked = IN_CREATE | IN_MODIFY | IN_CLOSE_WRITE | IN_MOVED_FROM | IN_MOVED_TO | IN_DELETE |
                                IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR | IN_EXCL_UNLINK;

std::string system_limit(const char* name) {
  std::ifstream file(std::string("/proc/sys/fs/inotify/") + name);
  std::string limit;
  file >> limit;
  return limit;
}

/// A link, or a further name of a file that is there: nobody will close it.
bool is_a_link(const fs::path& file) {
  struct stat status {};
  return ::lstat(file.c_str(), &status) == 0 && (S_ISLNK(status.st_mode) || status.st_nlink > 1);
}

bool is_at_or_below(const fs::path& path, const fs::path& folder) {
  const auto [end, rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  return end == folder.end();
}

}  // namespace

FolderWatch::FolderWatch(const fs::path& folder, std::vector<fs::path> except)
    : root_(folder), except_(std::move(except)), inotify_(::inotify_init1(IN_CLOEXEC | IN_NONBLOCK)) {
  const auto give_up = [&](int error) {
    if (inotify_ >= 0) ::close(inotify_);
    throw std::system_error(error, std::generic_category(), folder.string() + " can not be watched");
  };
  if (inotify_ < 0) give_up(errno);
  if (const int error = add(root_, true)) give_up(error);
  std::vector<Change> found;  // who begins to watch looks at all of them anyway
  add_tree(root_, found);
}

FolderWatch::~FolderWatch() { ::close(inotify_); }

bool FolderWatch::is_left_out(const fs::path& folder) const {
  std::error_code error;
  return std::ranges::any_of(except_, [&](const fs::path& other) { return fs::equivalent(folder, other, error); });
}

int FolderWatch::add(const fs::path& folder, bool is_below) {
  const std::uint32_t how = asked | (is_below && folder != root_ ? IN_DONT_FOLLOW : 0);
  const int number = ::inotify_add_watch(inotify_, folder.c_str(), how);
  if (number < 0) return errno;
  Watched& watched = watched_[number];
  watched.is_below = watched.is_below || is_below;
  if (std::ranges::find(watched.names, folder) == watched.names.end()) watched.names.push_back(folder);
  return 0;
}

/// Each folder is watched before it is looked into: what comes meanwhile is told by one or the other.
void FolderWatch::add_tree(const fs::path& folder, std::vector<Change>& found) {
  if (is_left_out(folder)) return;
  if (const int error = add(folder, true); error != 0) {
    if (error != ENOENT && error != ENOTDIR) tell(folder, error);  // gone again
    return;
  }
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const fs::file_status status = at->symlink_status(gone);
    if (fs::is_directory(status)) {
      add_tree(at->path(), found);
    } else if (fs::exists(status)) {
      found.push_back({is_a_link(at->path()) ? What::closed : What::begun, at->path()});
    }
  }
}

void FolderWatch::watch_beside(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  if (is_left_out(folder)) return;
  const int error = add(folder, false);
  if (error != 0 && error != ENOENT && error != ENOTDIR) tell(folder, error);
}

void FolderWatch::forget_tree(const fs::path& folder) {
  for (auto at = watched_.begin(); at != watched_.end();) {
    std::erase_if(at->second.names, [&](const fs::path& name) { return is_at_or_below(name, folder); });
    if (!at->second.names.empty()) {
      ++at;
      continue;
    }
    ::inotify_rm_watch(inotify_, at->first);
    at = watched_.erase(at);
  }
}

void FolderWatch::take(std::uint32_t what, int number, const fs::path& name, std::vector<Change>& changes) {
  if ((what & IN_Q_OVERFLOW) != 0) {
    std::vector<Change> found;
    add_tree(root_, found);  // folders may have come meanwhile
    changes.push_back({What::missed, {}});
    return;
  }
  const auto at = watched_.find(number);
  if (at == watched_.end()) return;
  const Watched watched = at->second;
  if ((what & IN_IGNORED) != 0) watched_.erase(at);
  const bool is_root = watched.is_below && watched.names.front() == root_;
  if (is_root && (what & (IN_DELETE_SELF | IN_MOVE_SELF | IN_UNMOUNT)) != 0) is_over_ = true;
  if (name.empty()) return;  // its parent tells of it
  for (const fs::path& folder : watched.names) {
    const fs::path path = folder / name;
    if ((what & IN_ISDIR) != 0) {
      if ((what & (IN_DELETE | IN_MOVED_FROM)) != 0) {
        forget_tree(path);
        changes.push_back({What::gone, path});
      } else if ((what & (IN_CREATE | IN_MOVED_TO)) != 0 && watched.is_below) {
        add_tree(path, changes);
      }
    } else if ((what & (IN_CLOSE_WRITE | IN_MOVED_TO)) != 0) {
      changes.push_back({What::closed, path});
    } else if ((what & IN_CREATE) != 0) {
      changes.push_back({is_a_link(path) ? What::closed : What::begun, path});
    } else if ((what & IN_MODIFY) != 0) {
      if (changes.empty() || changes.back().what != What::begun || changes.back().path != path) {
        changes.push_back({What::begun, path});
      }
    } else if ((what & (IN_DELETE | IN_MOVED_FROM)) != 0) {
      changes.push_back({What::gone, path});
    }
  }
}

std::vector<FolderWatch::Change> FolderWatch::next(std::optional<std::chrono::milliseconds> at_most, int waker) {
  std::array<pollfd, 2> events{{{inotify_, POLLIN, 0}, {waker, POLLIN, 0}}};
  ::poll(events.data(), events.size(), at_most ? static_cast<int>(at_most->count()) : -1);
  std::vector<Change> changes;
  alignas(inotify_event) std::array<char, std::size_t{1} << 16> buffer{};
  for (ssize_t got = 0; (got = ::read(inotify_, buffer.data(), buffer.size())) > 0;) {
    for (ssize_t at = 0; at < got;) {
      inotify_event event{};
      std::memcpy(&event, buffer.data() + at, sizeof event);
      const char* name = buffer.data() + at + sizeof event;
      take(event.mask, event.wd, event.len > 0 ? fs::path(name) : fs::path(), changes);
      at += static_cast<ssize_t>(sizeof event + event.len);
    }
  }
  return changes;
}

Diagnostics FolderWatch::problems() { return std::exchange(problems_, {}); }

/// A limit is told once: what comes after it meets it too.
void FolderWatch::tell(const fs::path& folder, int error) {
  if (error == ENOSPC && std::exchange(has_told_limit_, true)) return;
  tell_cannot_watch(folder, error, problems_);
}

void tell_cannot_watch(const fs::path& folder, int error, Diagnostics& diagnostics) {
  const auto limit = [&](const char* name, const char* of_what) {
    diagnostics.error({.file = folder.string()}, "watch-limit",
                      std::string("cannot be watched: this system lets a user watch no more ") + of_what +
                          " at once (fs.inotify." + name + " is " + system_limit(name) + ')',
                      std::string("allow more, such as 'sudo sysctl fs.inotify.") + name +
                          "=524288', end other programs that watch, or watch a smaller folder");
  };
  if (error == ENOSPC) return limit("max_user_watches", "folders");
  if (error == EMFILE) return limit("max_user_instances", "trees of folders");
  diagnostics.error({.file = folder.string()}, "cannot-watch",
                    "cannot be watched: " + std::generic_category().message(error),
                    error == EACCES ? "check that you may read it" : "");
}

/// Linux lends a file to be read only where nobody has it open to write. The loan is given back at once; who asks for
/// the file in between waits that long, and the signal that asks for it back is one that does nothing.
std::optional<bool> is_open_for_writing(const fs::path& file) {
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (opened.get() < 0 || ::fcntl(opened.get(), F_SETSIG, SIGURG) != 0) return std::nullopt;
  if (::fcntl(opened.get(), F_SETLEASE, F_RDLCK) == 0) {
    ::fcntl(opened.get(), F_SETLEASE, F_UNLCK);
    return false;
  }
  return errno == EAGAIN ? std::optional(true) : std::nullopt;
}

}  // namespace foredraw
