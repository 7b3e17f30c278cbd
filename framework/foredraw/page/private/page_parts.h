#pragma once
// What sections of a page are put together from.

#include <foredraw/page/private/html.h>

#include <foredraw/report/comparison.h>

#include <fmt/format.h>

#include <span>
#include <string>

namespace foredraw {

/// As people count, and as figures are headed: "[1]".
inline std::string number_of(std::size_t branch) { return fmt::format("[{}]", branch + 1); }

/// What a section tells of one file. `file`: its number, or "all".
inline std::string article(const Comparison& comparison, const std::string& file, const std::string& content) {
  return element("article", element("h3", escaped(comparison.input.path)) + '\n' + content,
                 fmt::format("class=\"file\" data-file=\"{}\"", file)) +
         '\n';
}

/// Of every file for which there is something to tell, of so many at most.
template <class Content>
std::string articles(std::span<const Comparison> comparisons, Content content, std::size_t most = ~std::size_t{0}) {
  std::string html;
  for (std::size_t i = 0; i < comparisons.size() && most > 0; ++i) {
    const std::string inside = content(comparisons[i]);
    if (inside.empty()) continue;
    html += article(comparisons[i], std::to_string(i), inside);
    --most;
  }
  return html;
}

/// The same, and all files as one before them, where they are several.
template <class Content>
std::string articles_and_sum(std::span<const Comparison> comparisons, const Comparison* all, Content content) {
  return (all != nullptr ? article(*all, "all", content(*all)) : "") + articles(comparisons, content);
}

/// A table that the script can sort. Heads and rows are HTML.
inline std::string table(const std::string& heads, const std::string& rows, const std::string& kind) {
  return element("div",
                 element("table", element("thead", element("tr", heads)) + '\n' + element("tbody", '\n' + rows),
                         fmt::format("class=\"sortable {}\"", kind)),
                 "class=\"scroll\"") +
         '\n';
}

}  // namespace foredraw
