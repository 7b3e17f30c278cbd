#include <foredraw/io/image/images.h>

#include <foredraw/base/random.h>

#include <gtest/gtest.h>

#include <stdexcept>

namespace foredraw::png_test {
namespace {

Texels noise(ImageFacts facts) {
  Random random(7);
  Texels texels{facts, {}};
  const std::size_t bytes =
      std::size_t{facts.width} * facts.height * static_cast<std::size_t>(facts.channels * facts.bits / 8);
  for (std::size_t i = 0; i < bytes; ++i) texels.bytes.push_back(static_cast<std::byte>(random.below(256)));
  return texels;
}

TEST(EncodePng, ComesBackToTheBit) {
  for (const int channels : {1, 2, 3, 4}) {
    for (const int bits : {8, 16}) {
      if (channels % 2 == 0 && bits == 16) continue;
      const Texels texels = noise({37, 21, channels, bits});
      Diagnostics diagnostics;
      const auto again = decode_image(encode_png(texels), {}, diagnostics);
      ASSERT_TRUE(again) << to_text(diagnostics);
      EXPECT_EQ(again->facts, texels.facts);
      EXPECT_EQ(again->bytes, texels.bytes);
    }
  }
}

TEST(EncodePng, TakesOnlyWholeImagesThatPngHas) {
  EXPECT_THROW(encode_png(noise({4, 4, 2, 16})), std::invalid_argument);
  EXPECT_THROW(encode_png(noise({4, 4, 5, 8})), std::invalid_argument);
  EXPECT_THROW(encode_png(noise({4, 4, 4, 16})), std::invalid_argument);
  EXPECT_THROW(encode_png(noise({4, 4, 1, 32})), std::invalid_argument);
  EXPECT_THROW(encode_png({{0, 0, 1, 8}, {}}), std::invalid_argument);
  Texels cut = noise({4, 4, 1, 8});
  cut.bytes.pop_back();
  EXPECT_THROW(encode_png(cut), std::invalid_argument);
}

}  // namespace
}  // namespace foredraw::png_test
