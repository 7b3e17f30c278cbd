#pragma once
#include <foredraw/c/module.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace foredraw {

/// What a worker does: says what the module holds, then answers calls until it is ended. Throws std::system_error where
/// no program began this process to be a worker.
void serve(const foredraw_module* module);

/// The same where there is no module to serve: says why.
void serve_refusal(const std::string& why);

/// Loads the module, and serves it.
void serve_file(const std::filesystem::path& module);

/// Serves it in a child that is watched, with so many bytes of memory (0: any number), until the process `parent` ends
/// or asks this one to end. A Python file is served by foredraw.worker.
int serve_watched(const std::filesystem::path& module, int parent, std::uint64_t memory);

}  // namespace foredraw
