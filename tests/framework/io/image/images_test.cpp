// Images read and written: what was put in comes out.
#include <foredraw/io/gltf/gltf.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/image/picture.h>
#include <foredraw/io/image/private/encode.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include "smooth_values.h"
#include "support/gltf_builder.h"
#include "support/image_builder.h"
#include "support/test_folder.h"

namespace foredraw::images_test {
namespace {

using testing::Values;
using testing::values_of;

Values values_in(const Texels& texels) {
  Values values;
  const std::size_t width = static_cast<std::size_t>(texels.facts.bits) / 8;
  for (std::size_t i = 0; i < texels.bytes.size(); i += width) {
    std::uint16_t value = 0;
    std::memcpy(&value, texels.bytes.data() + i, width);
    values.push_back(value);
  }
  return values;
}

std::vector<float> floats_in(const Texels& texels) {
  std::vector<float> values(texels.bytes.size() / sizeof(float));
  std::memcpy(values.data(), texels.bytes.data(), texels.bytes.size());
  return values;
}

TEST(Images, png_comes_out_as_it_went_in) {
  for (const int bits : {8, 16}) {
    for (int channels = 1; channels <= 4; ++channels) {
      const ImageFacts facts{37, 21, channels, bits};
      const auto file = testing::png_of(facts, values_of(facts));
      EXPECT_EQ(image_facts(file), facts);
      Diagnostics diagnostics;
      const auto texels = decode_image(file, {.file = "image"}, diagnostics);
      ASSERT_TRUE(texels) << to_text(diagnostics);
      EXPECT_EQ(texels->facts, facts);
      EXPECT_EQ(values_in(*texels), values_of(facts)) << channels << " of " << bits;
    }
  }
}

TEST(Images, kinds_that_pass_through_are_named_where_they_would_have_to_be_decoded) {
  const std::pair<std::string, const char*> kinds[] = {
      {"\xabKTX 20\xbb\r\n\x1a\n----", "is KTX2, which cannot be decoded"},
      {"RIFF----WEBPVP8L", "is WebP, which cannot be decoded"},
      {"----ftypavif----", "is AVIF, which cannot be decoded"},
      {"DDS ------------", "is DDS, which cannot be decoded"},
      {"RIFF----WAVEfmt ",
       "is not an image of a supported kind, or its "
       "header is damaged"}};
  for (const auto& [text, message] : kinds) {
    const auto bytes = std::as_bytes(std::span(text));
    EXPECT_FALSE(image_facts(bytes));
    Diagnostics diagnostics;
    EXPECT_FALSE(decode_image(bytes, {.file = "image"}, diagnostics));
    EXPECT_EQ(diagnostics.all().at(0).message, message);
    EXPECT_EQ(diagnostics.all().at(0).hint, "PNG, JPEG, TGA and OpenEXR are supported");
  }
}

TEST(Images, jpeg_comes_out_nearly_as_it_went_in) {
  for (const int channels : {1, 3}) {
    const ImageFacts facts{37, 21, channels, 8};
    const auto file = testing::jpeg_of(facts, values_of(facts));
    Diagnostics diagnostics;
    const auto texels = decode_image(file, {.file = "image"}, diagnostics);
    ASSERT_TRUE(texels) << to_text(diagnostics);
    EXPECT_EQ(texels->facts, *image_facts(file));
    EXPECT_EQ(texels->facts.width, 37u);
    const Values now = values_in(*texels), before = values_of(facts);
    const std::size_t stored = static_cast<std::size_t>(texels->facts.channels);  // the writer makes three of one
    for (std::size_t i = 0; i < before.size() / static_cast<std::size_t>(channels); ++i) {
      EXPECT_NEAR(now[i * stored], before[i * static_cast<std::size_t>(channels)], 8);
    }
  }
}

TEST(Images, tga_comes_out_as_it_went_in) {
  for (const int channels : {1, 3, 4}) {
    const ImageFacts facts{37, 21, channels, 8};
    const auto file = testing::tga_of(facts, values_of(facts));
    EXPECT_EQ(image_facts(file), facts);
    Diagnostics diagnostics;
    const auto texels = decode_image(file, {.file = "image"}, diagnostics);
    ASSERT_TRUE(texels) << to_text(diagnostics);
    EXPECT_EQ(values_in(*texels), values_of(facts)) << channels;
  }
}

TEST(Images, exr_comes_out_as_it_went_in) {
  for (const char* compression : {"none", "rle", "zips", "zip"}) {
    for (const int bits : {16, 32}) {
      for (const int channels : {1, 3, 4}) {
        const ImageFacts facts{19, 37, channels, bits, true};
        std::vector<float> values;
        for (std::size_t i = 0; i < 19 * 37 * static_cast<std::size_t>(channels); ++i) {
          values.push_back(static_cast<float>(static_cast<int>(i % 97) - 40) / 16);  // halves hold these exactly
        }
        const auto file = testing::exr_of(facts, values, compression);
        ASSERT_EQ(image_facts(file), facts) << compression;
        Diagnostics diagnostics;
        const auto texels = decode_image(file, {.file = "image"}, diagnostics);
        ASSERT_TRUE(texels) << compression << ' ' << to_text(diagnostics);
        EXPECT_EQ(floats_in(*texels), values) << compression << ' ' << channels << " of " << bits;
      }
    }
  }
}

TEST(Images, exr_that_can_not_be_decoded_is_named) {
  const auto piz = testing::exr_of({8, 8, 3, 16, true}, std::vector<float>(192, 0.5f), "piz");
  Diagnostics diagnostics;
  EXPECT_FALSE(decode_image(piz, {.file = "image"}, diagnostics));
  EXPECT_NE(to_text(diagnostics).find("PIZ"), std::string::npos) << to_text(diagnostics);
}

TEST(Images, a_tga_may_begin_at_the_right) {
  const ImageFacts facts{5, 3, 4, 8};
  const auto values = values_of(facts);
  auto tga = testing::tga_of(facts, values);
  tga[17] |= std::byte{0x10};
  Diagnostics diagnostics;
  const auto texels = decode_image(tga, {.file = "image"}, diagnostics);
  ASSERT_TRUE(texels) << to_text(diagnostics);
  const auto turned = values_in(*texels);
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 5; ++column) {
      for (std::size_t k = 0; k < 4; ++k) {
        EXPECT_EQ(turned[(row * 5 + column) * 4 + k], values[(row * 5 + 4 - column) * 4 + k]);
      }
    }
  }
}

TEST(Images, facts_are_known_of_a_scene_that_was_read) {
  const ImageFacts facts{16, 8, 4, 16};
  testing::GltfBuilder builder;
  builder.add("images",
              {{"bufferView", builder.add_view(testing::png_of(facts, values_of(facts)))}, {"mimeType", "image/jpeg"}});
  builder.add("images", {{"uri", "elsewhere.png"}});
  Diagnostics diagnostics;
  const auto scene = read_gltf(builder.glb(), "scene", {}, diagnostics);
  ASSERT_TRUE(scene) << to_text(diagnostics);
  EXPECT_EQ(scene->images[0].facts, facts) << "by content, whatever the name says";
  EXPECT_EQ(scene->images[1].facts, std::nullopt);
}

TEST(Images, are_decoded_for_analyses_from_the_scene_or_from_beside_it) {
  const ImageFacts facts{3, 2, 4, 8};
  const std::vector<std::byte> png = testing::png_of(facts, values_of(facts));
  const testing::TestFolder own;
  const std::filesystem::path folder = own.path() / "images beside";
  std::filesystem::create_directories(folder / "inner");
  std::ofstream(folder / "inner" / "a leaf.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(png.data()), static_cast<std::streamsize>(png.size()));
  Image image;
  image.name = "leaf";
  image.bytes = Shared<std::byte>(std::vector<std::byte>(png));
  const auto texels = [&](const std::filesystem::path& scene_file) { return image_decoder(scene_file)(image); };
  const auto why_not = [&](const std::filesystem::path& scene_file) {
    return std::get<std::string>(texels(scene_file));
  };
  EXPECT_EQ(std::get<Texels>(texels({})).facts, facts);
  image.bytes = {};
  image.uri = "inner/a%20leaf.png";
  EXPECT_EQ(std::get<Texels>(texels(folder / "scene.gltf")).facts, facts);
  EXPECT_EQ(why_not({}), "the image 'inner/a%20leaf.png' cannot be found: the file that names it has no folder");
  EXPECT_EQ(why_not(folder / "inner" / "scene.gltf"), "the image 'inner/a%20leaf.png' is missing");
  image.uri = "../inner/a%20leaf.png";
  EXPECT_EQ(why_not(folder / "inner" / "scene.gltf"),
            "the image '../inner/a%20leaf.png' leads out of the file's folder");
  const ImageDecoder within = image_decoder(folder / "inner" / "scene.gltf", folder);
  EXPECT_EQ(std::get<Texels>(within(image)).facts, facts);
  image.uri.clear();
  EXPECT_EQ(why_not(folder / "scene.gltf"),
            "the image 'leaf' is not an image of a supported kind, or its header is damaged");
}

TEST(Images, a_file_beside_the_scene_that_cannot_be_read_is_told) {
  Image image;
  image.uri = "mem";  // opens, but nobody may read what lies at 0
  if (!std::filesystem::exists("/proc/self/mem")) GTEST_SKIP() << "this system has no such file";
  const auto texels = image_decoder("/proc/self/scene.gltf")(image);
  EXPECT_EQ(std::get<std::string>(texels).rfind("cannot be read: ", 0), 0u) << std::get<std::string>(texels);
}

TEST(Images, of_16_bits_become_the_nearest_of_8) {
  const ImageFacts facts{256, 256, 1, 16};
  Values values(std::size_t{256} * 256);
  std::iota(values.begin(), values.end(), std::uint16_t{0});
  Image image;
  image.bytes = Shared<std::byte>(testing::png_of(facts, values));
  const auto rgba = images::rgba_of(image);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto nearest = static_cast<std::uint8_t>(std::lround(values[i] / 65535.0 * 255));
    differing += std::get<images::Rgba>(rgba).values[4 * i] == nearest ? 0 : 1;
  }
  EXPECT_EQ(differing, 0u);
}

TEST(Images, pictures_have_letters_for_all_of_ascii) {
  const auto written = [](const std::string& text) {
    images::Picture picture(20, 20, {0, 0, 0});
    picture.write(4, 4, text, {255, 255, 255});
    return picture.as_png();
  };
  for (char c = ' '; c <= '~'; ++c) EXPECT_EQ(written({c}) == written("?"), c == '?') << c;
  EXPECT_EQ(written("\t"), written("?"));
  EXPECT_EQ(written("\x7f"), written("?"));
}

TEST(Images, pixels_are_encoded_as_they_are) {
  const auto decoded = [](const std::vector<std::byte>& png) {
    Diagnostics diagnostics;
    return decode_image(png, {}, diagnostics).value();
  };
  const std::vector<std::uint8_t> coloured{1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5, 6, 6, 7};
  const Texels colours = decoded(images::png_of_pixels(2, 3, coloured));
  EXPECT_EQ(colours.facts.width, 2u);
  EXPECT_EQ(colours.facts.height, 3u);
  EXPECT_EQ(colours.facts.channels, 3);
  for (std::size_t i = 0; i < coloured.size(); ++i) EXPECT_EQ(std::to_integer<int>(colours.bytes[i]), coloured[i]);

  const Texels greys = decoded(images::png_of_pixels(3, 1, std::vector<std::uint8_t>{1, 1, 1, 9, 9, 9, 3, 3, 3}));
  EXPECT_EQ(greys.facts.channels, 1);
  EXPECT_EQ(greys.bytes.size(), 3u);
  EXPECT_EQ(std::to_integer<int>(greys.bytes[1]), 9);
}

TEST(Images, pixels_that_do_not_fill_the_picture_are_refused) {
  const std::vector<std::uint8_t> six(6);
  EXPECT_THROW(images::png_of_pixels(2, 2, six), std::invalid_argument);
  EXPECT_THROW(images::png_of_pixels(1, 1, six), std::invalid_argument);
  EXPECT_THROW(images::png_of_pixels(-2, -1, six), std::invalid_argument);
  EXPECT_THROW(images::png_of_pixels(0, 0, {}), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::images_test
