#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::testing {

/// Command lines of the workers that there are of modules in a folder, and of what these left behind.
std::vector<std::string> workers_alive(const std::filesystem::path& folder);

/// Waits until none is left: who is killed takes a moment to go. Returns those that never go.
std::vector<std::string> workers_left(const std::filesystem::path& folder);

/// Waits until one of them has used more of a processor than it takes to load a module: it is in a call that spins.
/// Returns false if none ever does.
bool a_worker_spins(const std::filesystem::path& folder);

/// A module of those that were built, in the folder. Its path.
std::string module_in(const std::filesystem::path& folder, const std::string& name);

}  // namespace foredraw::testing
