#include <foredraw/io/image/images.h>

#include <foredraw/io/image/private/exr.h>
#include <foredraw/io/image/private/headers.h>
#include <foredraw/io/image/private/stb.h>
#include <foredraw/io/text/private/file_beside.h>
#include <foredraw/platform/files.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

/// Or why it is not read.
std::variant<std::vector<std::byte>, std::string> bytes_beside(const std::string& uri, const FilePlaces& where) {
  const FileBeside beside = uri_beside(uri, where);
  if (!beside.why_not.empty()) return fmt::format("the image '{}' {}", uri, beside.why_not);
  Diagnostics reading;
  auto bytes = read_file(beside.path, reading, FileRead::all_of_it, where.files.get());
  if (!bytes) return reading.all().front().message;
  return std::move(*bytes);
}

/// Of an image that may be decoded; or an error.
std::optional<images::Header> checked_header(std::span<const std::byte> bytes, const Where& where,
                                             Diagnostics& diagnostics, const ImageLimits& limits) {
  const auto header = images::header_of(bytes);
  if (!header) {
    const std::string_view kind = images::undecoded_kind(bytes);
    diagnostics.error(where, "image-kind",
                      kind.empty() ? "is not an image of a supported kind, or its header is damaged"
                                   : fmt::format("is {}, which cannot be decoded", kind),
                      "PNG, JPEG, TGA and OpenEXR are supported");
    return std::nullopt;
  }
  const ImageFacts& facts = header->facts;
  const std::uint64_t texels = std::uint64_t{facts.width} * facts.height;
  if (texels > limits.texels) {
    diagnostics.error(
        where, "image-size",
        fmt::format("has {} x {} texels, more than the limit of {}", facts.width, facts.height, limits.texels),
        "scale it down");
    return std::nullopt;
  }
  if (texels > header->most_texels) {
    diagnostics.error(
        where, "image-size",
        fmt::format("claims {} x {} texels, which its {} bytes cannot hold", facts.width, facts.height, bytes.size()),
        "it is cut off or damaged");
    return std::nullopt;
  }
  return header;
}

}  // namespace

std::optional<ImageFacts> image_facts(std::span<const std::byte> bytes) {
  const auto header = images::header_of(bytes);
  return header ? std::optional(header->facts) : std::nullopt;
}

std::optional<ImageFacts> checked_image_facts(std::span<const std::byte> bytes, const Where& where,
                                              Diagnostics& diagnostics, const ImageLimits& limits) {
  const auto header = checked_header(bytes, where, diagnostics, limits);
  return header ? std::optional(header->facts) : std::nullopt;
}

std::optional<Texels> decode_image(std::span<const std::byte> bytes, const Where& where, Diagnostics& diagnostics,
                                   const ImageLimits& limits) {
  const auto header = checked_header(bytes, where, diagnostics, limits);
  if (!header) return std::nullopt;
  const bool is_exr = header->kind == images::Kind::exr;
  auto made = is_exr ? images::exr_texels(bytes) : images::stb_texels(bytes, *header);
  if (const std::string* why = std::get_if<std::string>(&made)) {
    diagnostics.error(where, "image-data", "cannot be decoded: " + *why, "save it again, or as a PNG");
    return std::nullopt;
  }
  Texels result{header->facts, std::move(std::get<std::vector<std::byte>>(made))};
  result.facts.bits = is_exr ? 32 : header->facts.bits > 8 ? 16 : 8;
  return result;
}

ImageDecoder image_decoder(const std::filesystem::path& scene_file, const std::filesystem::path& root,
                           const std::shared_ptr<FilesRead>& files) {
  const bool has_folder = scene_file.empty() || scene_file.has_parent_path();
  const FilePlaces where{has_folder ? scene_file.parent_path() : std::filesystem::path("."), root, files};
  return [where](const Image& image) -> std::variant<Texels, std::string> {
    std::span<const std::byte> bytes = image.bytes.view();
    std::variant<std::vector<std::byte>, std::string> file;
    if (!image.uri.empty()) {
      file = bytes_beside(image.uri, where);
      if (std::string* why = std::get_if<std::string>(&file)) return std::move(*why);
      bytes = std::get<std::vector<std::byte>>(file);
    }
    Diagnostics diagnostics;
    if (auto texels = decode_image(bytes, {}, diagnostics)) return std::move(*texels);
    return fmt::format("the image '{}' {}", image.uri.empty() ? image.name : image.uri,
                       diagnostics.all().front().message);
  };
}

}  // namespace foredraw
