#pragma once
// Merged draws as a product: FOREDRAW_merge_instances, and files for engines. docs/guides/merge-instances.md tells what
// the members mean.

#include <foredraw/instances/merged_instances.h>
#include <foredraw/scene/product_row.h>

namespace foredraw {

std::shared_ptr<const ProductRow> merged_draws_product();

namespace processors::merge_instances {

/// Reads the product out of its extension, of which nothing is trusted; or what is wrong with it.
std::variant<MergedDraws, std::string> read_merged_draws(ExtensionReader& from, const Scene& scene);

void write_merged_draws(const Scene& scene, ExtensionWriter& to);

/// What lies where (.json) and the buffers beside it, or functions for a vertex shader (.glsl, .hlsl). Throws Refusal
/// where a shader could not address the vertices.
SideFile merged_side_file(const Scene& scene, std::string_view extension, const std::string& beside);

}  // namespace processors::merge_instances

}  // namespace foredraw
