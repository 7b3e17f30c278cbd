#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::testing {

/// Command lines of the workers that there are of modules in a folder, and of what these left behind.
std::vector<std::string> workers_alive(const std::filesystem::path& folder);

/// The same, once none is left or the time is over: who is killed takes a moment to go.
std::vector<std::string> workers_alive_after(int milliseconds, const std::filesystem::path& folder);

/// A module of those that were built, in the folder. Its path.
std::string module_in(const std::filesystem::path& folder, const std::string& name);

}  // namespace foredraw::testing
