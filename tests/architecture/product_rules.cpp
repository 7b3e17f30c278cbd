#include "product_rules.h"

#include <algorithm>
#include <array>
#include <sstream>

namespace foredraw::architecture {

namespace {

constexpr std::array<std::string_view, 4> handed_rows = {"framework/foredraw/io/", "framework/foredraw/report/",
                                                         "framework/foredraw/pipeline/", "hosts/"};

constexpr std::array<std::string_view, 10> names = {
    "merge-instances", "merge_instances", "merged-draws", "merged_draws", "MergedDraws",
    "MergedInstances", "draw-orders",     "draw_orders",  "DrawOrders",   "EXAMPLE_landmarks"};

/// Examples of engines read products, and Python has the functions.
bool may_name(const std::string& path, std::string_view name) {
  return path.starts_with("hosts/embed/") || (path.starts_with("hosts/python/") && name == "merge_instances") ||
         (path == "framework/foredraw/pipeline/changed_tables.cpp" && name == "DrawOrders");
}

}  // namespace

Breaches product_breaches(const std::string& path, const std::string& text) {
  Breaches breaches;
  if (std::ranges::none_of(handed_rows, [&](std::string_view folder) { return path.starts_with(folder); }))
    return breaches;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    for (const std::string_view name : names) {
      if (line.find(name) == std::string::npos || may_name(path, name)) continue;
      breaches.push_back(path + ':' + std::to_string(number) + ": names " + std::string(name) +
                         "; what it has to know of a product, the product's row says");
    }
  }
  return breaches;
}

}  // namespace foredraw::architecture
