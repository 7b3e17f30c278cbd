// Images and frame lists to scenes.
#include <foredraw/image/found_traits.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/image/private/headers.h>
#include <foredraw/io/sprite/private/source.h>
#include <foredraw/io/sprite/sprite_files.h>
#include <foredraw/io/text/private/file_beside.h>
#include <foredraw/io/text/private/file_kind.h>
#include <foredraw/io/text/private/json_text.h>

#include <foredraw/base/printable.h>
#include <foredraw/scene/triangle_draw.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw {

namespace {

namespace fs = std::filesystem;
using sprites::FrameEntry;
using sprites::SpriteSource;

std::string utf8(const fs::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}

std::string media_type_of(std::span<const std::byte> bytes) {
  const auto header = images::header_of(bytes);
  if (!header) return {};
  switch (header->kind) {
    case images::Kind::png: return "image/png";
    case images::Kind::jpeg: return "image/jpeg";
    case images::Kind::tga: return "image/x-tga";
    case images::Kind::exr: return "image/x-exr";
  }
  return {};
}

std::optional<Image> image_of(std::vector<std::byte> bytes, const fs::path& file, Diagnostics& diagnostics) {
  Image image;
  image.name = utf8(file.stem());
  image.facts = checked_image_facts(bytes, {.file = file.string()}, diagnostics);
  if (!image.facts) return std::nullopt;
  image.media_type = media_type_of(bytes);
  image.bytes = Shared<std::byte>(std::move(bytes));
  return image;
}

/// Each texel once, and nothing beyond the edges.
Material material_of(ImageId image, const std::string& name) {
  Material material;
  material.name = name;
  material.alpha_mode = AlphaMode::blend;
  material.double_sided = true;
  material.base_colour = Texture{.image = image, .texcoord = 0, .wrap = {Wrap::clamped, Wrap::clamped}};
  return material;
}

/// Corners from the lower left one on, counter-clockwise as they are seen.
Draw quad(const FrameEntry& entry, const ImageFacts& facts) {
  const float unit = static_cast<float>(std::max(facts.width, facts.height));
  const glm::vec2 half = glm::vec2(entry.size()) / (2 * unit);
  const std::vector<glm::vec3> positions = {
      {-half.x, -half.y, 0}, {half.x, -half.y, 0}, {half.x, half.y, 0}, {-half.x, half.y, 0}};
  const SpriteFrame& place = entry.place;
  const auto width = static_cast<float>(facts.width), height = static_cast<float>(facts.height);
  const float left = static_cast<float>(place.x) / width, right = static_cast<float>(place.x + place.width) / width;
  const float top = static_cast<float>(place.y) / height;
  const float bottom = static_cast<float>(place.y + place.height) / height;
  std::vector<glm::vec2> texcoords = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
  // What lies turned clockwise has its lower left corner at the upper left.
  if (entry.is_turned) std::rotate(texcoords.begin(), texcoords.begin() + 3, texcoords.end());
  return triangle_draw(entry.name, positions, {0, 1, 2, 0, 2, 3}, {float_stream("TEXCOORD_0", texcoords)});
}

/// Where the frame lies in its image, whose centre is at `centre`.
Transform transform_of(const FrameEntry& entry, const ImageFacts& facts, float centre) {
  const double unit = std::max(facts.width, facts.height);
  const SpriteFrame& place = entry.place;
  Transform transform;
  transform.translation.x = centre + static_cast<float>((place.x + place.width / 2.0 - facts.width / 2.0) / unit);
  transform.translation.y = static_cast<float>((facts.height / 2.0 - place.y - place.height / 2.0) / unit);
  constexpr float sine = 0.70710678f;  // of half a quarter
  if (entry.is_turned) transform.rotation = glm::quat(sine, 0, 0, -sine);
  return transform;
}

void add_sprite(Scene& scene, const FrameEntry& entry, std::uint32_t number, float centre) {
  const auto image = static_cast<ImageId>(entry.texture);
  const ImageFacts& facts = *scene.images[image].facts;
  Draw draw = quad(entry, facts);
  draw.material = image;
  draw.origin = DrawOrigin{number, 0};
  draw.frame = entry.place;
  scene.draws.push_back(std::move(draw));
  scene.meshes.push_back({.name = entry.name, .draws = {number}});
  Node node;
  node.name = entry.name;
  node.mesh = number;
  node.transform = transform_of(entry, facts, centre);
  scene.nodes.push_back(std::move(node));
}

/// Several images stand side by side, a tenth of a unit apart.
void fill(Scene& scene, const std::vector<FrameEntry>& entries) {
  std::vector<float> centres;
  float right = 0;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    scene.materials.push_back(material_of(static_cast<ImageId>(i), scene.images[i].name));
    const ImageFacts& facts = *scene.images[i].facts;
    const float half = static_cast<float>(facts.width) / (2 * static_cast<float>(std::max(facts.width, facts.height)));
    centres.push_back(i == 0 ? 0 : right + 0.1f + half);
    right = centres.back() + half;
  }
  for (std::uint32_t i = 0; i < entries.size(); ++i) add_sprite(scene, entries[i], i, centres[entries[i].texture]);
  find_traits(scene);
}

/// Where a list's image lies; nullopt, with an error, where it may not be opened.
std::optional<fs::path> image_file(const std::string& image, const std::string& list, const FilePlaces& where,
                                   Diagnostics& diagnostics) {
  FileBeside beside = file_beside(image, where);
  if (beside.why_not.empty()) return std::move(beside.path);
  diagnostics.error({.file = list}, "frame-list-image",
                    fmt::format("its image '{}' {}", printable(image), beside.why_not), std::move(beside.hint));
  return std::nullopt;
}

bool lies_in(const SpriteFrame& place, const ImageFacts& facts) {
  return std::uint64_t{place.x} + place.width <= facts.width && std::uint64_t{place.y} + place.height <= facts.height;
}

bool frames_lie_in_images(const std::vector<FrameEntry>& entries, const Scene& scene, Diagnostics& diagnostics) {
  constexpr std::size_t most = 20;
  std::size_t outside = 0;
  for (const FrameEntry& entry : entries) {
    const Image& image = scene.images[entry.texture];
    if (lies_in(entry.place, *image.facts) || ++outside > most) continue;
    const SpriteFrame& place = entry.place;
    diagnostics.error(
        {.file = scene.name, .inside = printable(entry.name)}, "frame-outside",
        fmt::format("begins at {}, {} and has {} x {} texels, but the image '{}' has {} x {}", place.x, place.y,
                    place.width, place.height, printable(image.name), image.facts->width, image.facts->height),
        "check that this is the image that the list was made for");
  }
  if (outside > most) {
    diagnostics.error({.file = scene.name}, "frame-outside",
                      fmt::format("{} more frames reach out of their images", outside - most));
  }
  return outside == 0;
}

}  // namespace

bool is_frame_list(const fs::path& path) { return lower_extension(path) == ".json"; }

std::vector<std::string_view> sprite_image_extensions() { return {".png", ".jpg", ".jpeg", ".tga", ".exr"}; }

bool is_sprite_input(const fs::path& path) {
  const auto images = sprite_image_extensions();
  return is_frame_list(path) || std::ranges::find(images, lower_extension(path)) != images.end();
}

std::optional<Scene> read_sprite_image(std::vector<std::byte> bytes, const std::string& name,
                                       Diagnostics& diagnostics) {
  auto source = std::make_shared<SpriteSource>();
  source->length = bytes.size();
  source->files = source->image_files = {name};
  auto image = image_of(std::move(bytes), name, diagnostics);
  if (!image) return std::nullopt;
  FrameEntry entry;
  entry.name = image->name;
  entry.place = {0, 0, image->facts->width, image->facts->height};
  entry.whole = entry.size();
  source->entries = {std::move(entry)};
  Scene scene;
  scene.name = name;
  scene.images.push_back(std::move(*image));
  fill(scene, source->entries);
  scene.source = std::move(source);
  return scene;
}

std::optional<Scene> read_sprite_list(std::span<const std::byte> bytes, const std::string& name, const fs::path& folder,
                                      Diagnostics& diagnostics, const SceneInput& how) {
  auto list = sprites::read_frame_list({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, name, diagnostics);
  if (!list) return std::nullopt;
  auto source = std::make_shared<SpriteSource>();
  source->length = bytes.size();
  source->files = {name};
  Scene scene;
  scene.name = name;
  std::set<fs::path> taken;  // a small list must not make much of a large image
  for (std::size_t i = 0; i < list->images.size(); ++i) {
    const auto file = image_file(list->images[i], name, {folder, how.root, how.files}, diagnostics);
    std::error_code error;
    if (file && !taken.insert(fs::canonical(*file, error)).second) {
      diagnostics.error({.file = name, .inside = fmt::format("textures[{}].image", i)}, "frame-list-image",
                        "is the image of an earlier texture", "put the frames of both into one texture");
      return std::nullopt;
    }
    auto content = file ? read_file(*file, diagnostics, FileRead::all_of_it, how.files.get()) : std::nullopt;
    if (!content) return std::nullopt;
    source->length += content->size();
    auto image = image_of(std::move(*content), *file, diagnostics);
    if (!image) return std::nullopt;
    const glm::ivec2 size(image->facts->width, image->facts->height);
    if (list->image_sizes[i] && *list->image_sizes[i] != size) {
      diagnostics.warning(
          {.file = name}, "frame-list-size",
          fmt::format("was made for an image of {} x {} texels, but '{}' has {} x {}", list->image_sizes[i]->x,
                      list->image_sizes[i]->y, printable(list->images[i]), size.x, size.y),
          "check that this is the image that the list was made for");
    }
    source->files.push_back(*file);
    source->image_files.push_back(*file);
    scene.images.push_back(std::move(*image));
  }
  if (!frames_lie_in_images(list->entries, scene, diagnostics)) return std::nullopt;
  if (list->has_polygons) {
    diagnostics.note({.file = name}, "polygons-left-aside",
                     "frames already have polygons (\"vertices\"); they are ignored, and the whole rectangle of each "
                     "frame is drawn");
  }
  source->list = std::move(list->json);
  source->entries = std::move(list->entries);
  fill(scene, source->entries);
  scene.source = std::move(source);
  return scene;
}

std::optional<std::vector<fs::path>> images_of_list(const fs::path& list) {
  Diagnostics ignored;
  const auto bytes = read_file(list, ignored);
  if (!bytes) return std::nullopt;
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  if (text.find("\"frames\"") == std::string_view::npos) return std::nullopt;
  const auto parsed = parse_json_text(text, {});
  const auto* json = std::get_if<Json>(&parsed);
  if (json != nullptr && (!json->is_object() || !(json->contains("frames") || json->contains(sprites::textures_key)))) {
    return std::nullopt;
  }
  std::vector<fs::path> images;
  if (const auto read = sprites::read_frame_list(text, list.string(), ignored)) {
    for (const std::string& image : read->images) {
      images.push_back(list.parent_path() / utf8_path(image));
    }
  }
  return images;
}

}  // namespace foredraw
