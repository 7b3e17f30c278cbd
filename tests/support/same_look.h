#pragma once
// Whether two scenes look the same: pixel for pixel, from random sides, at random moments of their clips.

#include <foredraw/base/parallel.h>
#include <foredraw/scene/scene.h>

#include <cstdint>

namespace foredraw::testing {

struct Looks {
  std::uint64_t shown = 0;     ///< pixels that show something before
  std::uint64_t lost = 0;      ///< of these, those that show nothing after
  std::uint64_t moved = 0;     ///< and those of which the surface is more than 64 of 2^24 steps away
  std::uint64_t coloured = 0;  ///< of all others those of another colour, where normals are colours

  double wrong() const {  ///< lost or moved, of a million
    return shown == 0 ? 0 : 1e6 * static_cast<double>(lost + moved) / static_cast<double>(shown);
  }
};

struct LookOptions {
  int pictures = 300;  ///< of each subject
  int size = 1024;     ///< pixels along each edge
  std::uint64_t seed = 20261123;
};

/// Draws both scenes, of which the subjects are the same, each picture from a random side; where clips have keys, at a
/// random one of all keys of all clips. Normals are those of the bind pose; of the back of a double-sided triangle,
/// turned.
Looks compared(const Scene& before, const Scene& after, const LookOptions& options, const Executor& executor);

}  // namespace foredraw::testing
