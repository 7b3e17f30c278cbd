#pragma once
#include <string_view>

namespace foredraw {

/// The style sheet of the page.
std::string_view page_style();

/// The script: sorting, the plot and the viewer; empty where the program was built without npm.
std::string_view page_script();

}  // namespace foredraw
