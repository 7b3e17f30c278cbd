#include <foredraw/io/gltf/layout/private/accessor_store.h>

#include <foredraw/io/gltf/layout/private/layout.h>

#include <algorithm>
#include <cmath>

namespace foredraw::gltf {

namespace {

constexpr int component_types[] = {5120, 5121, 5122, 5123, 5125, 5126};  // in the sequence of Component

std::string type_of(const Format& format) {
  if (format.components == 1) return "SCALAR";
  if (format.components <= 4) return "VEC" + std::to_string(format.components);
  return format.components == 9 ? "MAT3" : "MAT4";
}

/// A component as it is stored: the range of a normalized stream is in whole numbers.
double stored(const VertexStream& plain, std::size_t element, std::size_t component) {
  if (plain.format.component != Component::uint32) return decode_component(plain, element, component);
  std::uint32_t value;  // a float would lose its low bits
  std::memcpy(&value, plain.bytes.view().data() + element * plain.format.bytes + 4 * component, 4);
  return value;
}

Json as_json(double value, Component component) {
  return component == Component::float32 ? Json(value) : Json(static_cast<std::int64_t>(value));
}

}  // namespace

void set_range(Json& accessor, const Content& content) {
  VertexStream plain{{}, content.format, content.bytes};
  plain.format.normalized = false;
  for (const bool least : {true, false}) {
    const char* key = least ? "min" : "max";
    const Json old = accessor.contains(key) ? accessor[key] : Json();
    Json range = Json::array();
    for (std::size_t c = 0; c < content.format.components; ++c) {
      std::optional<double> best;
      for (std::size_t i = 0; i < content.count; ++i) {
        const double value = stored(plain, i, c);
        if (std::isfinite(value) && (!best || (least ? value < *best : value > *best))) best = value;
      }
      const double value = best.value_or(0);
      const bool same =
          old.is_array() && c < old.size() && old[c].is_number() && old[c].get<float>() == static_cast<float>(value);
      range.push_back(same ? old[c] : as_json(value, content.format.component));
    }
    accessor[key] = std::move(range);
  }
}

bool same_content(const Content& a, const Content& b) {
  return a.kind == b.kind && a.format == b.format && a.count == b.count && a.wants_range == b.wants_range &&
         a.bytes == b.bytes;
}

AccessorStore::AccessorStore(const Document& document, Json& json) : document_(document), json_(json) {}

void AccessorStore::describe(std::size_t accessor, const Content& content) {
  Json& json = json_["accessors"][accessor];
  const auto old = json.contains("type")
                       ? format_of(json["type"].get<std::string>(), json["componentType"].get<unsigned>(), false)
                       : std::nullopt;
  json["componentType"] = component_types[static_cast<std::size_t>(content.format.component)];
  if (content.format.normalized) {
    json["normalized"] = true;
  } else {
    json.erase("normalized");
  }
  json["count"] = content.count;
  if (!old || old->components != content.format.components) json["type"] = type_of(content.format);
  json.erase("sparse");
  const bool had_range = json.contains("min") || json.contains("max");
  if (content.wants_range || had_range) set_range(json, content);
}

void AccessorStore::redefine(std::size_t accessor, const Content& content) {
  describe(accessor, content);
  contents_.insert_or_assign(accessor, content);
}

void AccessorStore::correct_range(std::size_t accessor) {
  Json& json = json_["accessors"][accessor];
  if (contents_.contains(accessor) || (!json.contains("min") && !json.contains("max"))) return;
  const Accessor& was = document_.accessors[accessor];
  set_range(json, {Content::Kind::other, was.format, was.count, Shared<std::byte>(elements(document_, was))});
}

AccessorStore::Key AccessorStore::key_of(const Content& content) {
  const Format& format = content.format;
  return {content.bytes.stamp(), content.kind,      format.component,
          format.components,     format.normalized, content.wants_range};
}

std::optional<std::size_t> AccessorStore::appended(const Content& content) const {
  const auto known = appended_.find(key_of(content));
  return known == appended_.end() ? std::nullopt : std::optional(known->second);
}

std::size_t AccessorStore::append(const Content& content, std::optional<std::size_t> like) {
  const auto [known, is_new] = appended_.try_emplace(key_of(content), 0);
  if (!is_new) return known->second;
  if (!json_.contains("accessors")) json_["accessors"] = Json::array();
  const std::size_t number = json_["accessors"].size();
  known->second = number;
  json_["accessors"].push_back(Json::object());
  json_["accessors"][number]["bufferView"] = 0;
  if (like) {
    const Json& from = document_.json["accessors"][*like];
    for (const char* key : {"componentType", "type", "min", "max"}) {
      if (from.contains(key)) json_["accessors"][number][key] = from[key];
    }
  }
  describe(number, content);
  contents_.emplace(number, content);
  return number;
}

void AccessorStore::release(std::size_t accessor) {
  Json& json = json_["accessors"][accessor];
  for (const char* key : {"bufferView", "byteOffset", "sparse", "min", "max"}) json.erase(key);
  released_.insert(accessor);
}

bool AccessorStore::lay_within(std::size_t accessor, std::size_t of, std::size_t first) {
  if (const auto within = parts_.find(of); within != parts_.end()) {  // whose own bytes are gone
    first += within->second.first;
    of = within->second.of;
  }
  if (accessor == of || parts_.contains(accessor) || released_.contains(accessor)) return false;
  const Content& whole = contents_.at(of);
  const auto changed = contents_.find(accessor);
  const bool is_new = changed != contents_.end();
  if (!is_new && accessor >= document_.accessors.size()) return false;
  const Accessor* was = is_new ? nullptr : &document_.accessors[accessor];
  if ((is_new ? changed->second.format : was->format) != whole.format) return false;
  const std::vector<std::byte> kept = is_new ? std::vector<std::byte>() : elements(document_, *was);
  const Bytes own = is_new ? changed->second.bytes.view() : Bytes(kept);
  const std::size_t begin = first * whole.format.bytes;
  if (begin + own.size() > whole.bytes.size() ||
      !std::ranges::equal(own, whole.bytes.view().subspan(begin, own.size()))) {
    return false;
  }
  if (wholes_.erase(accessor) > 0) {  // its parts go along
    for (auto& [number, part] : parts_) {
      if (part.of == accessor) part = {of, part.first + first};
    }
  }
  parts_.emplace(accessor, Part{of, first});
  wholes_.insert(of);
  json_["accessors"][accessor].erase("sparse");
  return true;
}

void AccessorStore::set_image(std::size_t image, Shared<std::byte> bytes) {
  Json& json = json_["images"][image];
  json.erase("uri");
  images_.insert_or_assign(image, std::move(bytes));
}

void AccessorStore::move_images(const std::vector<std::size_t>& to) {
  std::map<std::size_t, Shared<std::byte>> moved;
  for (auto& [image, bytes] : images_) {
    if (to[image] < to.size()) moved.try_emplace(to[image], std::move(bytes));
  }
  images_ = std::move(moved);
}

LaidOut AccessorStore::lay_out(bool compress) {
  return laid_out(document_, json_, {contents_, parts_, released_, images_, forgotten_}, compress);
}

}  // namespace foredraw::gltf
