#pragma once
// One of several parts of a folder's files, for as many processes or machines.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace foredraw {

struct Shard {
  std::uint32_t number = 1;  ///< from 1 on
  std::uint32_t of = 1;
};

/// "3/16"; nothing where it is none.
std::optional<Shard> shard_in(std::string_view text);

/// Whether the file is worked on there, by a hash of its path from the folder on: of a folder's files each is in
/// exactly one part, and one that is added moves no other.
bool holds(const Shard& shard, const std::filesystem::path& file);

}  // namespace foredraw
