#pragma once
// What may include what.

#include "source_tree.h"

namespace foredraw::architecture {

/// What the file at `path` includes and may not:
/// - framework/foredraw: base <- scene <- analysis <- technique <- report <- pipeline <- io, only leftwards; platform
///   includes only base, and pipeline, io and the hosts include platform; runtime is C and includes only C's own
///   headers.
/// - Headers of the framework show no third-party type but GLM's, unless they lie in a layer's private/ folder, which
/// no
///   one else includes; tinygltf is io's alone, POSIX platform's.
/// - Plugins and evaluators include the framework up to technique, their own folder and packages. All of their files
/// but
///   the _plugin ones are plain: the standard library, GLM, their own folder, of the framework base, scene and
///   analysis, and, but for the header that bears the technique's name, the packages that techniques are made of.
/// Tests, benchmarks and documents may include what they like.
Breaches include_breaches(const std::string& path, const std::string& text);

}  // namespace foredraw::architecture
