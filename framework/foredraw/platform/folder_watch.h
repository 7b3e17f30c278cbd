#pragma once
#include <foredraw/base/diagnostics.h>

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

namespace foredraw {

/// What changes in a folder and all folders below it, as the system tells it (inotify): what this machine does there,
/// not what another one does on a disk that both share. Links to folders are not followed.
class FolderWatch {
 public:
  enum class What {
    begun,   ///< a file was made or written to, and may not be whole yet
    closed,  ///< a file was closed by who wrote it, or came here whole
    gone,    ///< a file was removed or went elsewhere, or a folder with all that it held
    missed,  ///< more happened than the system remembers: anything may have changed. No path
  };
  struct Change {
    What what;
    std::filesystem::path path;  ///< the folder's own path as it was given, and the way from there
  };

  /// Folders in `except`, there already, are left out with all that they hold. Throws std::system_error where the
  /// system gives nobody a watch any more: its code says why.
  FolderWatch(const std::filesystem::path& folder, std::vector<std::filesystem::path> except);
  FolderWatch(const FolderWatch&) = delete;
  FolderWatch& operator=(const FolderWatch&) = delete;
  ~FolderWatch();

  /// The folder that a file lies in, for the sake of that file, unless it is watched anyway. Only what lies in it
  /// directly is told; by this path.
  void watch_beside(const std::filesystem::path& file);

  /// Waits until something changed, `at_most` is over (nothing: never), or there is something to read in `waker`; then
  /// everything that is known by now. Files that were in a folder when it came are told as made (What::begun).
  std::vector<Change> next(std::optional<std::chrono::milliseconds> at_most, int waker);

  /// Whether the folder itself was removed or went elsewhere: nothing more comes.
  bool is_over() const { return is_over_; }
  std::size_t folders() const { return watched_.size(); }

  /// Folders that could not be watched since somebody asked last, with what to do about it.
  Diagnostics problems();

 private:
  struct Watched {
    std::vector<std::filesystem::path> names;  ///< by which it was asked for
    bool is_below = false;                     ///< the folder itself or below it, and not for the sake of a file
  };

  void add_tree(const std::filesystem::path& folder, std::vector<Change>& found);
  int add(const std::filesystem::path& folder, bool is_below);  ///< its errno, or 0
  bool is_left_out(const std::filesystem::path& folder) const;
  void forget_tree(const std::filesystem::path& folder);
  void take(std::uint32_t what, int number, const std::filesystem::path& name, std::vector<Change>& changes);
  void tell(const std::filesystem::path& folder, int error);

  std::filesystem::path root_;
  std::vector<std::filesystem::path> except_;
  int inotify_ = -1;
  std::map<int, Watched> watched_;
  bool is_over_ = false;
  bool has_told_limit_ = false;
  Diagnostics problems_;
};

/// What to tell where the constructor throws.
void tell_cannot_watch(const std::filesystem::path& folder, int error, Diagnostics& diagnostics);

/// Whether somebody has the file open to write to it. Nothing where this system does not tell, as of the files of
/// others.
std::optional<bool> is_open_for_writing(const std::filesystem::path& file);

}  // namespace foredraw
