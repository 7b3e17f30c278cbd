#pragma once
// The program, run on models of the corpus.

#include "support/meshes.h"
#include "support/program.h"

namespace foredraw::testing {

class OnCorpus : public InFolder {
 protected:
  Ended run(const std::string& arguments) { return run_program(folder_, arguments); }
  /// "static/spot.glb" as an argument.
  static std::string model(const std::string& name) {
    return "'" + project_file("benchmarks/corpus/" + name).string() + "'";
  }
  static std::string spot() { return model("static/spot.glb"); }
};

}  // namespace foredraw::testing
