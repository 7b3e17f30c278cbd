// Ctrl-C: the program ends by the signal, long before its work does, and nothing is left half done.

#include "support/meshes.h"
#include "support/running_program.h"

#include <gmock/gmock.h>

namespace foredraw::interruption_test {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Running;

class Interrupted : public testing::InFolder {
 protected:
  Interrupted() {
    fs::create_directories(folder_ / "in");
    put_model("in/a.glb");
  }
  void put_model(const std::string& name) {
    fs::copy_file(testing::project_file("benchmarks/corpus/static/spot.glb"), folder_ / name);
  }
  /// In the folder "out".
  std::ptrdiff_t outputs() const {
    std::error_code none;
    return std::distance(fs::directory_iterator(folder_ / "out", none), fs::directory_iterator());
  }
  /// Whatever the signal, it ends by it, once so many files are written.
  void ends(const std::string& arguments, const std::string& told, int signal = SIGINT, int written = 0) {
    SCOPED_TRACE(arguments);
    Running program(folder_, arguments);
    EXPECT_TRUE(testing::comes_true([&] { return outputs() >= written; }));
    program.has_worked_for(.5);
    program.interrupt(signal);
    EXPECT_EQ(program.ended(), 128 + signal);
    EXPECT_EQ(program.told(), told);
  }
};

constexpr const char* slow =
    " -p 'tipsify, occlusion-order(quality=high, k=255), vertex-fetch' --products none --with vertex-cache";
constexpr const char* many_views = " --with 'overdraw-raster(count=100000)'";

TEST_F(Interrupted, OptimizeWritesNothing) {
  const std::string told = "foredraw: interrupted: nothing was written\n";
  ends(std::string("optimize in/a.glb -o a.glb --report a.json") + slow, told);
  ends(std::string("optimize in/a.glb -o a.glb -p tipsify --html a.html") + many_views, told, SIGTERM);
  EXPECT_THAT(files(), ElementsAre("in"));
}

TEST_F(Interrupted, MeasureTellsNoFigures) {
  ends(std::string("measure in/a.glb") + many_views, "foredraw: interrupted\n");
}

TEST_F(Interrupted, CompareWritesNothing) {
  ends(std::string("compare in/a.glb in/a.glb -p tipsify -p lookahead --report a.json --csv a.csv") + many_views,
       "foredraw: interrupted: nothing was written\n");
  EXPECT_THAT(files(), ElementsAre("in"));
}

TEST_F(Interrupted, OfAFolderWhatIsDoneStaysAndTheRestIsSaid) {
  for (const char* name : {"in/b.glb", "in/c.glb"}) put_model(name);
  fs::copy_file(testing::project_file("benchmarks/corpus/scenes/kaykit_city/bench.gltf"), folder_ / "in/0.gltf");
  fs::copy_file(testing::project_file("benchmarks/corpus/scenes/kaykit_city/bench.bin"), folder_ / "in/bench.bin");
  ends(std::string("optimize in -o out --threads 1 --report report.json --depfile rules.d") + slow,
       "foredraw: interrupted: 1 of 4 files done; the same command does the others\n", SIGINT, 2);
  EXPECT_THAT(files(), ElementsAre("in", "out"));
  EXPECT_EQ(outputs(), 2);
}

}  // namespace
}  // namespace foredraw::interruption_test
