#include <foredraw/io/images.h>

#include <foredraw/io/private/image_exr.h>
#include <foredraw/io/private/image_headers.h>
#include <foredraw/io/private/image_stb.h>

#include <fmt/format.h>

namespace foredraw {

std::optional<ImageFacts> image_facts(std::span<const std::byte> bytes) {
  const auto header = images::header_of(bytes);
  return header ? std::optional(header->facts) : std::nullopt;
}

std::optional<Texels> decode_image(std::span<const std::byte> bytes, const Where& where, Diagnostics& diagnostics,
                                   const ImageLimits& limits) {
  const auto header = images::header_of(bytes);
  if (!header) {
    diagnostics.error(where, "image-kind", "is no image that can be decoded, or its header is damaged",
                      "PNG, JPEG, TGA and OpenEXR can be");
    return std::nullopt;
  }
  const ImageFacts& facts = header->facts;
  const std::uint64_t texels = std::uint64_t{facts.width} * facts.height;
  if (texels > limits.texels) {
    diagnostics.error(
        where, "image-size",
        fmt::format("has {} x {} texels, more than the limit of {}", facts.width, facts.height, limits.texels));
    return std::nullopt;
  }
  if (texels > header->most_texels) {
    diagnostics.error(
        where, "image-size",
        fmt::format("claims {} x {} texels, which its {} bytes can not hold", facts.width, facts.height, bytes.size()),
        "it was cut off or damaged");
    return std::nullopt;
  }
  const bool is_exr = header->kind == images::Kind::exr;
  auto made = is_exr ? images::exr_texels(bytes) : images::stb_texels(bytes, *header);
  if (const std::string* why = std::get_if<std::string>(&made)) {
    diagnostics.error(where, "image-data", "can not be decoded: " + *why);
    return std::nullopt;
  }
  Texels result{facts, std::move(std::get<std::vector<std::byte>>(made))};
  result.facts.bits = is_exr ? 32 : facts.bits > 8 ? 16 : 8;
  return result;
}

}  // namespace foredraw
