#pragma once
// Where values stand in a JSON text that is known to be one: so that a long text need not become a tree to be taken
// apart.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace foredraw {

/// The members of an object, each with its value's text. Keys are as they are written between their quotes.
std::vector<std::pair<std::string_view, std::string_view>> members_in(std::string_view object);

/// The elements of an array.
std::vector<std::string_view> elements_in(std::string_view array);

}  // namespace foredraw
