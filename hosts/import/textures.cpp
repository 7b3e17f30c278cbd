#include "textures.h"

#include <span>

namespace foredraw::import {

namespace {

/// nullptr: neither of the two kinds that glTF knows.
const char* mime_type(const std::string& bytes) {
  if (bytes.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (bytes.starts_with("\xff\xd8\xff")) return "image/jpeg";
  return nullptr;
}

}  // namespace

std::string Textures::content(const std::string& named) const {
  if (const aiTexture* embedded = scene_.GetEmbeddedTexture(named.c_str())) {
    if (embedded->mHeight != 0) return {};  // texels without a file
    return {reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth};
  }
  const auto file = files_.found(named);
  return file.empty() ? std::string() : files_.content(file);
}

std::optional<std::size_t> Textures::image(const std::string& named) {
  const auto [place, is_new] = images_.try_emplace(named);
  if (!is_new) return place->second;
  const std::string bytes = content(named);
  const char* type = mime_type(bytes);
  if (type == nullptr) {
    told_.left_out.push_back("its texture '" + named + "' is left out: " +
                             (bytes.empty() ? "it is not there, or not where the scene may read"
                                            : "glTF takes PNG and JPEG, and it is neither"));
    return std::nullopt;
  }
  const std::size_t view = glb_.add_view(std::as_bytes(std::span(bytes)));
  return place->second = glb_.add("images", {{"name", named}, {"bufferView", view}, {"mimeType", type}});
}

std::optional<std::size_t> Textures::texture(const std::string& named, int wrap_u, int wrap_v) {
  const auto source = image(named);
  if (!source) return std::nullopt;
  const auto [place, is_new] = samplers_.try_emplace({wrap_u, wrap_v}, 0);
  if (is_new) place->second = glb_.add("samplers", {{"wrapS", wrap_u}, {"wrapT", wrap_v}});
  return glb_.add("textures", {{"source", *source}, {"sampler", place->second}});
}

}  // namespace foredraw::import
