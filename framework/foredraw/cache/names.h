#pragma once
// How a cache's folder is laid out: "entries/3f/0c..." and "memory/3f/0c...", by stamps.

#include <foredraw/base/content_hash.h>

#include <filesystem>
#include <optional>
#include <string_view>

namespace foredraw {

/// Of to_text()'s 32 digits; nothing of anything else.
std::optional<Stamp> stamp_in(std::string_view digits);

/// No folder holds more than a 256th of all.
std::filesystem::path place_below(const std::filesystem::path& folder, const Stamp& stamp);

/// The stamp that a file of that layout is called by; nothing of any other file.
std::optional<Stamp> stamp_called(const std::filesystem::path& place);

}  // namespace foredraw
