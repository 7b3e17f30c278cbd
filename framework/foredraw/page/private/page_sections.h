#pragma once
// The parts of a page that need no script. Each is the inside of a section, as HTML.

#include <foredraw/report/comparison.h>

#include <span>
#include <string>

namespace foredraw {

/// `all`: all files as one; null where there is one alone.
std::string summary_html(std::span<const Comparison> comparisons, const Comparison* all);
std::string figures_html(std::span<const Comparison> comparisons, const Comparison* all);
std::string draws_html(std::span<const Comparison> comparisons);
std::string stages_html(std::span<const Comparison> comparisons);
/// Of the first files that have some: so many.
std::string diagnostics_html(std::span<const Comparison> comparisons, std::size_t most_files);
std::string pipelines_html(std::span<const Comparison> comparisons);
std::string run_html(std::span<const Comparison> comparisons, const std::string& program);

}  // namespace foredraw
