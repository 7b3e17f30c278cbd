// Files that end too early.
#include "whole_way.h"

#include "support/gltf_builder.h"
#include "support/program.h"

#include <cstring>

namespace foredraw::cut_files_test {
namespace {

using testing::go_the_whole_way;

constexpr std::size_t step = 97;

TEST(CutFiles, glb_is_refused_wherever_it_is_cut) {
  const std::vector<std::byte> whole = testing::puppet().glb();
  for (std::size_t length = 0; length < whole.size(); length += step) {
    EXPECT_FALSE(go_the_whole_way(std::span(whole).first(length)).empty()) << length;
  }
}

/// The header tells of the cut, so that what lies deeper has to find it.
TEST(CutFiles, glb_whose_header_knows_of_the_cut_is_refused) {
  const std::vector<std::byte> whole = testing::puppet().glb();
  for (std::size_t length = 12; length < whole.size(); length += step) {
    std::vector<std::byte> cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length));
    const auto said = static_cast<std::uint32_t>(length);
    std::memcpy(cut.data() + 8, &said, 4);
    EXPECT_FALSE(go_the_whole_way(cut).empty()) << length;
  }
}

/// And the BIN chunk's length too: nothing is left that tells but the sizes of what the JSON describes.
TEST(CutFiles, bin_chunk_that_ends_early_is_refused) {
  const testing::GltfBuilder puppet = testing::puppet();
  testing::GltfJson json = puppet.json;
  json["buffers"][0]["byteLength"] = puppet.buffer.size();
  for (std::size_t length = 4; length + 4 < puppet.buffer.size(); length += step) {
    EXPECT_EQ(go_the_whole_way(testing::glb_of(json.dump(), std::span(puppet.buffer).first(length / 4 * 4))),
              std::vector<std::string>{"view-range"})
        << length;
    json["buffers"][0]["byteLength"] = length / 4 * 4;
    EXPECT_FALSE(go_the_whole_way(testing::glb_of(json.dump(), std::span(puppet.buffer).first(length / 4 * 4))).empty())
        << length;
    json["buffers"][0]["byteLength"] = puppet.buffer.size();
  }
}

class CutPairs : public testing::InFolder {};

TEST_F(CutPairs, gltf_is_refused_wherever_it_or_its_bin_is_cut) {
  const testing::GltfBuilder puppet = testing::puppet();
  testing::GltfJson json = puppet.json;
  json["buffers"][0] = {{"byteLength", puppet.buffer.size()}, {"uri", "data.bin"}};
  const std::string text = json.dump();
  const std::string bin(reinterpret_cast<const char*>(puppet.buffer.data()), puppet.buffer.size());
  testing::put(folder_ / "data.bin", bin);
  ASSERT_TRUE(go_the_whole_way(testing::bytes_of(text), folder_).empty());
  for (std::size_t length = 0; length < text.size(); length += step) {
    EXPECT_FALSE(go_the_whole_way(testing::bytes_of(text.substr(0, length)), folder_).empty()) << length;
  }
  for (std::size_t length = 0; length < bin.size(); length += step) {
    testing::put(folder_ / "data.bin", bin.substr(0, length));
    EXPECT_EQ(go_the_whole_way(testing::bytes_of(text), folder_),
              std::vector<std::string>{length == 0 ? "buffer-too-short" : "view-range"})
        << length;
  }
}

}  // namespace
}  // namespace foredraw::cut_files_test
