// A frame list with polygons: the one that was read with these put in, or a new one.
#include <foredraw/io/sprite/private/write.h>
#include <foredraw/io/text/private/free_names.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

namespace foredraw::sprites {

namespace {

/// Whole numbers without a point; others so that the nearest float is what they say.
Json number(double value) {
  const double same = std::strtod(shortest(value).c_str(), nullptr);
  if (same == std::floor(same) && std::abs(same) < 1e9) return static_cast<std::int64_t>(same);
  return same;
}

Json pairs(const std::vector<glm::dvec2>& values) {
  Json list = Json::array();
  for (const glm::dvec2& value : values) list.push_back({number(value.x), number(value.y)});
  return list;
}

void put_polygon(Json& frame, const DrawnSprite& sprite) {
  frame["vertices"] = pairs(sprite.points);
  frame["verticesUV"] = pairs(sprite.texels);
  Json triangles = Json::array();
  for (std::size_t i = 0; i + 2 < sprite.triangles.size(); i += 3) {
    triangles.push_back({sprite.triangles[i], sprite.triangles[i + 1], sprite.triangles[i + 2]});
  }
  frame["triangles"] = std::move(triangles);
}

void put_place(Json& json, const FrameEntry& frame) {
  const glm::ivec2 size = frame.size();
  json["frame"] = JsonObject{{"x", frame.place.x}, {"y", frame.place.y}, {"w", size.x}, {"h", size.y}};
  json["rotated"] = frame.is_turned;
  json["trimmed"] = frame.whole != size;
  json["spriteSourceSize"] = JsonObject{{"x", frame.offset.x}, {"y", frame.offset.y}, {"w", size.x}, {"h", size.y}};
  json["sourceSize"] = JsonObject{{"w", frame.whole.x}, {"h", frame.whole.y}};
}

const auto& member_at(const Json& object, std::size_t i) {
  return *(object.get_ref<const Json::object_t&>().begin() + static_cast<std::ptrdiff_t>(i));
}

/// What the list says of a frame; nullptr where the sprite is in none.
const Json* old_frame(const Sheet& sheet, const DrawnSprite& sprite) {
  if (!sprite.entry || sheet.source->list.is_null()) return nullptr;
  const FrameEntry& entry = sheet.source->entries[*sprite.entry];
  const Json& frames = frames_in(sheet.source->list, entry.texture);
  return frames.is_array() ? &frames[entry.number] : &member_at(frames, entry.number).second;
}

Json frame_of(const Sheet& sheet, const DrawnSprite& sprite, bool with_name) {
  Json frame = Json::object();
  if (with_name) frame["filename"] = sprite.frame.name;
  const Json* old = old_frame(sheet, sprite);
  if (old != nullptr) {
    for (const auto& [key, value] : old->items()) {
      if (key != "filename") frame[key] = value;
    }
  }
  if (old == nullptr || sheet.source->entries[*sprite.entry].place != sprite.frame.place)
    put_place(frame, sprite.frame);
  put_polygon(frame, sprite);
  return frame;
}

Json polygon_facts(std::span<const Sheet> sheets) {
  return JsonObject{{"vertices", "texels of the untrimmed sprite"},
                    {"verticesUV", "texels of the image"},
                    {"origin", "upper left"},
                    {"winding", winding_of(sheets)}};
}

Json image_facts_of(const Sheet& sheet, std::size_t image, const std::filesystem::path& target) {
  const ImageFacts& facts = *sheet.scene->images[image].facts;
  return JsonObject{{"image", image_beside(sheet, image, target)},
                    {"format", facts.channels % 2 == 0 ? "RGBA8888" : "RGB888"},
                    {"size", JsonObject{{"w", facts.width}, {"h", facts.height}}}};
}

/// A texture being made: its frames have names of their own.
struct TextureMaking {
  Json json;
  FreeNames names{"#"};
};

/// One texture for each image, though several scenes show it, in the sequence of the sprites.
Json textures_of(std::span<const Sheet> sheets, const std::filesystem::path& target) {
  std::vector<TextureMaking> textures;
  std::map<std::string, std::size_t> numbers;
  for (const Sheet& sheet : sheets) {
    for (const DrawnSprite& sprite : sheet.sprites) {
      std::string key = image_beside(sheet, sprite.image, target);
      if (sheet.source == nullptr) key = fmt::format("{}:{}", &sheet - sheets.data(), sprite.image);  // no file
      const auto [number, is_new] = numbers.try_emplace(std::move(key), textures.size());
      if (is_new) {
        TextureMaking& made = textures.emplace_back();
        made.json = image_facts_of(sheet, sprite.image, target);
        made.json["scale"] = 1;
        made.json["frames"] = Json::array();
      }
      TextureMaking& texture = textures[number->second];
      Json frame = frame_of(sheet, sprite, true);
      frame["filename"] = texture.names.take(sprite.frame.name);
      texture.json["frames"].push_back(std::move(frame));
    }
  }
  Json list = Json::array();
  for (TextureMaking& texture : textures) list.push_back(std::move(texture.json));
  return list;
}

Json new_list(std::span<const Sheet> sheets, const std::filesystem::path& target) {
  Json list = Json::object();
  Json textures = textures_of(sheets, target);
  Json meta = JsonObject{{"app", "foredraw"}};
  if (textures.size() == 1) {
    list["frames"] = std::move(textures[0]["frames"]);
    for (const char* key : {"image", "format", "size"}) meta[key] = textures[0][key];
    meta["scale"] = "1";
  } else {
    list[textures_key] = std::move(textures);
  }
  meta["polygons"] = polygon_facts(sheets);
  list["meta"] = std::move(meta);
  return list;
}

/// The frames of one texture: old ones in their places, in the place of one that was parted its parts, new ones last.
Json patched_frames(const Sheet& sheet, std::size_t texture, const Json& old) {
  std::map<std::size_t, std::vector<const DrawnSprite*>> by_number;
  for (const DrawnSprite& sprite : sheet.sprites) {
    if (sprite.frame.texture != texture) continue;
    by_number[sprite.entry ? sheet.source->entries[*sprite.entry].number : old.size()].push_back(&sprite);
  }
  Json frames = old.is_array() ? Json::array() : Json::object();
  FreeNames names("#");
  const auto add = [&](const std::string& name, Json value) {
    if (old.is_array()) {
      value["filename"] = names.take(name);
      frames.push_back(std::move(value));
    } else {
      frames.get_ref<Json::object_t&>().emplace_back(names.take(name), std::move(value));
    }
  };
  for (std::size_t i = 0; i <= old.size(); ++i) {
    const auto drawn = by_number.find(i);
    if (drawn != by_number.end()) {
      for (const DrawnSprite* sprite : drawn->second) add(sprite->frame.name, frame_of(sheet, *sprite, old.is_array()));
    } else if (i < old.size() && old.is_array()) {
      add(old[i]["filename"].get<std::string>(), old[i]);
    } else if (i < old.size()) {
      const auto& [name, value] = member_at(old, i);
      add(name, value);
    }
  }
  return frames;
}

Json patched_list(const Sheet& sheet, const std::filesystem::path& target) {
  Json list = sheet.source->list;
  for (std::size_t t = 0; t < sheet.source->image_files.size(); ++t) {
    Json& frames = frames_in(list, t);
    frames = patched_frames(sheet, t, frames);
    const bool has_several = list.contains(textures_key);
    Json& facts = has_several ? list[textures_key][t] : list["meta"];
    const auto folder = [](const std::filesystem::path& file) { return std::filesystem::absolute(file).parent_path(); };
    std::error_code error;
    if (!std::filesystem::equivalent(folder(sheet.source->files[0]), folder(target), error)) {
      facts["image"] = image_beside(sheet, t, target);
    }
  }
  if (!list.contains("meta") || !list["meta"].is_object()) list["meta"] = Json::object();
  list["meta"]["polygons"] = polygon_facts({&sheet, 1});
  return list;
}

bool is_numbers(const Json& json) {
  return std::ranges::all_of(json, [](const Json& part) { return part.is_number(); });
}

/// A line for each thing that holds others, and one for what holds numbers alone, or lists of these.
void print(const Json& json, std::size_t indent, std::string& text) {
  const bool is_list_of_lists = json.is_array() && std::ranges::all_of(json, [](const Json& part) {
                                  return part.is_array() && is_numbers(part);
                                });
  if (!json.is_structured() || json.empty() || is_numbers(json) || is_list_of_lists) {
    text += json.dump();
    return;
  }
  const char* ends = json.is_array() ? "[]" : "{}";
  text += ends[0];
  bool is_first = true;
  for (const auto& [key, value] : json.items()) {
    text += is_first ? "\n" : ",\n";
    is_first = false;
    text.append(indent + 1, ' ');
    if (json.is_object()) text += Json(key).dump() + ": ";
    print(value, indent + 1, text);
  }
  text += '\n';
  text.append(indent, ' ');
  text += ends[1];
}

}  // namespace

std::optional<std::string> list_text(std::span<const Sheet> sheets, const std::filesystem::path& target,
                                     Diagnostics& diagnostics) {
  const bool was_list = sheets.size() == 1 && sheets[0].source != nullptr && !sheets[0].source->list.is_null();
  if (was_list) {
    const std::size_t textures = sheets[0].source->image_files.size();
    for (const DrawnSprite& sprite : sheets[0].sprites) {
      if (sprite.image < textures && sprite.frame.texture == sprite.image) continue;
      diagnostics.error({.file = target.string(), .inside = sprite.frame.name}, "cannot-express",
                        "shows another image than its list names; this cannot be written back",
                        "leave out the stage that did it");
      return std::nullopt;
    }
  }
  std::string text;
  print(was_list ? patched_list(sheets[0], target) : new_list(sheets, target), 0, text);
  return text + '\n';
}

}  // namespace foredraw::sprites
