#pragma once
// A pipeline as a key: two that are written otherwise and do the same have one text.

#include <foredraw/pipeline/pipeline.h>
#include <foredraw/technique/registry.h>

#include <filesystem>
#include <string>
#include <vector>

namespace foredraw {

/// Every option of every stage with its value, defaults included; without comments and `about`.
std::string canonical_text(const Pipeline& pipeline, const Registry& registry);

/// The devices that its answers depend on, by the cards of its plugins: "overdraw-vulkan: llvmpipe, driver 1".
std::vector<std::string> devices_in(const Pipeline& pipeline, const Registry& registry);

/// The files that its options name, by their paths from here: whatever text is the path of a file.
std::vector<std::filesystem::path> files_named_in(const Pipeline& pipeline, const Registry& registry);

}  // namespace foredraw
