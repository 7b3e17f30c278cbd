#pragma once
#include <filesystem>
#include <optional>
#include <string>

namespace foredraw::import {

/// Why Assimp can not read a file, where its beginning tells that better than Assimp: it is empty, was saved by too old
/// or too new a program, or is not what its extension says.
std::optional<std::string> reason_in(const std::filesystem::path& file);

/// What Assimp said, in words for who has the file and not its code.
std::string plain_words(const std::string& assimps);

}  // namespace foredraw::import
