#include "left_behind.h"

#include "support/process_time.h"
#include "support/program.h"

#include <algorithm>
#include <map>

namespace foredraw::testing {

namespace {

/// Command lines by the number of the process.
std::map<std::string, std::string> workers_by_number(const std::filesystem::path& folder) {
  std::map<std::string, std::string> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    std::string words = content(entry.path() / "cmdline");  // empty where it is no process, or one that has ended
    if (words.find(folder.string() + '/') == std::string::npos) continue;
    if (words.find(FOREDRAW_WORKER) == std::string::npos && words.find("foredraw.worker") == std::string::npos)
      continue;
    std::replace(words.begin(), words.end(), '\0', ' ');
    found[entry.path().filename().string()] = std::move(words);
  }
  return found;
}

}  // namespace

std::vector<std::string> workers_alive(const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  for (const auto& [number, words] : workers_by_number(folder)) lines.push_back(words);
  return lines;
}

std::vector<std::string> workers_left(const std::filesystem::path& folder) {
  comes_true([&] { return workers_alive(folder).empty(); });
  return workers_alive(folder);
}

bool a_worker_spins(const std::filesystem::path& folder) {
  return comes_true([&] {
    return std::ranges::any_of(workers_by_number(folder),
                               [](const auto& worker) { return seconds_worked(worker.first) >= 0.2; });
  });
}

std::string module_in(const std::filesystem::path& folder, const std::string& name) {
  const auto to = folder / (name + ".so");
  std::filesystem::copy_file(std::filesystem::path(FOREDRAW_MODULES_FOLDER) / (name + ".so"), to,
                             std::filesystem::copy_options::overwrite_existing);
  return to.string();
}

}  // namespace foredraw::testing
