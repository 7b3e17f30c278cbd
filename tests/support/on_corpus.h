#pragma once
// The program, run on models of the corpus, and on small ones beside them.

#include "support/meshes.h"
#include "support/program.h"

namespace foredraw::testing {

class OnCorpus : public InFolder {
 protected:
  Ended run(const std::string& arguments, const std::string& before = {}) {
    return run_program(folder_, arguments, before);
  }
  /// "static/spot.glb" as an argument.
  static std::string model(const std::string& name) {
    return "'" + project_file("benchmarks/corpus/" + name).string() + "'";
  }
  static std::string spot() { return model("static/spot.glb"); }
  /// Puts a file of the corpus into the folder, in the place of what is there.
  void copy(const std::string& file, const std::string& to) {
    std::filesystem::copy_file(project_file("benchmarks/corpus/" + file), folder_ / to,
                               std::filesystem::copy_options::overwrite_existing);
  }
  /// An OBJ of its own for each number.
  static std::string quad(int number) {
    const std::string z = std::to_string(number);
    return "v 0 0 " + z + "\nv 1 0 " + z + "\nv 1 1 " + z + "\nv 0 1 " + z + "\nf 1 2 3\nf 1 3 4\n";
  }
  void put_quad(const std::string& name, int number) { put(folder_ / name, quad(number)); }
};

}  // namespace foredraw::testing
