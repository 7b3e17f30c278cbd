// What the replacement of a .gltf and its .bin leaves when it is cut short, and what becomes of that.
#include <foredraw/io/gltf/patch/private/stand_ins.h>
#include <foredraw/io/scene_file.h>

#include "framework/io/gltf/edits.h"
#include "support/gltf_builder.h"
#include "support/program.h"

namespace foredraw::gltf::stand_ins_test {
namespace {

using GltfStandIns = testing::InFolder;

std::vector<OutputFile> ribbon(std::size_t squares, const std::filesystem::path& folder) {
  Diagnostics diagnostics;
  return *encode_gltf(testing::read(testing::ribbon(squares)), folder / "out.gltf", diagnostics);
}

std::vector<std::string> names(const std::vector<OutputFile>& files) {
  std::vector<std::string> names;
  for (const OutputFile& file : files) names.push_back(file.path.filename().string());
  return names;
}

TEST_F(GltfStandIns, AreThereWhereOtherBytesAreInTheWay) {
  Diagnostics diagnostics;
  EXPECT_TRUE(stand_ins(ribbon(2, folder_)).empty());
  ASSERT_TRUE(write_scene(ribbon(2, folder_), diagnostics));
  EXPECT_TRUE(stand_ins(ribbon(2, folder_)).empty());
  EXPECT_EQ(names(stand_ins(ribbon(3, folder_))), (std::vector<std::string>{"out.gltf", "out.foredraw-0.bin"}));
}

TEST_F(GltfStandIns, NeverTakeTheNameOfOneThatIsInUse) {
  Diagnostics diagnostics;
  ASSERT_TRUE(write_scene(ribbon(2, folder_), diagnostics));
  for (const std::size_t squares : {3, 4}) {  // each is killed when its stand-ins are in place
    const auto half = stand_ins(ribbon(squares, folder_));
    ASSERT_TRUE(write_files(half, diagnostics));
    const auto scene = read_gltf(folder_ / "out.gltf", diagnostics);
    ASSERT_TRUE(scene) << to_text(diagnostics);
    EXPECT_EQ(scene->draws[0].levels[0].vertices->count, 2 * squares + 2);
  }
  EXPECT_EQ(files(), (std::vector<std::string>{"out.bin", "out.foredraw-0.bin", "out.foredraw-1.bin", "out.gltf"}));
  EXPECT_EQ(names(stand_ins(ribbon(4, folder_)))[1], "out.foredraw-1.bin") << "the same bytes are in nobody's way";
  EXPECT_EQ(names(stand_ins(ribbon(5, folder_)))[1], "out.foredraw-2.bin");
  ASSERT_TRUE(write_scene(ribbon(5, folder_), diagnostics));
  EXPECT_EQ(files(), (std::vector<std::string>{"out.bin", "out.gltf"}));
}

}  // namespace
}  // namespace foredraw::gltf::stand_ins_test
