// What is written of sprites, by the kind of file.
#include <foredraw/io/sprite/sprite_files.h>

#include <foredraw/io/gltf/private/source.h>
#include <foredraw/io/image/private/encode.h>
#include <foredraw/io/sprite/private/write.h>
#include <foredraw/io/text/private/file_kind.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

namespace fs = std::filesystem;
using sprites::Sheet;
using sprites::SpriteSource;
using MakeText = std::optional<std::string> (*)(std::span<const Sheet>, const fs::path&, Diagnostics&);

struct Writer {
  std::string_view extension;
  MakeText make;
};

constexpr Writer writers[] = {
    {".json", sprites::list_text}, {".h", sprites::header_text}, {".html", sprites::page_text}};

const Writer* writer_of(const fs::path& path) {
  const std::string extension = lower_extension(path);
  for (const Writer& writer : writers) {
    if (writer.extension == extension) return &writer;
  }
  return nullptr;
}

bool spares(const Scene& scene, const fs::path& file, Diagnostics& diagnostics) {
  const auto* source = dynamic_cast<const SpriteSource*>(scene.source.get());
  if (source == nullptr) return true;
  for (const fs::path& read : source->files) {
    std::error_code error;
    if (!fs::equivalent(read, file, error)) continue;
    diagnostics.error({.file = file.string()}, "replaces-input", "would replace a file that the sprites were read from",
                      "give the output another name or folder");
    return false;
  }
  return true;
}

/// What a glTF holds of sprites besides the scene: they are shown as they are, without light.
std::shared_ptr<const gltf::Source> unlit(const Scene& scene) {
  gltf::Document document;
  document.name = scene.name;
  document.json = JsonObject{{"asset", JsonObject{{"version", "2.0"}, {"generator", "foredraw"}}},
                             {"extensionsUsed", Json::array_t{"KHR_materials_unlit"}}};
  Scene as_read;
  for (std::size_t i = 0; i < scene.materials.size(); ++i) {
    as_read.materials.emplace_back();
    document.json["materials"].push_back(
        JsonObject{{"extensions", JsonObject{{"KHR_materials_unlit", Json::object()}}}});
  }
  return std::make_shared<const gltf::Source>(std::move(document), std::move(as_read));
}

}  // namespace

namespace sprites {

std::string image_beside(const Sheet& sheet, std::size_t image, const fs::path& target) {
  if (sheet.source == nullptr || image >= sheet.source->image_files.size()) return sheet.scene->images[image].name;
  const fs::path file = fs::absolute(sheet.source->image_files[image]).lexically_normal();
  const std::u8string text =
      file.lexically_relative(fs::absolute(target).lexically_normal().parent_path()).generic_u8string();
  return {text.begin(), text.end()};
}

std::string winding_of(std::span<const Sheet> sheets) {
  bool any_clockwise = false, any_counter_clockwise = false;
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      for (std::size_t i = 0; i + 2 < sprite.triangles.size(); i += 3) {
        const glm::dvec2 a = sprite.points[sprite.triangles[i]];
        const glm::dvec2 ab = sprite.points[sprite.triangles[i + 1]] - a,
                         ac = sprite.points[sprite.triangles[i + 2]] - a;
        const double turn = ab.x * ac.y - ab.y * ac.x;  // y is down
        any_clockwise = any_clockwise || turn > 0;
        any_counter_clockwise = any_counter_clockwise || turn < 0;
      }
    }
  }
  if (any_clockwise && any_counter_clockwise) return "either";
  return any_clockwise ? "clockwise" : "counter-clockwise";
}

}  // namespace sprites

bool is_sprite_output(const fs::path& path) { return writer_of(path) != nullptr; }

std::vector<std::string_view> sprite_output_extensions() {
  std::vector<std::string_view> extensions;
  for (const Writer& writer : writers) extensions.push_back(writer.extension);
  return extensions;
}

std::optional<OutputFile> encode_sprites(std::span<const Scene> scenes, const fs::path& target,
                                         Diagnostics& diagnostics) {
  const Writer* writer = writer_of(target);
  if (writer == nullptr) {
    diagnostics.error({.file = target.string()}, "unknown-kind", "sprites cannot be written as this kind of file",
                      fmt::format("use {}", fmt::join(sprite_output_extensions(), ", ")));
    return std::nullopt;
  }
  std::vector<Sheet> sheets;
  for (const Scene& scene : scenes) {
    if (!spares(scene, target, diagnostics)) return std::nullopt;
    auto drawn = sprites::drawn_sprites(scene, target, diagnostics);
    if (!drawn) return std::nullopt;
    sheets.push_back({&scene, dynamic_cast<const SpriteSource*>(scene.source.get()), std::move(*drawn)});
  }
  const auto text = writer->make(sheets, target, diagnostics);
  if (!text) return std::nullopt;
  const auto bytes = std::as_bytes(std::span(*text));
  return OutputFile{target, {bytes.begin(), bytes.end()}};
}

bool spares_its_inputs(const Scene& scene, std::span<const OutputFile> files, Diagnostics& diagnostics) {
  for (const OutputFile& file : files) {
    if (!spares(scene, file.path, diagnostics)) return false;
  }
  return true;
}

std::shared_ptr<const Scene> sprites_for_gltf(const Scene& scene, const fs::path& target, Diagnostics& diagnostics) {
  if (dynamic_cast<const SpriteSource*>(scene.source.get()) == nullptr) return {std::shared_ptr<void>(), &scene};
  const auto result = std::make_shared<Scene>(scene);
  for (Image& image : result->images) {
    if (image.facts && image.facts->is_float) {
      diagnostics.error({.file = target.string(), .inside = image.name}, "cannot-express",
                        "is an image of floats, but glTF supports only PNG and JPEG",
                        "write a .json or .h, or convert the image to PNG first");
      return nullptr;
    }
    auto made = images::png_or_jpeg(image);
    if (const std::string* why = std::get_if<std::string>(&made)) {
      diagnostics.error({.file = scene.name}, "image-data", fmt::format("the image '{}' {}", image.name, *why));
      return nullptr;
    }
    image = std::move(std::get<Image>(made));
  }
  result->source = unlit(*result);
  return result;
}

}  // namespace foredraw
