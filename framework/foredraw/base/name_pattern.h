#pragma once
#include <string_view>

namespace foredraw {

/// A name against a pattern in which * stands for any text and ? for one character.
bool matches(std::string_view pattern, std::string_view name);

}  // namespace foredraw
