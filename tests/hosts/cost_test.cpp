// What a run may hold of the machine's memory: 4 times the file, 150 bytes a triangle and 64 MiB.

#include "support/meshes.h"
#include "support/program.h"

#include <nlohmann/json.hpp>

#include <sys/resource.h>

namespace foredraw::cost_test {
namespace {

using Json = nlohmann::json;

class Cost : public testing::InFolder {};

TEST_F(Cost, TheLargestSceneStaysWithinItsMemory) {
  if (testing::is_sanitized) GTEST_SKIP() << "sanitizers hold memory of their own";
  const auto model = testing::project_file("benchmarks/corpus/static/chess_board_notex.glb");
  const testing::Ended ended =
      testing::run_program(folder_, "optimize '" + model.string() + "' -o out.glb --report r.json");
  ASSERT_EQ(ended.code, 0) << ended.err;
  const Json report = Json::parse(testing::content(folder_ / "r.json"));
  const auto triangles = report["totals"]["triangles"].get<double>();
  const auto bytes = static_cast<double>(std::filesystem::file_size(model));

  rusage children{};
  ASSERT_EQ(getrusage(RUSAGE_CHILDREN, &children), 0);
  const double peak = 1024.0 * static_cast<double>(children.ru_maxrss);
  EXPECT_LT(peak, 4 * bytes + 150 * triangles + 64 * 1024 * 1024);
  EXPECT_GT(peak, bytes);  // else something else was measured
}

}  // namespace
}  // namespace foredraw::cost_test
