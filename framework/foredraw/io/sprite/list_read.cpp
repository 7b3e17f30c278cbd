// Frame lists as TexturePacker and others write them: frames by name, frames in an array, or several textures of them.
#include <foredraw/io/sprite/private/source.h>
#include <foredraw/io/text/private/json_text.h>

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/printable.h>

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace foredraw::sprites {

namespace {

constexpr std::size_t longest = std::size_t{64} << 20;
constexpr std::size_t most_frames = 16384;  // by name they are keys of one object
constexpr std::size_t most_mistakes = 20;
constexpr double most_texels = 65535;  // along one side

class ListReader {
 public:
  ListReader(const std::string& name, Diagnostics& diagnostics) : name_(name), diagnostics_(diagnostics) {}

  bool run(Json json) {
    list.json = std::move(json);
    const Json& root = list.json;
    if (!root.is_object()) return refuse("", "frame-list", "must be an object", what_is_read);
    if (const auto textures = root.find(textures_key); textures != root.end()) {
      if (!textures->is_array() || textures->empty()) {
        return refuse("textures", "frame-list", "must be a list with at least one texture", what_is_read);
      }
      for (std::size_t t = 0; t < textures->size(); ++t) {
        const std::string place = fmt::format("textures[{}]", t);
        if (!(*textures)[t].is_object()) return refuse(place, "frame-list", "must be an object", what_is_read);
        texture((*textures)[t], (*textures)[t], place + '.', place + '.', t);
      }
    } else {
      const Json nothing = Json::object();
      const auto meta = root.find("meta");
      texture(root, meta == root.end() || !meta->is_object() ? nothing : *meta, "", "meta.", 0);
    }
    if (mistakes_ > most_mistakes) {
      diagnostics_.error({.file = name_}, "frame-list", fmt::format("has {} more mistakes", mistakes_ - most_mistakes));
    }
    return mistakes_ == 0;
  }

  FrameList list;

 private:
  static constexpr const char* what_is_read =
      "a frame list has \"frames\", an object or a list, or \"textures\" that have them, as TexturePacker writes it";

  bool refuse(const std::string& inside, const char* code, const std::string& message, const std::string& hint = {}) {
    if (++mistakes_ <= most_mistakes) {
      diagnostics_.error({.file = name_, .inside = printable(inside)}, code, message, hint);
    }
    return false;
  }

  void texture(const Json& holder, const Json& facts, const std::string& place, const std::string& facts_place,
               std::size_t number) {
    const auto image = facts.find("image");
    if (image == facts.end() || !image->is_string()) {
      refuse(facts_place + "image", "frame-list-image", "must be the name of the image that holds the frames",
             "write \"image\": \"atlas.png\" there, a file beside the list");
      return;
    }
    list.images.push_back(image->get<std::string>());
    glm::ivec2 size{0};
    const auto claimed = facts.find("size");
    const bool has_size = claimed != facts.end() && claimed->is_object() && claimed->contains("w") &&
                          pair(*claimed, facts_place + "size", "w", "h", 1, size);
    list.image_sizes.push_back(has_size ? std::optional(size) : std::nullopt);

    const auto frames = holder.find("frames");
    if (frames == holder.end() || !frames->is_structured()) {
      refuse(place + "frames", "frame-list", "must be an object of frames, or a list of them", what_is_read);
      return;
    }
    if (frames->empty()) refuse(place + "frames", "frame-list", "has no frames", "pack at least one sprite");
    if (list.entries.size() + frames->size() > most_frames) {
      refuse(place + "frames", "frame-list", fmt::format("there are more than {} frames", most_frames),
             "split it into several lists");
      return;
    }
    std::set<std::string> names;
    std::size_t i = 0;
    for (const auto& [key, value] : frames->items()) {
      const std::string at =
          frames->is_array() ? fmt::format("{}frames[{}]", place, i) : fmt::format("{}frames.{}", place, key);
      FrameEntry entry;
      entry.texture = number;
      entry.number = i++;
      if (!value.is_object()) {
        refuse(at, "frame", "must be an object");
        continue;
      }
      if (frames->is_object()) {
        entry.name = key;
      } else if (const auto name = value.find("filename"); name != value.end() && name->is_string()) {
        entry.name = name->get<std::string>();
        if (!names.insert(entry.name).second) {
          refuse(at, "frame-duplicate",
                 fmt::format("is called '{}', but an earlier frame has this name", printable(entry.name)),
                 "give each frame a name of its own");
        }
      } else {
        refuse(at + ".filename", "frame", "must be the frame's name");
        continue;
      }
      if (frame(value, at, entry)) list.entries.push_back(std::move(entry));
    }
  }

  bool frame(const Json& value, const std::string& at, FrameEntry& entry) {
    const auto rectangle = value.find("frame");
    if (rectangle == value.end() || !rectangle->is_object()) {
      return refuse(at + ".frame", "frame", "must be an object with x, y, w and h");
    }
    glm::ivec2 corner{0}, size{0};
    if (!pair(*rectangle, at + ".frame", "x", "y", 0, corner)) return false;
    if (!pair(*rectangle, at + ".frame", "w", "h", 1, size)) return false;
    if (const auto turned = value.find("rotated"); turned != value.end()) {
      if (!turned->is_boolean()) return refuse(at + ".rotated", "frame", "must be true or false");
      entry.is_turned = turned->get<bool>();
    }
    entry.place = {static_cast<std::uint32_t>(corner.x), static_cast<std::uint32_t>(corner.y),
                   static_cast<std::uint32_t>(entry.is_turned ? size.y : size.x),
                   static_cast<std::uint32_t>(entry.is_turned ? size.x : size.y)};
    entry.whole = size;
    if (const auto trimmed = value.find("spriteSourceSize"); trimmed != value.end()) {
      if (!trimmed->is_object()) return refuse(at + ".spriteSourceSize", "frame", "must be an object with x and y");
      if (!pair(*trimmed, at + ".spriteSourceSize", "x", "y", 0, entry.offset)) return false;
      entry.whole += entry.offset;
    }
    if (const auto whole = value.find("sourceSize"); whole != value.end()) {
      if (!whole->is_object()) return refuse(at + ".sourceSize", "frame", "must be an object with w and h");
      if (!pair(*whole, at + ".sourceSize", "w", "h", 1, entry.whole)) return false;
    }
    list.has_polygons = list.has_polygons || value.contains("vertices");
    return true;
  }

  /// Two whole numbers of texels.
  bool pair(const Json& holder, const std::string& at, const char* x, const char* y, double least, glm::ivec2& pair) {
    const char* const keys[] = {x, y};
    for (int i = 0; i < 2; ++i) {
      const std::string place = at + '.' + keys[i];
      const auto found = holder.find(keys[i]);
      if (found == holder.end() || !found->is_number())
        return refuse(place, "frame-number", "must be a number of texels");
      const auto value = found->get<double>();
      if (!(value >= least && value <= most_texels) || value != std::floor(value)) {
        return refuse(
            place, "frame-number",
            fmt::format("is {}, but must be a whole number from {} to {}", found->dump(), least, most_texels));
      }
      pair[i] = static_cast<int>(value);
    }
    return true;
  }

  const std::string& name_;
  Diagnostics& diagnostics_;
  std::size_t mistakes_ = 0;
};

}  // namespace

std::optional<FrameList> read_frame_list(std::string_view text, const std::string& name, Diagnostics& diagnostics) {
  if (text.size() > longest) {
    diagnostics.error({.file = name}, "frame-list", fmt::format("is longer than {} MiB", longest >> 20),
                      "split it into several lists");
    return std::nullopt;
  }
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  auto parsed = parse_json_text(text, {.depth = 64, .keys = most_frames});
  if (const JsonFault* fault = std::get_if<JsonFault>(&parsed)) {
    const Where where = fault->byte ? place_in(name, text, *fault->byte) : Where{.file = name};
    diagnostics.error(where, fault->code, fault->message, fault->hint);
    return std::nullopt;
  }
  ListReader reader(name, diagnostics);
  if (!reader.run(std::move(std::get<Json>(parsed)))) return std::nullopt;
  return std::move(reader.list);
}

}  // namespace foredraw::sprites
