#pragma once
// What may include what.

#include "source_tree.h"

namespace foredraw::architecture {

/// A library of the framework and those that it links.
struct Room {
  std::string name;  ///< its folder below framework/foredraw: "io_gltf" for io/gltf
  std::vector<std::string> links;
};
std::vector<Room> rooms_in(const std::string& cmake);  ///< as framework/cmake/ForedrawBuild.cmake lists them
const std::vector<Room>& rooms();                      ///< this tree's

/// What the file at `path` includes and may not:
/// - framework/foredraw: a room includes itself and what it links; runtime is C and includes only C's own headers.
/// - Headers of the framework show no third-party type but GLM's, unless they lie in a private/ folder, which no other
///   room includes (those of io share theirs); those of gpu show Vulkan's, which is gpu's alone, as Draco is
///   io/gltf's and POSIX platform's.
/// - Plugins and evaluators include the framework up to measuring, their own folder and packages. All of their files
///   but the _plugin and _product ones are plain: the standard library, GLM, their own folder, the framework up to
///   frames, rooms of families, and, but for the header that bears the technique's name, the packages that techniques
///   are made of. Where their CMakeLists.txt links gpu or frames_gpu, they include that too; the header that bears the
///   name, gpu/choice.h alone.
/// Tests, benchmarks and documents may include what they like.
Breaches include_breaches(const std::string& path, const std::string& text);

/// Calls in hosts/ and the C library that plan, run or encode: they go through the room job.
Breaches host_breaches(const std::string& path, const std::string& text);

}  // namespace foredraw::architecture
