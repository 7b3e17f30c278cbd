#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace foredraw {

/// The last triangle first: [new] = old.
std::vector<std::uint32_t> backwards(std::size_t triangles);

struct Plugin;
Plugin backwards_plugin();

}  // namespace foredraw
