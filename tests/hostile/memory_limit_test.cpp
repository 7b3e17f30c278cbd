// --memory-limit: where it is not enough, one line says so, and what was there stays.
#ifdef FOREDRAW_PROGRAM
#include "support/draco_gltf.h"
#include "support/meshes.h"
#include "support/program.h"

namespace foredraw::memory_limit_test {
namespace {

class MemoryLimit : public testing::InFolder {
 protected:
  /// Optimises a model of 18,000 triangles over an old output.
  testing::Ended optimize(const std::string& limit, const std::string& more = {}) {
    testing::put(folder_ / "out.glb", "mine");
    return testing::run_program(folder_, "optimize '" + model_ + "' -o out.glb --memory-limit " + limit + more);
  }

  std::string model_ = testing::project_file("benchmarks/corpus/static/head.glb").string();
};

TEST_F(MemoryLimit, that_is_enough_changes_nothing) {
  if (testing::is_sanitized) GTEST_SKIP();
  ASSERT_EQ(optimize("2G").code, 0);
  const std::string limited = testing::content(folder_ / "out.glb");
  ASSERT_EQ(testing::run_program(folder_, "optimize '" + model_ + "' -o out.glb").code, 0);
  EXPECT_EQ(limited, testing::content(folder_ / "out.glb"));
}

/// From far too little to nearly enough: whatever step it is that lacks the memory, it ends in words.
TEST_F(MemoryLimit, that_is_too_small_is_told_in_one_line) {
  if (testing::is_sanitized) GTEST_SKIP();
  int refused = 0, done = 0;
  for (int megabytes = 1; megabytes < 60 && done < 3; megabytes += megabytes < 30 ? 1 : 5) {
    const testing::Ended ended = optimize(std::to_string(megabytes) + "M", megabytes % 2 ? " --threads 1" : "");
    SCOPED_TRACE(std::to_string(megabytes) + " MB\n" + ended.err.substr(0, 2000));
    if (ended.code == 0) {
      ++done;
      EXPECT_EQ(testing::content(folder_ / "out.glb").substr(0, 4), "glTF");
      continue;
    }
    ++refused;
    EXPECT_EQ(ended.code, 2);
    EXPECT_EQ(testing::content(folder_ / "out.glb"), "mine");
    EXPECT_EQ(files(), std::vector<std::string>{"out.glb"});
    EXPECT_NE(ended.err.find("not enough memory to "), std::string::npos);
    EXPECT_NE(ended.err.find("--memory-limit"), std::string::npos);
    EXPECT_EQ(std::count(ended.err.begin(), ended.err.end(), '\n'), 2) << "a line and its hint";
  }
  EXPECT_GT(refused, 3);
  EXPECT_GT(done, 0);
}

TEST_F(MemoryLimit, holds_for_every_command_that_reads) {
  if (testing::is_sanitized) GTEST_SKIP();
  for (const char* command : {"plan", "measure", "inspect", "compare"}) {
    const testing::Ended ended =
        testing::run_program(folder_, std::string(command) + " '" + model_ + "' --memory-limit 2M");
    EXPECT_EQ(ended.code, 2) << command;
    EXPECT_NE(ended.err.find("not enough memory to "), std::string::npos) << command << '\n' << ended.err;
  }
}

TEST_F(MemoryLimit, holds_while_draco_is_decoded) {
  if (testing::is_sanitized) GTEST_SKIP();
  const auto file = testing::draco_compressed(testing::ribbon(30000), {.bits = 12}).glb();
  testing::put(folder_ / "coded.glb", std::string(reinterpret_cast<const char*>(file.data()), file.size()));
  int refused = 0;
  for (int megabytes = 2; megabytes <= 66; megabytes += 8) {
    const testing::Ended ended =
        testing::run_program(folder_, "inspect coded.glb --memory-limit " + std::to_string(megabytes) + "M");
    if (ended.code == 0) continue;
    ++refused;
    EXPECT_EQ(ended.code, 2) << megabytes;
    EXPECT_NE(ended.err.find("not enough memory to "), std::string::npos) << megabytes << '\n' << ended.err;
  }
  EXPECT_GT(refused, 1);
  EXPECT_LT(refused, 9);
}

TEST_F(MemoryLimit, is_known_before_a_huge_file_is_read) {
  if (testing::is_sanitized) GTEST_SKIP();
  testing::put(folder_ / "huge.glb", "glTF");
  std::filesystem::resize_file(folder_ / "huge.glb", std::uintmax_t{1} << 42);
  const testing::Ended ended = testing::run_program(folder_, "optimize huge.glb -o out.glb --memory-limit 1G");
  EXPECT_EQ(ended.code, 2);
  EXPECT_NE(ended.err.find("huge.glb: error: "), std::string::npos) << ended.err;
}

TEST_F(MemoryLimit, is_a_size) {
  for (const char* wrong : {"much", "-1", "0", "2X", "2GB", "1.5G", "''", "99999999999999999999", "99999999999T"}) {
    const testing::Ended ended = optimize(wrong);
    EXPECT_EQ(ended.code, 1) << wrong;
    EXPECT_NE(ended.err.find("--memory-limit"), std::string::npos) << ended.err;
  }
}

}  // namespace
}  // namespace foredraw::memory_limit_test
#endif
