#pragma once
// Keeps the outputs of a folder up to date while people work in it.

#include "folder_outputs.h"
#include "scene_folder.h"
#include "settling.h"
#include "workshop.h"

#include <foredraw/platform/interruption.h>

#include <deque>
#include <map>
#include <set>

namespace foredraw::cli {

class WatchedFolder {
 public:
  /// `out` is there.
  WatchedFolder(const WatchArguments& arguments, const Registry& registry, const std::string& out,
                std::unique_ptr<Workshop> workshop, const Executor& executor);

  /// All files that are there at first, then each that changes, and those that depend on it. Returns when it is
  /// interrupted, or when the folder is gone.
  Exit keep_up();

 private:
  using Clock = Settling::Clock;
  /// Which other file is the reason (" (rock.bin changed)"), or "": the scene itself is. Nothing: it is only looked at.
  using Reason = std::optional<std::string>;
  using Due = std::map<std::string, Reason>;  ///< by the scene

  void look_at_all();
  void poll();
  void rest() const;
  std::optional<Settling::Seen> seen() const;
  bool is_left_out(const std::filesystem::path& folder) const;
  void take(const std::vector<std::string>& settled);
  void take_gone(const std::string& file);
  bool is_of_the_pipeline(const std::string& file) const;
  void open_again();
  Due next_due();
  void run(const Due& due);
  bool has_place_for(const std::string& scene, const std::filesystem::path& output);
  void tell_run(const std::string& scene, const Reason& why, const FileRun& run, bool is_new, double seconds);
  void remember(const std::string& scene, const FileRun& run);
  void look_beside(const std::string& file);
  std::string name_of(const std::string& file) const;
  void say(const std::string& line) const;

  const WatchArguments& arguments_;
  const Registry& registry_;
  const Executor& executor_;
  const Interruption& interruption_;
  std::string from_;  ///< as are all paths here: absolute and without "..", so that each file has one name
  std::filesystem::path out_;
  std::unique_ptr<Workshop> workshop_;
  std::set<std::string> beside_;  ///< files outside of the folder that outputs depend on, there or not
  Settling settling_;
  Clock::time_point next_poll_;
  std::map<std::string, std::set<std::string>>
      files_of_;                                         ///< that a scene was made from, or would be if they were there
  std::map<std::filesystem::path, std::string> makers_;  ///< which scene is written there
  Due due_;
  std::deque<std::string> backlog_;  ///< scenes to look at when nothing else is due
  std::size_t backlog_size_ = 0;
  bool has_to_open_ = false;
};

}  // namespace foredraw::cli
