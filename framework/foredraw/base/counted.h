#pragma once
#include <cstdint>
#include <string>
#include <string_view>

namespace foredraw {

/// "1,234,567".
std::string counted(std::uint64_t count);

/// "1 draw", "1,200 draws"; "2 meshes" where the plural is told.
std::string counted(std::uint64_t count, std::string_view one, std::string_view several = {});

}  // namespace foredraw
