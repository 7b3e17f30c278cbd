#pragma once
// Animated characters of the corpus, each with a skeleton of its own.

#include "gltf_document.h"

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace foredraw::bench {

/// One kind: a .glb whose meshes, materials and clips are in the document once, however many of it there are.
class Character {
 public:
  struct Kind {
    std::filesystem::path file;
    std::vector<std::string> clips;   ///< names of its animations, one of which each of it plays
    float size = 1;                   ///< what its roots are scaled by
    std::vector<std::string> hidden;  ///< names of nodes that are left out, with all below them
  };

  /// Throws std::runtime_error where the file or a clip is not there.
  Character(GltfDocument& to, Kind kind);
  ~Character();
  Character(Character&&) noexcept;

  std::size_t clips() const;

  /// Adds the nodes of one of it below a root that stands at a place, and channels to the last animation of the
  /// document: the clip, over and over, from the phase (of `phases` in a turn of it) on. Numbers of nodes that are
  /// roots.
  std::vector<std::size_t> place(const glm::dvec3& at, const glm::quat& turn, std::size_t clip, std::size_t phase);

  static constexpr std::size_t phases = 4;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foredraw::bench
