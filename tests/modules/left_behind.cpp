#include "left_behind.h"

#include "support/program.h"

#include <chrono>
#include <thread>

namespace foredraw::testing {

std::vector<std::string> workers_alive(const std::filesystem::path& folder) {
  std::vector<std::string> found;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator("/proc", error)) {
    std::string words = content(entry.path() / "cmdline");  // empty where it is no process, or one that has ended
    if (words.find(folder.string() + '/') == std::string::npos) continue;
    if (words.find(FOREDRAW_WORKER) == std::string::npos && words.find("foredraw.worker") == std::string::npos)
      continue;
    std::replace(words.begin(), words.end(), '\0', ' ');
    found.push_back(std::move(words));
  }
  return found;
}

std::vector<std::string> workers_alive_after(int milliseconds, const std::filesystem::path& folder) {
  auto alive = workers_alive(folder);
  for (int waited = 0; !alive.empty() && waited < milliseconds; waited += 20) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    alive = workers_alive(folder);
  }
  return alive;
}

std::string module_in(const std::filesystem::path& folder, const std::string& name) {
  const auto to = folder / (name + ".so");
  std::filesystem::copy_file(std::filesystem::path(FOREDRAW_MODULES_FOLDER) / (name + ".so"), to,
                             std::filesystem::copy_options::overwrite_existing);
  return to.string();
}

}  // namespace foredraw::testing
