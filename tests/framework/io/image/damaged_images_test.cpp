// Images that are damaged, no images at all, or claim more than they have: decoded or refused, and told.
#include <foredraw/base/random.h>
#include <foredraw/io/image/images.h>

#include <gtest/gtest.h>

#include "smooth_values.h"
#include "support/gltf_builder.h"
#include "support/image_builder.h"

namespace foredraw::damaged_images_test {
namespace {

using testing::values_of;

std::string code_of(std::span<const std::byte> bytes, const ImageLimits& limits = {}) {
  Diagnostics diagnostics;
  const auto texels = decode_image(bytes, {.file = "image"}, diagnostics, limits);
  EXPECT_EQ(texels.has_value(), diagnostics.empty());
  return texels ? "" : diagnostics.all().at(0).code;
}

void set(std::vector<std::byte>& file, std::size_t at, std::initializer_list<int> bytes) {
  for (const int byte : bytes) file[at++] = static_cast<std::byte>(byte);
}

TEST(DamagedImages, claims_beyond_the_bytes_are_refused_before_anything_is_allocated) {
  const ImageLimits no_limit{~std::uint64_t{0}};
  const ImageFacts facts{16, 16, 3, 8};
  auto png = testing::png_of(facts, values_of(facts));
  set(png, 16, {0, 0, 0xea, 0x60, 0, 0, 0xea, 0x60});  // 60000 x 60000
  EXPECT_EQ(image_facts(png)->width, 60000u);
  EXPECT_EQ(code_of(png), "image-size");
  EXPECT_EQ(code_of(png, no_limit), "image-size");
  auto jpeg = testing::jpeg_of(facts, values_of(facts));
  for (std::size_t i = 0; i + 9 < jpeg.size(); ++i) {
    if (jpeg[i] == std::byte{0xff} && jpeg[i + 1] == std::byte{0xc0}) set(jpeg, i + 5, {0xea, 0x60, 0xea, 0x60});
  }
  EXPECT_EQ(code_of(jpeg, no_limit), "image-size");
  auto tga = testing::tga_of(facts, values_of(facts));
  set(tga, 12, {0x60, 0xea, 0x60, 0xea});
  EXPECT_EQ(code_of(tga, no_limit), "image-size");
  for (const char* compression : {"none", "rle", "zip"}) {
    auto exr = testing::exr_of({16, 16, 3, 16, true}, std::vector<float>(768, 0.5f), compression);
    const std::string text(reinterpret_cast<const char*>(exr.data()), exr.size());
    const std::size_t window = text.find("box2i", text.find("dataWindow")) + 6 + 4;
    set(exr, window + 8, {0x5f, 0xea, 0, 0, 0x5f, 0xea, 0, 0});
    ASSERT_EQ(image_facts(exr)->width, 60000u);
    EXPECT_EQ(code_of(exr, no_limit), "image-size") << compression;
  }
}

TEST(DamagedImages, damage_that_decoders_pass_by_is_told) {
  const ImageFacts facts{16, 16, 4, 8};
  auto tga = testing::tga_of(facts, values_of(facts));
  EXPECT_EQ(code_of(tga), "");
  tga.resize(tga.size() / 2);
  EXPECT_NE(code_of(tga), "");
  auto png = testing::png_of(facts, values_of(facts));
  const std::string text(reinterpret_cast<const char*>(png.data()), png.size());
  const std::size_t data = text.find("IDAT");
  png[data + 12] ^= std::byte{1};
  EXPECT_NE(code_of(png), "");
}

TEST(DamagedImages, limit_is_an_option) {
  const ImageFacts facts{16, 16, 3, 8};
  const auto png = testing::png_of(facts, values_of(facts));
  EXPECT_EQ(code_of(png, {256}), "");
  EXPECT_EQ(code_of(png, {255}), "image-size");
}

TEST(DamagedImages, other_files_are_none) {
  for (const char* text :
       {"", "P6 1 1 255", "no real picture!", "\x89PNG", "\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "glTF", "II*"}) {
    EXPECT_EQ(image_facts(testing::bytes_of(text)), std::nullopt) << text;
    EXPECT_EQ(code_of(testing::bytes_of(text)), "image-kind") << text;
  }
  EXPECT_EQ(image_facts(std::vector<std::byte>(1000)), std::nullopt);
}

TEST(DamagedImages, damaged_ones_are_decoded_or_refused) {
  const ImageFacts facts{16, 16, 3, 8};
  const ImageFacts halves{16, 16, 3, 16, true};
  const std::vector<float> floats(768, 0.5f);
  Random random(3);
  for (const auto& whole : {testing::png_of(facts, values_of(facts)), testing::jpeg_of(facts, values_of(facts)),
                            testing::tga_of(facts, values_of(facts)), testing::exr_of(halves, floats, "zip"),
                            testing::exr_of(halves, floats, "rle"), testing::exr_of(halves, floats, "none")}) {
    for (std::size_t length = 0; length < whole.size(); ++length) code_of(std::span(whole).first(length));
    for (int round = 0; round < 2000; ++round) {
      auto file = whole;
      for (std::uint64_t n = random.below(4) + 1; n > 0; --n)
        file[random.below(file.size())] = static_cast<std::byte>(random.below(256));
      code_of(file);
    }
  }
}

TEST(DamagedImages, jpeg_tables_of_too_many_codes_are_refused) {
  const ImageFacts facts{16, 16, 3, 8};
  auto file = testing::jpeg_of(facts, values_of(facts));
  int tables = 0;
  for (std::size_t i = 2; i + 20 < file.size(); ++i) {
    if (file[i] != std::byte{0xff} || file[i + 1] != std::byte{0xc4}) continue;
    ++tables;
    auto damaged = file;
    std::fill_n(damaged.begin() + static_cast<std::ptrdiff_t>(i) + 5, 16, std::byte{0x11});  // 272 codes
    EXPECT_EQ(code_of(damaged), "image-data") << tables;
  }
  EXPECT_GT(tables, 0);
}

}  // namespace
}  // namespace foredraw::damaged_images_test
