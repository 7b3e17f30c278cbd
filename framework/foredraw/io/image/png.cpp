#include <foredraw/io/image/images.h>

#include <png.h>

#include <stdexcept>
#include <string>

namespace foredraw {

std::vector<std::byte> encode_png(const Texels& texels) {
  const ImageFacts& facts = texels.facts;
  const auto bytes = static_cast<std::size_t>(facts.channels) * static_cast<std::size_t>(facts.bits / 8);
  const bool has_colour = facts.channels > 2, has_alpha = facts.channels % 2 == 0;
  // Of 16 bits, libpng would take colours as multiplied with alpha.
  const bool is_known =
      facts.channels >= 1 && facts.channels <= 4 && (facts.bits == 8 || (facts.bits == 16 && !has_alpha));
  if (!is_known || facts.width == 0 || texels.bytes.size() != bytes * facts.width * facts.height)
    throw std::invalid_argument(
        "only whole images of grey or RGB, with 8 or 16 bits a channel, and 8 with alpha, become PNG");
  png_image png = {};
  png.version = PNG_IMAGE_VERSION;
  png.width = facts.width;
  png.height = facts.height;
  // libpng calls 16 bits linear, and writes them as they are.
  png.format = (facts.bits == 16 ? PNG_FORMAT_FLAG_LINEAR : 0u) | (has_colour ? PNG_FORMAT_FLAG_COLOR : 0u) |
               (has_alpha ? PNG_FORMAT_FLAG_ALPHA : 0u);
  std::vector<std::byte> result(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = result.size();
  if (png_image_write_to_memory(&png, result.data(), &size, 0, texels.bytes.data(), 0, nullptr) == 0)
    throw std::runtime_error(std::string("the image cannot be encoded: ") + png.message);
  result.resize(size);
  return result;
}

}  // namespace foredraw
