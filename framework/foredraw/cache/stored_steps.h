#pragma once
#include <foredraw/pipeline/milestones.h>

#include <cstddef>
#include <span>
#include <vector>

namespace foredraw {

/// As bytes, for the same build; of films the number of their pictures alone.
std::vector<std::byte> stored_steps(const std::vector<Step>& steps);
/// Throws std::runtime_error where the bytes are none such.
std::vector<Step> restored_steps(std::span<const std::byte> bytes);

}  // namespace foredraw
