#pragma once
// A scene between two stages, told by what it differs in from the scene that the run began with. Of a handle that both
// hold a number is stored: what no stage touched is the input's own afterwards, and everything behind a milestone sees
// what it would have seen without one.

#include <foredraw/scene/product_row.h>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace foredraw {

/// Why the scene can not be told whole, as the rest of a sentence, where it can not: of products the cache holds what
/// their extensions would say in a file, and some can say more.
std::variant<std::vector<std::byte>, std::string> stored_scene(const Scene& scene, const Scene& input,
                                                               const ProductRows& rows);

/// Of the same input, which may be another copy of it. Throws std::runtime_error where the bytes are none such.
Scene restored_scene(std::span<const std::byte> bytes, const Scene& input, const ProductRows& rows);

}  // namespace foredraw
