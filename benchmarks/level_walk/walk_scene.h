#pragma once
// Scenes that a camera walks through, with levels of detail in mind: most of what is placed has thousands of triangles.

#include <foredraw/scene/scene.h>

#include <cstdint>
#include <filesystem>

namespace foredraw::bench {

struct WalkOptions {
  std::uint64_t instances = 0;  ///< placed primitives to reach; 0: what the scene has by itself
  std::uint64_t seed = 1;
  std::uint64_t characters = 300;  ///< of the field
  bool gpu_instancing = false;     ///< each mesh is placed by one node with EXT_mesh_gpu_instancing
  std::filesystem::path corpus;    ///< the folder benchmarks/corpus
};

/// Each has a node "camera" that the animation "walk" moves for 12 seconds (camera_path.h), and throws
/// std::runtime_error where the corpus can not be read.

/// Streets between blocks of buildings (the kit kaykit_city) with trees, street furniture, rocks and statues: 100,000
/// placed primitives by itself. A unit is about five metres.
Scene city_walk(const WalkOptions& options);

/// A hilly ground with rocks, trees and grass, 6,000 of them by themselves, and characters of the corpus, each with a
/// skeleton of its own. The animation "walk" moves them too. Metres.
Scene field_walk(const WalkOptions& options);

/// Rooms in a square, 4,000 placed primitives by themselves: doors between neighbours, furniture and ornaments. The
/// camera goes from room to room. Metres.
Scene building_walk(const WalkOptions& options);

}  // namespace foredraw::bench
