// A machine's costs from their measurement to a table of levels, through the program.

#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/frames/rendering_costs.h>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace foredraw::calibrate_test {
namespace {

using ::testing::HasSubstr;

class Calibrate : public testing::InFolder {
 protected:
  testing::Ended run(const std::string& arguments) const { return testing::run_program(folder_, arguments); }
};

/// Costs, and which form predicts them better, depend on the machine.
TEST_F(Calibrate, WritesCostsThatATableIsMadeOf) {
  const testing::Ended measured = run("calibrate --rounds 1 -o machine.txt");
  ASSERT_EQ(measured.code, 0) << measured.err;
  EXPECT_EQ(measured.out, testing::content(folder_ / "machine.txt"));
  EXPECT_THAT(measured.out, HasSubstr("# stages max: off by "));
  EXPECT_THAT(measured.out, HasSubstr("# stages sum: off by "));
  const auto costs = std::get<RenderingCosts>(read_costs((folder_ / "machine.txt").string()));
  EXPECT_THAT(costs.machine, HasSubstr("reference renderer"));

  std::filesystem::create_directory(folder_ / "pipelines");
  testing::put(folder_ / "pipelines/table.toml",
               "pipeline = 1\nstages = [\"weld\", \"quadric-collapse\", \"levels\", "
               "{ use = \"lod-table\", costs = \"../machine.txt\" }]\n");
  const std::string model = testing::project_file("benchmarks/corpus/static/spot.glb").string();
  const testing::Ended made =
      run("optimize '" + model + "' -o out.glb -o lod-table:spot.h -o lod-table:spot.json -p pipelines/table.toml");
  ASSERT_EQ(made.code, 0) << made.err;
  EXPECT_THAT(testing::content(folder_ / "spot.h"), HasSubstr("foredraw_lod_table_draw spot_lod_draws[1]"));
  const auto json = nlohmann::json::parse(testing::content(folder_ / "spot.json"));
  EXPECT_EQ(json["machine"], costs.machine);
  EXPECT_EQ(json["draws"][0]["ways"].size(), 12u);
  const testing::Ended told = run("inspect out.glb");
  EXPECT_THAT(told.out, HasSubstr("table of levels and renderings (costs of reference renderer"));
}

TEST_F(Calibrate, RefusesWhatItCannotWriteBeforeItMeasures) {
  const testing::Ended ended = run("calibrate --rounds 1000 -o nowhere/machine.txt");
  EXPECT_EQ(ended.code, 2) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("nowhere"));
}

}  // namespace
}  // namespace foredraw::calibrate_test
