// Maps of heights of every kind that images come in, and maps that are none, through the program.
#include "displaced_parts.h"

#include <foredraw/io/gltf/gltf.h>
#include <foredraw/scene/triangle_draw.h>

#include <cmath>
#include <limits>

namespace foredraw::displaced_maps_test {
namespace {

#ifdef FOREDRAW_PROGRAM
using testing::noise;
using testing::Parts;
using testing::text_of;

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

class DisplacedMaps : public testing::InFolder {
 protected:
  testing::Ended run(const std::string& command) { return testing::run_program(folder_, command); }
};

/// Says that its values are those of the colour space sRGB: heights are no colours.
std::vector<std::byte> tagged_srgb(std::vector<std::byte> png) {
  constexpr unsigned char chunk[] = {0, 0, 0, 1, 's', 'R', 'G', 'B', 0, 0xAE, 0xCE, 0x1C, 0xE9};
  constexpr std::ptrdiff_t behind_the_header = 8 + 25;
  const auto bytes = std::as_bytes(std::span(chunk));
  png.insert(png.begin() + behind_the_header, bytes.begin(), bytes.end());
  return png;
}

TEST_F(DisplacedMaps, MapsOfEveryKindMoveTheSurface) {
  const std::vector<float> odd = {0.5f, nan, inf, -inf, -1, 2, 1e-40f, 0.25f};
  const std::vector<std::pair<std::string, std::vector<std::byte>>> maps = {
      {"1x1.png", testing::png_of({1, 1, 1, 16}, {40000})},
      {"64x1.png", testing::png_of({64, 1, 1, 16}, noise(64, 16))},
      {"1x64.png", testing::png_of({1, 64, 1, 8}, noise(64, 8))},
      {"grey8.png", testing::png_of({32, 32, 1, 8}, noise(1024, 8))},
      {"rgba8.png", testing::png_of({32, 32, 4, 8}, noise(4096, 8))},
      {"rgba16.png", testing::png_of({32, 32, 4, 16}, noise(4096, 16))},
      {"rgb8.jpg", testing::jpeg_of({32, 32, 3, 8}, noise(3072, 8))},
      {"float.exr", testing::exr_of({4, 2, 1, 32}, odd, "none")}};
  for (const auto& [name, bytes] : maps) {
    SCOPED_TRACE(name);
    testing::put(folder_ / name, text_of(bytes));
    testing::put(folder_ / "a.glb", Parts().glb());
    const testing::Ended ended = run("optimize a.glb -o b.glb -p 'displacement(map=\"" + name +
                                     "\", factor=0.5), displacement-seams, tessellate(parts=4)' --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << ended.err;
    EXPECT_EQ(ended.err.find("warning"), std::string::npos) << ended.err;
    EXPECT_EQ((ended.out + ended.err).find("5 texels of the map are not numbers from 0 to 1") != std::string::npos,
              name == "float.exr")
        << ended.out << ended.err;
    const std::string made = testing::content(folder_ / "b.glb");
    Diagnostics diagnostics;
    const auto scene = read_gltf(testing::bytes_of(made), "b.glb", {}, diagnostics, {});
    ASSERT_TRUE(scene);
    EXPECT_EQ(scene->draws[0].full().stream().triangle_count(), 32u * 24);
    for (const glm::vec3& at : decode_vec3(*scene->draws[0].full().vertices->find("POSITION")))
      EXPECT_TRUE(at.z >= 0 && at.z <= 0.5f) << at.z;
  }
}

TEST_F(DisplacedMaps, TheColourSpaceOfAMapChangesNoHeight) {
  const auto plain = testing::png_of({32, 32, 1, 8}, noise(1024, 8));
  std::vector<std::string> made;
  for (const auto& bytes : {plain, tagged_srgb(plain)}) {
    testing::put(folder_ / "heights.png", text_of(bytes));
    testing::put(folder_ / "a.glb", Parts().glb());
    const testing::Ended ended =
        run("optimize a.glb -o b.glb -p 'displacement(map=\"heights.png\"), tessellate(parts=4)' --with vertex-cache");
    EXPECT_EQ(ended.code, 0) << ended.err;
    made.push_back(testing::content(folder_ / "b.glb"));
  }
  EXPECT_NE(plain, tagged_srgb(plain));
  Diagnostics diagnostics;
  const auto a = read_gltf(testing::bytes_of(made[0]), "a", {}, diagnostics, {});
  const auto b = read_gltf(testing::bytes_of(made[1]), "b", {}, diagnostics, {});
  ASSERT_TRUE(a && b);
  EXPECT_EQ(decode_vec3(*a->draws[0].full().vertices->find("POSITION")),
            decode_vec3(*b->draws[0].full().vertices->find("POSITION")));
}

TEST_F(DisplacedMaps, MapsThatCannotBeReadAreTold) {
  const std::string whole = text_of(testing::png_of({32, 32, 1, 16}, noise(1024, 16)));
  const std::vector<std::tuple<std::string, std::string, std::string>> maps = {
      {"missing.png", "", "is missing"},
      {"cut.png", whole.substr(0, whole.size() / 2), "damaged"},
      {"head.png", whole.substr(0, 20), "damaged"},
      {"text.png", "no picture", "is not an image"},
      {"texture.ktx2", std::string("\xABKTX 20\xBB\r\n\x1A\n", 12) + std::string(100, '\0'), "KTX2"}};
  for (const auto& [name, bytes, words] : maps) {
    SCOPED_TRACE(name);
    if (!bytes.empty()) testing::put(folder_ / name, bytes);
    Parts parts;
    parts.map = name;
    testing::put(folder_ / "a.glb", parts.glb());
    // Named by the file, it costs the displacement. Each stage says why it does nothing.
    const testing::Ended kept =
        run("optimize a.glb -o b.glb -p 'displacement-seams, tessellation-levels, tessellate' --with seam-gap");
    EXPECT_EQ(kept.code, 0) << kept.err;
    const std::string all = kept.out + kept.err;
    for (const char* stage :
         {"not repaired: its map cannot be read", "no levels: ", "not tessellated: ", "not measured: "}) {
      const std::size_t at = all.find(stage);
      ASSERT_NE(at, std::string::npos) << stage << '\n' << all;
      const std::string line = all.substr(at, all.find('\n', at) - at);
      EXPECT_NE(line.find(name), std::string::npos) << line;
      EXPECT_NE(line.find(words), std::string::npos) << line;
    }
    EXPECT_EQ(all.find("0 seam edges"), std::string::npos) << "of a layout that nobody looked at";
    EXPECT_EQ(all.find("error of 0"), std::string::npos) << "that nobody measured";
    // Named by an option, it ends the run before anything is written.
    std::filesystem::remove(folder_ / "b.glb");
    const testing::Ended refused = run("optimize a.glb -o b.glb -p 'displacement(map=\"" + name + "\")'");
    EXPECT_EQ(refused.code, 1) << refused.err;
    EXPECT_NE(refused.err.find(name + " cannot be read"), std::string::npos) << refused.err;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "b.glb"));
  }
}

#endif

}  // namespace
}  // namespace foredraw::displaced_maps_test
