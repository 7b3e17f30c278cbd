#pragma once
// A comparison as one HTML file, which opens without a server or a network: tables that can be read without a script,
// and what the script makes of the rest.

#include <foredraw/page/display.h>

#include <foredraw/report/comparison.h>

#include <span>
#include <string>

namespace foredraw {

/// How many files a page has a viewer for.
inline constexpr std::size_t most_displays = 8;

/// Of more files a page has a table that scrolls, and articles of the first of them alone.
inline constexpr std::size_t most_articles = 200;

/// How many bytes of pictures that techniques attached a page holds: some 1,500 of 320 x 180 pixels, or many more of
/// few colours.
inline constexpr std::size_t most_picture_bytes = 32'000'000;

/// `displays`: of the first files. `program`: its name and version.
std::string page(std::span<const Comparison> comparisons, std::span<const Display> displays,
                 const std::string& program);

}  // namespace foredraw
