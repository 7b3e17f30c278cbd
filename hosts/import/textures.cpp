#include "textures.h"

#include <foredraw/io/image/images.h>

#include <span>

namespace foredraw::import {

namespace {

struct Picture {
  std::string bytes = {};
  const char* type = nullptr;  ///< as glTF calls it; nullptr: it is none that glTF takes
};

/// PNG and JPEG as they are, TGA as a PNG of the same texels.
Picture picture_of(std::string bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return {std::move(bytes), "image/png"};
  if (bytes.starts_with("\xff\xd8\xff")) return {std::move(bytes), "image/jpeg"};
  Diagnostics unsaid;
  const auto texels = decode_image(std::as_bytes(std::span(bytes)), {}, unsaid);
  if (!texels || texels->facts.bits != 8) return {};
  const auto png = encode_png(*texels);
  return {{reinterpret_cast<const char*>(png.data()), png.size()}, "image/png"};
}

}  // namespace

void Textures::leave_out(const std::string& named, const std::string& why, const std::string& hint) {
  told_.left_out.push_back("its texture '" + named + "' is left out: " + why + '\n' + hint);
}

std::optional<std::size_t> Textures::image(const std::string& named) {
  const auto [place, is_new] = images_.try_emplace(named);
  if (!is_new || named.empty()) return place->second;
  std::string bytes;
  if (const aiTexture* embedded = scene_.GetEmbeddedTexture(named.c_str()); embedded != nullptr) {
    if (embedded->mHeight == 0) bytes.assign(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth);
  } else {
    const auto [file, is_outside] = files_.found(named);
    if (file.empty()) {
      leave_out(named,
                is_outside ? "it lies outside the scene's folder"
                           : "there is no such file, nor one of its name beside the scene",
                is_outside ? "give --root with a folder that holds both" : "put the picture beside the scene");
      return std::nullopt;
    }
    bytes = files_.content(file);
  }
  const Picture picture = picture_of(std::move(bytes));
  if (picture.type == nullptr) {
    leave_out(named, "it is no PNG, JPEG or TGA", "save it as PNG");
    return std::nullopt;
  }
  const std::size_t view = glb_.add_view(std::as_bytes(std::span(picture.bytes)));
  return place->second = glb_.add("images", {{"name", named}, {"bufferView", view}, {"mimeType", picture.type}});
}

std::optional<std::size_t> Textures::texture(const std::string& named, int wrap_u, int wrap_v) {
  const auto source = image(named);
  if (!source) return std::nullopt;
  const auto [place, is_new] = samplers_.try_emplace({wrap_u, wrap_v}, 0);
  if (is_new) place->second = glb_.add("samplers", {{"wrapS", wrap_u}, {"wrapT", wrap_v}});
  return glb_.add("textures", {{"source", *source}, {"sampler", place->second}});
}

}  // namespace foredraw::import
