#pragma once
#include <foredraw/analysis/analyses.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/base/parallel.h>
#include <foredraw/scene/product_row.h>

#include <string>

namespace foredraw {

/// What a scene holds and what is odd about it, for people; of its products, what their rows tell.
std::string inspection_text(const Scene& scene, const ProductRows& rows, Analyses& analyses, const Executor& executor);
/// With what the reader of the file told of it.
std::string inspection_json(const Scene& scene, const ProductRows& rows, const Diagnostics& told, Analyses& analyses,
                            const Executor& executor);

}  // namespace foredraw
