#pragma once
// Scenes of other formats, read by the importer that was built, and what stands where in them.

#include "support/fbx_builder.h"
#include "support/program.h"

#include <foredraw/io/scene_file.h>
#include <foredraw/scene/subject.h>
#include <foredraw/viewing/animation.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/geometric.hpp>

#include <algorithm>

namespace foredraw::testing {

inline constexpr const char* quick = " -p 'tipsify, vertex-fetch' --with vertex-cache";

class Imported : public InFolder {
 protected:
  Imported() {
    ::setenv("FOREDRAW_IMPORTER", FOREDRAW_IMPORT_PROGRAM, 1);
    for (const char* name : {"FOREDRAW_IMPORT_SECONDS", "FOREDRAW_IMPORT_MEMORY", "FOREDRAW_STAND_IN"})
      ::unsetenv(name);
  }

  Ended run(const std::string& arguments, const std::string& before = {}) {
    return run_program(folder_, arguments, before);
  }
  /// With the stand-in for the importer.
  Ended run_with(const std::string& stand_in, const std::string& more = {}) {
    put(folder_ / "bar.fbx", bending_bar().text());
    return run(
        "optimize bar.fbx -o bar.glb" + std::string(quick),
        "export FOREDRAW_STAND_IN='" + stand_in + "' FOREDRAW_IMPORTER='" FOREDRAW_STAND_IN_PROGRAM "' " + more + ";");
  }

  Scene read(const std::string& name, const std::string& text) {
    put(folder_ / name, text);
    Diagnostics diagnostics;
    auto file = read_scene((folder_ / name).string(), diagnostics, {});
    EXPECT_TRUE(file) << to_text(diagnostics);
    told_ = to_text(diagnostics);
    return file ? std::move(file->scene) : Scene{};
  }

  /// Of all vertices that are shown, part by part.
  static std::vector<glm::vec3> shown(const Scene& scene, const Pose& pose = {}) {
    std::vector<glm::vec3> all;
    const PosedNodes nodes = posed_nodes(scene, pose);
    for (const Subject& subject : subjects_of(scene, SubjectUnit::scene)) {
      for (const SubjectPart& part : subject.parts) {
        for (const glm::vec3& place : posed_positions(scene, part, nodes)) all.push_back(place);
      }
    }
    return all;
  }
  static float distance(const std::vector<glm::vec3>& from, const glm::vec3& to) {
    float least = 1e30f;
    for (const glm::vec3& one : from) least = std::min(least, glm::length(one - to));
    return least;
  }

  std::string told_;
};

}  // namespace foredraw::testing
