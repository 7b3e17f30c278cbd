#pragma once
// Read, optimise, write, read again: the way of every file through the program, without the program.

#include <foredraw/io/gltf/gltf.h>

#include <span>
#include <string>
#include <vector>

namespace foredraw::testing {

/// Goes the whole way, as far as the file lets us, and expects what has to hold of any bytes whatever: read or refused
/// and never both; each refusal one line that names file and place; no stage fails on what was read; what is written
/// can be read. Returns the codes of the errors, none where the file was read.
std::vector<std::string> go_the_whole_way(std::span<const std::byte> bytes, const std::filesystem::path& folder = {});

}  // namespace foredraw::testing
