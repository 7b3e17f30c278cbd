#pragma once
// The row of what crowd-levels makes: how a CrowdLevels is read, written, followed, checked and told.

#include <foredraw/crowds/crowd_levels.h>
#include <foredraw/runtime/crowd_table.h>
#include <foredraw/scene/product_row.h>

#include <variant>

namespace foredraw {

std::shared_ptr<const ProductRow> crowd_levels_product();

/// FOREDRAW_crowd_levels, on the file and on primitives, or what is wrong with it as the rest of a sentence.
std::variant<CrowdLevels, std::string> read_crowd_levels(ExtensionReader& from, const Scene& scene);
void write_crowd_levels(const CrowdLevels& levels, ExtensionWriter& to);

/// For engines: static const arrays for C99 and C++ in the types of runtime/crowd_table.h. `stem`: what their names
/// begin with, such as "orc" of orc.h.
std::string crowd_levels_header(const CrowdLevels& levels, const Scene& scene, const std::string& stem);
/// The same as JSON, with the hull, and how far each level of it reaches beside the finest one.
ExtensionValue crowd_levels_value(const CrowdLevels& levels, const Scene& scene);

/// The levels as the runtime has them; errors are root mean squares.
std::vector<foredraw_crowd_level> runtime_levels(const Crowd& crowd);

constexpr std::string_view to_text(foredraw_spacing spacing) {
  constexpr std::string_view texts[] = {"equal", "fractional-odd", "fractional-even"};
  return texts[static_cast<int>(spacing)];
}

}  // namespace foredraw
