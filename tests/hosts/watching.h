#pragma once
// The program, watching a folder.

#include "support/on_corpus.h"
#include "support/running_program.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace foredraw::testing {

/// Stages and evaluators that take no time.
inline constexpr const char* quick_stages = " -p 'tipsify, vertex-fetch' --with vertex-cache";

class Watching : public OnCorpus {
 protected:
  Watching() { std::filesystem::create_directories(folder_ / "in/props"); }

  void put_bench() {
    copy("scenes/kaykit_city/bench.gltf", "in/props/bench.gltf");
    copy("scenes/kaykit_city/bench.bin", "in/props/bench.bin");
  }

  Running watching(const std::string& more = quick_stages, const std::string& before = "") {
    return Running(folder_, "watch in -o out " + more, before);
  }
  /// Changes a file, and waits until it is taken: what was taken before it has been told.
  void rest(const Running& program) {
    static int quads = 0;
    put_quad("in/rest" + std::to_string(++quads) + ".obj", quads);
    program.tells("rest" + std::to_string(quads) + ".obj: written");
  }

  std::string output(const std::string& name) const { return content(folder_ / "out" / name); }
  /// The output as a run of its own makes it.
  std::string clean(const std::string& output) {
    const Ended ended = run_program(folder_, "optimize in -o clean" + std::string(quick_stages));
    EXPECT_LE(ended.code, 2) << ended.err;
    return content(folder_ / "clean" / output);
  }
  std::vector<std::string> all_files(const std::string& folder) const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_ / folder)) {
      if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder_ / folder).string());
    }
    std::sort(names.begin(), names.end());
    return names;
  }
};

}  // namespace foredraw::testing
