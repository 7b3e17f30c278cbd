#include "watched_folder.h"

#include <foredraw/base/counted.h>
#include <foredraw/base/printable.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/io/scene_kinds.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/platform/file_facts.h>

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <mutex>
#include <thread>

namespace foredraw::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t files_for_a_thread = 4;  ///< at once: whatever changes meanwhile waits for them
constexpr int rest_for_a_poll = 20;            ///< so many times as long as looking at all files took, at least

std::string one_name(const fs::path& path) {
  std::error_code error;
  std::string name = fs::absolute(path, error).lexically_normal().string();
  while (name.size() > 1 && name.ends_with('/')) name.pop_back();
  return name;
}

bool is_a_file(const std::string& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Of each evaluator the first figure that is a ratio: "vertex-cache acmr 1.6244 -> 1.0450".
std::string gains_of(const StoredReport& report) {
  std::string text;
  for (const auto& [evaluator, by_metric] : report.after.metrics.all()) {
    const auto first = std::ranges::find_if(
        by_metric, [](const auto& one) { return one.second.denominator && one.first.find('.') == std::string::npos; });
    if (first == by_metric.end()) continue;
    const auto bare = [](Figure figure) {
      figure.error = 0;
      return to_text(figure);
    };
    const Figure* before = report.before.metrics.find(evaluator, first->first);
    const std::string was = before != nullptr ? bare(*before) : "-", is = bare(first->second);
    text += fmt::format("; {} {} {}", evaluator, first->first, was == is ? is : was + " -> " + is);
  }
  return text;
}

}  // namespace

WatchedFolder::WatchedFolder(const WatchArguments& arguments, const Registry& registry, const std::string& out,
                             std::unique_ptr<Workshop> workshop, const Executor& executor)
    : arguments_(arguments),
      registry_(registry),
      executor_(executor),
      interruption_(*arguments.interruption),
      from_(one_name(arguments.inputs[0])),
      out_(out),
      workshop_(std::move(workshop)),
      settling_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(arguments.settle)),
                seen().value_or(Settling::Seen())) {
  for (const fs::path& file : workshop_->job.pipeline_files) look_beside(one_name(file));
}

std::string WatchedFolder::name_of(const std::string& file) const {
  return file.starts_with(from_ + '/') ? file.substr(from_.size() + 1) : file;
}

void WatchedFolder::say(const std::string& line) const {
  end_progress();
  fmt::print("{:%H:%M:%S} {}\n", fmt::localtime(std::time(nullptr)), line);
  std::fflush(stdout);
}

Exit WatchedFolder::keep_up() {
  look_at_all();
  while (!interruption_.came()) {
    if (!is_folder(from_)) {
      Diagnostics diagnostics;
      diagnostics.error({.file = arguments_.inputs[0]}, "folder-gone", "was removed or renamed while it was watched",
                        "begin again with the folder that is there now");
      return refuse_file(diagnostics);
    }
    if (Clock::now() >= next_poll_) poll();
    if (has_to_open_) open_again();
    const bool has_backlog = !backlog_.empty();
    const Due due = next_due();
    if (due.empty()) {
      rest();
    } else {
      run(due);
    }
    if (has_backlog && backlog_.empty() && !interruption_.came()) {
      say(fmt::format("{} up to date; waiting for changes, until Ctrl-C", counted(backlog_size_, "file")));
    }
  }
  say("ended");
  return done;
}

/// Everything that is there, when nothing else is to be done.
void WatchedFolder::look_at_all() {
  Diagnostics diagnostics;
  const auto scenes = scenes_below(from_, out_, scenes_for(workshop_->pipeline, registry_), diagnostics);
  const bool is_only_empty =
      std::ranges::any_of(diagnostics.all(), [](const auto& d) { return d.code == "no-scenes"; });
  if (!is_only_empty) tell(diagnostics);
  backlog_.clear();
  for (const fs::path& scene : scenes.value_or(std::vector<fs::path>())) backlog_.push_back(one_name(from_ / scene));
  backlog_size_ = backlog_.size();
  say(fmt::format("watching {}: {}", arguments_.inputs[0], counted(backlog_size_, "file")));
  if (backlog_.empty()) say("waiting for changes, until Ctrl-C");
}

/// Looks at all files, and takes those that have changed and settled. Of many files it costs so much that it is done
/// less often.
void WatchedFolder::poll() {
  const auto begin = Clock::now();
  if (auto files = seen()) settling_.look(std::move(*files), begin);
  take(settling_.settled(begin, [](const std::string& file) { return is_open_for_writing(file).value_or(false); }));
  const auto end = Clock::now();
  next_poll_ = end + std::max(settling_.quiet() / 2, rest_for_a_poll * (end - begin));
}

/// Until the next poll.
void WatchedFolder::rest() const {
  while (!interruption_.came() && Clock::now() < next_poll_) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

/// Every file that outputs may depend on. Nothing where a folder went away meanwhile.
std::optional<Settling::Seen> WatchedFolder::seen() const {
  Settling::Seen seen;
  std::error_code error;
  fs::recursive_directory_iterator at(from_, fs::directory_options::skip_permission_denied, error);
  for (; !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
    std::error_code gone;
    if (at->is_directory(gone)) {
      if (is_left_out(at->path())) at.disable_recursion_pending();
    } else if (const auto facts = file_facts(at->path())) {
      seen.emplace(at->path().string(), *facts);
    }
  }
  if (error) return std::nullopt;
  for (const std::string& file : beside_) {
    if (const auto facts = file_facts(file)) seen.emplace(file, *facts);
  }
  return seen;
}

bool WatchedFolder::is_left_out(const fs::path& folder) const {
  std::error_code error;
  return fs::equivalent(folder, out_, error) || fs::equivalent(folder, arguments_.cache, error);
}

void WatchedFolder::take(const std::vector<std::string>& settled) {
  if (settled.empty()) return;
  const FolderScenes which = scenes_for(workshop_->pipeline, registry_);
  std::optional<std::vector<fs::path>> sprites;  // an image is a scene unless a list names it
  if (which.with_sprites) {
    Diagnostics none;
    sprites = scenes_below(from_, out_, which, none).value_or(std::vector<fs::path>());
  }
  const auto is_scene = [&](const fs::path& file) {
    if (!file.string().starts_with(from_ + '/') || !is_a_file(file)) return false;
    return sprites ? std::ranges::binary_search(*sprites, file.lexically_relative(from_))
                   : is_scene_of_folder(file, which);
  };
  for (const std::string& file : settled) {
    if (!is_utf8(file)) {
      if (is_scene(file)) say(printable(name_of(file)) + ": is passed by: its name is not UTF-8");
      continue;
    }
    has_to_open_ = has_to_open_ || is_of_the_pipeline(file);
    for (const auto& [scene, files] : files_of_) {
      if (files.contains(file)) due_.try_emplace(scene, fmt::format(" ({} changed)", name_of(file)));
    }
    if (is_scene(file)) {
      due_[file] = "";
    } else if (files_of_.contains(file) && !is_a_file(file)) {
      take_gone(file);
    }
  }
}

bool WatchedFolder::is_of_the_pipeline(const std::string& file) const {
  const auto is_it = [&](const fs::path& other) {
    return other.filename() == fs::path(file).filename() && one_name(other) == file;
  };
  return std::ranges::any_of(workshop_->job.pipeline_files, is_it) ||
         std::ranges::any_of(workshop_->how.files->all(), is_it, &FileRead::path);
}

void WatchedFolder::take_gone(const std::string& file) {
  files_of_.erase(file);
  std::erase_if(makers_, [&](const auto& made) { return made.second == file; });
  due_.erase(file);
  say(name_of(file) + ": is gone; its output stays");
}

/// With the pipeline as it is now; where that is a mistake, it goes on with the one that it has.
void WatchedFolder::open_again() {
  has_to_open_ = false;
  Diagnostics diagnostics;
  auto workshop = Workshop::opened(arguments_, registry_, executor_, diagnostics);
  tell(diagnostics);
  if (!workshop) return say("the pipeline is used as it was before");
  workshop_ = std::move(workshop);
  for (const fs::path& file : workshop_->job.pipeline_files) look_beside(one_name(file));
  say("the pipeline has changed: all files are looked at again");
  look_at_all();
}

/// What changed, unless a file that it depends on is still being written; else the next of the backlog.
WatchedFolder::Due WatchedFolder::next_due() {
  Due due;
  const std::size_t most = files_for_a_thread * static_cast<std::size_t>(executor_.threads());
  auto at = due_.begin();
  while (at != due_.end() && due.size() < most) {
    const auto is_waited_for = [&](const std::string& file) { return settling_.waits_for(file); };
    const auto files = files_of_.find(at->first);
    const bool waits =
        is_waited_for(at->first) || (files != files_of_.end() && std::ranges::any_of(files->second, is_waited_for));
    if (!waits) due.insert(*at);
    at = waits ? std::next(at) : due_.erase(at);
  }
  if (!due.empty()) return due;
  for (; due.size() < most && !backlog_.empty(); backlog_.pop_front()) due.emplace(backlog_.front(), std::nullopt);
  return due;
}

/// Two scenes may not become the same file. Who came first keeps it.
bool WatchedFolder::has_place_for(const std::string& scene, const fs::path& output) {
  Diagnostics diagnostics;
  for (const fs::path& file : foredraw::paths_written_for(output)) {
    const auto [at, is_new] = makers_.try_emplace(file, scene);
    if (is_new || at->second == scene) continue;
    diagnostics.error({.file = file.string()}, "outputs-meet",
                      "the outputs of " + name_of(at->second) + " and " + name_of(scene) + " would both have this name",
                      "give one of them another name");
    break;  // that further files of the two meet is the same
  }
  if (!diagnostics.has_errors()) make_folder(output.parent_path(), diagnostics);
  tell(diagnostics);
  return !diagnostics.has_errors();
}

void WatchedFolder::run(const Due& due) {
  struct Task {
    std::string scene;
    Reason why;
    fs::path output;
    FileRun run = {};
  };
  std::vector<Task> tasks;
  for (const auto& [scene, why] : due) {
    if (!is_a_file(scene)) continue;  // it has gone meanwhile
    Task task{scene, why, output_of(name_of(scene), out_)};
    if (has_place_for(scene, task.output)) tasks.push_back(std::move(task));
  }
  std::mutex at_the_line;
  executor_.for_each(tasks.size(), [&](std::size_t i) {
    Task& task = tasks[i];
    if (interruption_.came()) return;
    const auto begin = Clock::now();
    const auto before = file_facts(task.output);
    const std::string input = (fs::path(arguments_.inputs[0]) / name_of(task.scene)).string();
    task.run = guarded(input, [&] { return optimize_file(workshop_->job, input, {{{}, task.output.string()}}); });
    if (interruption_.came() && task.run.is_lost) return;
    const bool is_new = file_facts(task.output) != before;
    const std::scoped_lock lock(at_the_line);
    tell_run(task.scene, task.why, task.run, is_new, std::chrono::duration<double>(Clock::now() - begin).count());
  });
  if (interruption_.came()) return;
  for (const Task& task : tasks) remember(task.scene, task.run);
  for (const FileRead& lent : workshop_->how.files->all()) look_beside(one_name(lent.path));
  const auto progress = progress_line();
  if (progress && !backlog_.empty()) {
    const auto all = static_cast<double>(backlog_size_), left = static_cast<double>(backlog_.size());
    progress(name_of(backlog_.front()), (all - left) / all);
  }
}

/// One line; none of a file that nobody touched, and whose output was right already.
void WatchedFolder::tell_run(const std::string& scene, const Reason& why, const FileRun& run, bool is_new,
                             double seconds) {
  if (!why && !is_new && run.exit == done) return;
  const StoredReport report = stored_report(run.json.empty() ? to_json(run.report) : run.json, registry_);
  if (!report.diagnostics.empty()) end_progress();
  tell(report.diagnostics);
  const std::string reason = why.value_or("");
  if (run.is_lost) return say(fmt::format("{}{}: failed; its output stays as it was", name_of(scene), reason));
  say(fmt::format("{}{}: {}{}, {:.1f} s{}{}", name_of(scene), reason,
                  is_new ? "written" : "its output was right already", run.from_cache ? ", from the cache" : "",
                  seconds, run.exit == done ? "" : ", in part: a stage failed", gains_of(report)));
}

/// Files that lie elsewhere change, too.
void WatchedFolder::look_beside(const std::string& file) {
  if (file.starts_with(from_ + '/') || !beside_.insert(file).second) return;
  if (const auto facts = file_facts(file)) settling_.add(file, *facts);
}

void WatchedFolder::remember(const std::string& scene, const FileRun& run) {
  std::set<std::string>& files = files_of_[scene];
  files.clear();
  const auto add = [&](const std::vector<fs::path>& some) {
    for (const fs::path& file : some) {
      const std::string name = one_name(file);
      if (name != scene) files.insert(name);
      look_beside(name);
    }
  };
  add(run.read);
  add(run.sought);
}

}  // namespace foredraw::cli
