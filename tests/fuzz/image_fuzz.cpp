// Whatever the bytes, decoding them ends well and within the limit; what is decoded has as many texels as its header
// says.

#include "claim.h"

#include <foredraw/io/image/images.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace foredraw;
  const auto bytes = std::as_bytes(std::span(data, size));
  Diagnostics diagnostics;
  const auto texels = decode_image(bytes, {.file = "input"}, diagnostics, {std::uint64_t{1} << 20});
  claim(texels.has_value() != diagnostics.has_errors(), "decoded and not decoded at once: " + to_text(diagnostics));
  const auto facts = image_facts(bytes);
  if (!texels) return 0;
  claim(facts.has_value(), "decoded without a header");
  const std::uint64_t values =
      std::uint64_t{facts->width} * facts->height * static_cast<std::uint64_t>(facts->channels);
  claim(texels->bytes.size() == values * static_cast<std::uint64_t>(texels->facts.bits) / 8,
        "the texels are not those that the header says");
  return 0;
}
