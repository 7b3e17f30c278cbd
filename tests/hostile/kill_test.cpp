// Killed at any moment, the program leaves what was there whole, or what it made; and nothing for ever beside it.
#include "support/gltf_builder.h"
#include "support/meshes.h"
#include "support/program.h"

#include <foredraw/base/random.h>
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/scene_file.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>

namespace foredraw::kill_test {
namespace {

namespace fs = std::filesystem;
using std::chrono::microseconds;
using testing::content;

class Killed : public testing::InFolder {
 protected:
  /// Runs `work` in a process of its own, and kills that after a while if it has not ended. Whether it had.
  template <class Work>
  static bool killed_after(microseconds delay, Work work) {
    const pid_t child = ::fork();
    if (child == 0) {
      work();
      ::_exit(0);
    }
    int status = 0;
    for (auto left = delay; left > microseconds(0); left -= std::min(left, microseconds(2000))) {
      if (::waitpid(child, &status, WNOHANG) == child) return WIFEXITED(status);
      ::usleep(static_cast<useconds_t>(std::min(left, microseconds(2000)).count()));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, &status, 0);
    return WIFEXITED(status);
  }

#ifdef FOREDRAW_PROGRAM
  static void become_program(const fs::path& folder, const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    std::string program = FOREDRAW_PROGRAM;
    argv.push_back(program.data());
    std::vector<std::string> kept = arguments;
    for (std::string& argument : kept) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int stream = 0; stream < 3; ++stream) ::dup2(nowhere, stream);
    if (::chdir(folder.c_str()) == 0) ::execv(argv[0], argv.data());
    ::_exit(127);
  }

  std::string model_ = testing::project_file("benchmarks/corpus/static/spot.glb").string();
  std::vector<std::string> arguments_ = {"optimize", model_,         "-o",     "out.glb",
                                         "-p",       "weld,tipsify", "--with", "vertex-cache"};
#endif
};

#ifdef FOREDRAW_PROGRAM
TEST_F(Killed, program_leaves_the_old_output_or_the_new) {
  const auto start = std::chrono::steady_clock::now();
  const testing::Ended first =
      testing::run_program(folder_, "optimize '" + model_ + "' -o out.glb -p weld,tipsify --with vertex-cache");
  ASSERT_EQ(first.code, 0) << first.err;
  const auto whole = std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - start);
  const std::string made = content(folder_ / "out.glb");
  const std::string old = "an old output, not even a glTF";
  constexpr int rounds = 60;
  int in_time = 0;
  for (int round = 0; round < rounds; ++round) {
    testing::put(folder_ / "out.glb", old);
    killed_after(whole * round * 5 / (rounds * 4), [&] { become_program(folder_, arguments_); });
    const std::string now = content(folder_ / "out.glb");
    ASSERT_TRUE(now == old || now == made) << now.size() << " bytes in round " << round;
    in_time += now == made ? 1 : 0;
    ASSERT_LE(files().size(), 2u) << "no more than one leftover, for the next run removes it";
  }
  EXPECT_LT(in_time, rounds);
  ASSERT_EQ(testing::run_program(folder_, "optimize '" + model_ + "' -o out.glb -p weld --with vertex-cache").code, 0);
  EXPECT_EQ(files(), std::vector<std::string>{"out.glb"});
}

/// The system kills who writes past a limit: at exactly that byte of the output.
TEST_F(Killed, program_leaves_the_old_output_when_it_dies_writing) {
  ASSERT_EQ(
      testing::run_program(folder_, "optimize '" + model_ + "' -o out.glb -p weld,tipsify --with vertex-cache").code,
      0);
  const std::string made = content(folder_ / "out.glb");
  ASSERT_GT(made.size(), 100'000u);
  for (std::size_t limit = 0; limit <= made.size() + 5000; limit += made.size() / 11) {
    testing::put(folder_ / "out.glb", "old");
    const bool ended = killed_after(std::chrono::seconds(60), [&] {
      const struct rlimit most { limit, limit }, none{0, 0};
      ::setrlimit(RLIMIT_FSIZE, &most);
      ::setrlimit(RLIMIT_CORE, &none);
      become_program(folder_, arguments_);
    });
    EXPECT_EQ(ended, limit >= made.size()) << limit;
    EXPECT_TRUE(content(folder_ / "out.glb") == (ended ? made : "old")) << limit;
  }
}
#endif

/// The writing alone, over and over, so that the kill falls on every step of it.
TEST_F(Killed, writer_leaves_the_old_file_or_the_new) {
  const std::vector<std::vector<std::byte>> versions = {std::vector<std::byte>(300'000, std::byte{1}),
                                                        std::vector<std::byte>(200'000, std::byte{2})};
  const auto write = [&](std::size_t version) {
    const OutputFile file{folder_ / "out", versions[version]};
    Diagnostics diagnostics;
    return write_files(std::span(&file, 1), diagnostics);
  };
  ASSERT_TRUE(write(0));
  Random random(7);
  int left_over = 0;
  for (int round = 0; round < 100 || (left_over == 0 && round < 10'000); ++round) {
    killed_after(microseconds(random.below(6000)), [&] {
      for (std::size_t i = 0;; ++i) write(i % 2);
    });
    const std::string now = content(folder_ / "out");
    const bool is_whole = now == std::string(300'000, '\1') || now == std::string(200'000, '\2');
    ASSERT_TRUE(is_whole) << now.size() << " bytes in round " << round;
    ASSERT_LE(files().size(), 2u);
    left_over += files().size() == 2 ? 1 : 0;
  }
  EXPECT_GT(left_over, 0) << "no kill came while it was writing: this test tests nothing";
  ASSERT_TRUE(write(0));
  EXPECT_EQ(files(), std::vector<std::string>{"out"});
}

/// Two files make one scene: never the text of one with the bytes of the other.
TEST_F(Killed, writer_leaves_the_old_scene_or_the_new) {
  Diagnostics diagnostics;
  std::vector<std::vector<OutputFile>> versions;
  for (const std::size_t squares : {2000, 3000}) {
    auto scene = read_gltf(testing::ribbon(squares).glb(), "ribbon", {}, diagnostics);
    ASSERT_TRUE(scene);
    versions.push_back(*encode_gltf(*scene, folder_ / "out.gltf", diagnostics));
    ASSERT_EQ(versions.back().size(), 2u);
  }
  ASSERT_TRUE(write_scene(versions[0], diagnostics));
  Random random(8);
  int stand_ins = 0;
  for (int round = 0; round < 100 || (stand_ins == 0 && round < 10'000); ++round) {
    killed_after(microseconds(random.below(12000)), [&] {
      Diagnostics ignored;
      for (std::size_t i = 1;; ++i) write_scene(versions[i % 2], ignored);
    });
    const auto scene = read_gltf(folder_ / "out.gltf", diagnostics);
    ASSERT_TRUE(scene) << "round " << round << '\n' << to_text(diagnostics);
    const std::size_t count = scene->draws[0].levels[0].vertices->count;
    ASSERT_TRUE(count == 4002 || count == 6002);
    const auto as_made = read_gltf(testing::ribbon(count / 2 - 1).glb(), "ribbon", {}, diagnostics);
    ASSERT_EQ(scene->draws[0].levels[0].vertices->stamp(), as_made->draws[0].levels[0].vertices->stamp())
        << "round " << round;
    stand_ins += files().size() > 2 ? 1 : 0;
  }
  EXPECT_GT(stand_ins, 0) << "no kill came between: this test tests nothing";
  ASSERT_TRUE(write_scene(versions[1], diagnostics));
  ASSERT_TRUE(write_scene(versions[0], diagnostics));
  EXPECT_EQ(files(), (std::vector<std::string>{"out.bin", "out.gltf"}));
  EXPECT_EQ(content(folder_ / "out.gltf").size(), versions[0][0].bytes.size())
      << "the text is that of an undisturbed run";
}

/// A failure is no kill, but must not change anything either.
TEST_F(Killed, scene_that_can_not_be_written_whole_changes_nothing) {
  Diagnostics diagnostics;
  const auto encoded = [&](std::size_t squares) {
    return *encode_gltf(*read_gltf(testing::ribbon(squares).glb(), "ribbon", {}, diagnostics), folder_ / "out.gltf",
                        diagnostics);
  };
  ASSERT_TRUE(write_scene(encoded(2), diagnostics));
  const std::string text = content(folder_ / "out.gltf"), bytes = content(folder_ / "out.bin");
  std::vector<OutputFile> files_to_write = encoded(3);
  files_to_write.push_back({folder_ / "missing" / "report.json", {}});
  EXPECT_FALSE(write_scene(files_to_write, diagnostics));
  EXPECT_EQ(content(folder_ / "out.gltf"), text);
  EXPECT_EQ(content(folder_ / "out.bin"), bytes);
  EXPECT_EQ(files().size(), 2u);
}

}  // namespace
}  // namespace foredraw::kill_test
