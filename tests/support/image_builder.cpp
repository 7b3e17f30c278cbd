// By other libraries than those that read them, where there are some.
#include "support/image_builder.h"

#include <tinyexr.h>
#include <zlib.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

#include <cstdlib>
#include <cstring>

namespace foredraw::testing {

namespace {

void put_big(std::vector<std::byte>& to, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) to.push_back(static_cast<std::byte>(value >> shift));
}

void put_chunk(std::vector<std::byte>& to, const std::string& type, const std::vector<std::byte>& bytes) {
  put_big(to, static_cast<std::uint32_t>(bytes.size()));
  const std::size_t from = to.size();
  for (const char c : type) to.push_back(static_cast<std::byte>(c));
  to.insert(to.end(), bytes.begin(), bytes.end());
  put_big(to, static_cast<std::uint32_t>(
                  crc32(0, reinterpret_cast<const Bytef*>(to.data() + from), static_cast<uInt>(to.size() - from))));
}

std::vector<unsigned char> narrow(const std::vector<std::uint16_t>& values) { return {values.begin(), values.end()}; }

void append(void* to, void* data, int size) {
  auto& bytes = *static_cast<std::vector<std::byte>*>(to);
  const auto* from = static_cast<const std::byte*>(data);
  bytes.insert(bytes.end(), from, from + size);
}

}  // namespace

std::vector<std::byte> png_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values) {
  std::vector<std::byte> rows;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i % (std::size_t{facts.width} * static_cast<std::size_t>(facts.channels)) == 0)
      rows.push_back(std::byte{0});  // no filter
    if (facts.bits == 16) rows.push_back(static_cast<std::byte>(values[i] >> 8));
    rows.push_back(static_cast<std::byte>(values[i] & 0xff));
  }
  std::vector<std::byte> packed(compressBound(rows.size()));
  uLongf length = packed.size();
  compress(reinterpret_cast<Bytef*>(packed.data()), &length, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  packed.resize(length);

  std::vector<std::byte> file, head;
  for (const int c : {0x89, 'P' + 0, 'N' + 0, 'G' + 0, 13, 10, 26, 10}) file.push_back(static_cast<std::byte>(c));
  put_big(head, facts.width);
  put_big(head, facts.height);
  constexpr int colour_types[] = {0, 4, 2, 6};
  for (const int c : {facts.bits, colour_types[facts.channels - 1], 0, 0, 0}) head.push_back(static_cast<std::byte>(c));
  put_chunk(file, "IHDR", head);
  put_chunk(file, "IDAT", packed);
  put_chunk(file, "IEND", {});
  return file;
}

std::vector<std::byte> jpeg_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values) {
  std::vector<std::byte> file;
  stbi_write_jpg_to_func(append, &file, static_cast<int>(facts.width), static_cast<int>(facts.height), facts.channels,
                         narrow(values).data(), 100);
  return file;
}

std::vector<std::byte> tga_of(const ImageFacts& facts, const std::vector<std::uint16_t>& values) {
  std::vector<std::byte> file;
  stbi_write_tga_to_func(append, &file, static_cast<int>(facts.width), static_cast<int>(facts.height), facts.channels,
                         narrow(values).data());
  return file;
}

std::vector<std::byte> exr_of(const ImageFacts& facts, const std::vector<float>& values,
                              const std::string& compression) {
  const auto channels = static_cast<std::size_t>(facts.channels);
  const std::string names = facts.channels == 1   ? "Y"
                            : facts.channels == 3 ? "BGR"
                                                  : "ABGR";  // the alphabet's sequence
  const std::string as_given = facts.channels == 1 ? "Y" : "RGBA";
  std::vector<std::vector<float>> planes(channels);
  std::vector<unsigned char*> pointers;
  std::vector<EXRChannelInfo> infos(channels);
  std::vector<int> given(channels, TINYEXR_PIXELTYPE_FLOAT),
      wanted(channels, facts.bits == 16 ? TINYEXR_PIXELTYPE_HALF : TINYEXR_PIXELTYPE_FLOAT);
  for (std::size_t c = 0; c < channels; ++c) {
    for (std::size_t i = as_given.find(names[c]); i < values.size(); i += channels) planes[c].push_back(values[i]);
    pointers.push_back(reinterpret_cast<unsigned char*>(planes[c].data()));
    infos[c].name[0] = names[c];
    infos[c].name[1] = '\0';
  }
  EXRHeader header;
  EXRImage image;
  InitEXRHeader(&header);
  InitEXRImage(&image);
  image.images = pointers.data();
  image.width = static_cast<int>(facts.width);
  image.height = static_cast<int>(facts.height);
  image.num_channels = header.num_channels = facts.channels;
  header.channels = infos.data();
  header.pixel_types = given.data();
  header.requested_pixel_types = wanted.data();
  header.compression_type = compression == "none"   ? TINYEXR_COMPRESSIONTYPE_NONE
                            : compression == "rle"  ? TINYEXR_COMPRESSIONTYPE_RLE
                            : compression == "zips" ? TINYEXR_COMPRESSIONTYPE_ZIPS
                            : compression == "zip"  ? TINYEXR_COMPRESSIONTYPE_ZIP
                                                    : TINYEXR_COMPRESSIONTYPE_PIZ;
  unsigned char* memory = nullptr;
  const char* error = nullptr;
  const std::size_t size = SaveEXRImageToMemory(&image, &header, &memory, &error);
  const auto* from = reinterpret_cast<const std::byte*>(memory);
  std::vector<std::byte> file(from, from + size);
  std::free(memory);
  return file;
}

}  // namespace foredraw::testing
