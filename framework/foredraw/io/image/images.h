#pragma once
// Images: what their headers say, and their texels. PNG, JPEG, TGA and OpenEXR, told apart by content and not by name.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/diagnostics.h>
#include <foredraw/base/files_read.h>
#include <foredraw/scene/texture.h>

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// From the header alone, in no time. nullopt where it is none that we know, or the header is damaged.
std::optional<ImageFacts> image_facts(std::span<const std::byte> bytes);

struct ImageLimits {
  std::uint64_t texels = std::uint64_t{1} << 28;  ///< width times height: 16384 squared
};

/// As above, with an error at `where` for what decode_image would refuse by its header.
std::optional<ImageFacts> checked_image_facts(std::span<const std::byte> bytes, const Where& where,
                                              Diagnostics& diagnostics, const ImageLimits& limits = {});

/// Decodes an image. nullopt, with an error at `where`, for what is damaged, is of another kind, exceeds the limits, or
/// claims more texels than its bytes can hold at its format's best compression: that is known before anything is
/// allocated.
std::optional<Texels> decode_image(std::span<const std::byte> bytes, const Where& where, Diagnostics& diagnostics,
                                   const ImageLimits& limits = {});

/// A PNG of grey or RGB texels of 8 or 16 bits, or of such with alpha of 8 bits; std::invalid_argument for others.
std::vector<std::byte> encode_png(const Texels& texels);

/// What analyses of a scene decode its images with: those that it holds, and those beside the file that it was read
/// from, unless that is empty, or below the root (SceneInput::root). `files` is told of those that are read.
ImageDecoder image_decoder(const std::filesystem::path& scene_file, const std::filesystem::path& root = {},
                           const std::shared_ptr<FilesRead>& files = nullptr);

}  // namespace foredraw
