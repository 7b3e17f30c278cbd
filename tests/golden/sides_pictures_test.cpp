// Real models drawn with fewer sides look the same: pictures from views, and at times, that decided nothing.

#include "corpus_run.h"

#include "support/meshes.h"
#include "support/same_look.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace foredraw::sides_pictures_test {
namespace {

struct Case {
  const char* model;
  double most;  ///< pixels lost or moved, of a million that show something
};

void expect_the_same_look(const Case& one, int pictures, int size, const std::string& options = "") {
  const Scene before = testing::read_model(testing::project_file(std::string("benchmarks/corpus/") + one.model));
  const Scene after = testing::run_pipeline("sides" + options, before, 2).scene;
  const testing::Looks found = testing::compared(before, after, {.pictures = pictures, .size = size}, Executor(2));
  std::printf("%s: of %zu pixels %zu lost, %zu moved, %zu of another colour\n", one.model, std::size_t{found.shown},
              std::size_t{found.lost}, std::size_t{found.moved}, std::size_t{found.coloured});
  EXPECT_LE(found.wrong(), one.most);
  EXPECT_LE(static_cast<double>(found.coloured), 5e-6 * static_cast<double>(found.shown));
}

class SidesPictures : public ::testing::TestWithParam<Case> {};

TEST_P(SidesPictures, ShowTheSame) { expect_the_same_look(GetParam(), 300, 1024); }

INSTANTIATE_TEST_SUITE_P(LargeModels, SidesPictures,
                         ::testing::Values(Case{"static/flight_helmet_notex.glb", 0.1},
                                           Case{"static/dutch_ship_medium_notex.glb", 0.3},
                                           Case{"static/chess_board_notex.glb", 0.1},
                                           Case{"animated/kaykit_knight.glb", 0.1},
                                           Case{"animated/mannequiny.glb", 1.5}),
                         [](const auto& info) { return std::filesystem::path(info.param.model).stem().string(); });

TEST(SidesPicturesOfFew, ShowTheSame) { expect_the_same_look({"animated/mannequiny.glb", 1}, 30, 256, "(checks=60)"); }

}  // namespace
}  // namespace foredraw::sides_pictures_test
