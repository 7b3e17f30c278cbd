#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/private/levels.h>
#include <foredraw/io/gltf/private/products.h>
#include <foredraw/io/text/private/json_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw::gltf {

namespace {

const char* kind_name(const Json& value) {
  switch (value.type()) {
    case Json::value_t::object: return "an object";
    case Json::value_t::array: return "an array";
    case Json::value_t::string: return "a string";
    case Json::value_t::boolean: return "true or false";
    case Json::value_t::number_float: return "a fraction";
    case Json::value_t::number_integer:
    case Json::value_t::number_unsigned: return "a number";
    default: return "null";
  }
}

/// The top-level arrays of objects that we look into.
constexpr const char* kinds[] = {"accessors", "animations", "buffers", "bufferViews", "cameras",
                                 "images",    "materials",  "meshes",  "nodes",       "samplers",
                                 "scenes",    "skins",      "textures"};

}  // namespace

std::string at(const std::string& place, std::size_t i) { return place + '[' + std::to_string(i) + ']'; }

std::string in(const std::string& place, std::string_view key) {
  std::string whole;  // made of every key of a file
  whole.reserve(place.size() + 1 + key.size());
  whole += place;
  if (!place.empty()) whole += '.';
  whole += key;
  return whole;
}

const Json& Gate::all(const char* kind) const {
  static const Json none = Json::array();
  const auto found = json().find(kind);
  return found == json().end() ? none : *found;
}

const Json* Gate::array(const Json& parent, const char* key, const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return nullptr;
  if (found->is_array()) return &*found;
  error(in(place, key), "wrong-type", fmt::format("must be an array, but is {}", kind_name(*found)));
  return nullptr;
}

const Json* Gate::object(const Json& parent, const char* key, const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return nullptr;
  if (found->is_object()) return &*found;
  error(in(place, key), "wrong-type", fmt::format("must be an object, but is {}", kind_name(*found)));
  return nullptr;
}

std::optional<std::string> Gate::text(const Json& parent, const char* key, const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return std::nullopt;
  if (found->is_string()) return found->get<std::string>();
  error(in(place, key), "wrong-type", fmt::format("must be a string, but is {}", kind_name(*found)));
  return std::nullopt;
}

std::optional<bool> Gate::boolean(const Json& parent, const char* key, const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return std::nullopt;
  if (found->is_boolean()) return found->get<bool>();
  error(in(place, key), "wrong-type", fmt::format("must be true or false, but is {}", kind_name(*found)));
  return std::nullopt;
}

std::optional<std::uint64_t> Gate::whole(const Json& parent, const char* key, const std::string& place,
                                         std::uint64_t least, std::uint64_t most) {
  const auto found = parent.find(key);
  if (found == parent.end()) return std::nullopt;
  if (!found->is_number_integer()) {
    error(in(place, key), "wrong-type", fmt::format("must be a whole number, but is {}", kind_name(*found)));
    return std::nullopt;
  }
  const bool negative = !found->is_number_unsigned() && found->get<std::int64_t>() < 0;
  const std::uint64_t value = negative ? 0 : found->get<std::uint64_t>();
  if (!negative && value >= least && value <= most) return value;
  error(in(place, key), "out-of-range", fmt::format("is {}, but must be {} to {}", found->dump(), least, most));
  return std::nullopt;
}

std::optional<double> Gate::number(const Json& parent, const char* key, const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return std::nullopt;
  if (!found->is_number()) {
    error(in(place, key), "wrong-type", fmt::format("must be a number, but is {}", kind_name(*found)));
    return std::nullopt;
  }
  const double value = found->get<double>();
  if (std::abs(value) <= std::numeric_limits<float>::max()) return value;
  error(in(place, key), "out-of-range", "does not fit a 32-bit float");
  return std::nullopt;
}

bool Gate::numbers(const Json& parent, const char* key, const std::string& place, std::size_t size) {
  const Json* values = array(parent, key, place);
  if (values == nullptr) return false;
  if (size != 0 && values->size() != size) {
    error(in(place, key), "out-of-range", fmt::format("has {} numbers, but must have {}", values->size(), size));
    return false;
  }
  for (std::size_t i = 0; i < values->size(); ++i) {
    const Json& value = (*values)[i];
    if (value.is_number() && std::abs(value.get<double>()) <= std::numeric_limits<float>::max()) continue;
    error(at(in(place, key), i), "wrong-type", "must be a number that fits a 32-bit float");
    return false;
  }
  return true;
}

std::optional<std::size_t> Gate::reference(const Json& value, const char* kind, const std::string& place) {
  if (!value.is_number_integer()) {
    error(place, "wrong-type", fmt::format("must be the index of one of the {}, but is {}", kind, kind_name(value)));
    return std::nullopt;
  }
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= count(kind)) {
    error(place, "bad-reference", fmt::format("is {}, but the file has {} {}", value.dump(), count(kind), kind));
    return std::nullopt;
  }
  const auto number = value.get<std::size_t>();
  return tell_held_back(kind, number) ? std::nullopt : std::optional(number);
}

std::optional<std::size_t> Gate::reference(const Json& parent, const char* key, const char* kind,
                                           const std::string& place) {
  const auto found = parent.find(key);
  if (found == parent.end()) return std::nullopt;
  return reference(*found, kind, in(place, key));
}

std::vector<std::size_t> Gate::references(const Json& parent, const char* key, const char* kind,
                                          const std::string& place) {
  std::vector<std::size_t> result;
  const Json* values = array(parent, key, place);
  for (std::size_t i = 0; values != nullptr && i < values->size(); ++i) {
    if (const auto number = reference((*values)[i], kind, at(in(place, key), i))) result.push_back(*number);
  }
  return result;
}

void Gate::required(const Json& parent, const char* key, const std::string& place) {
  if (parent.contains(key)) return;
  error(place, "missing-member", fmt::format("lacks '{}'", key));
}

const Accessor* Gate::accessor(std::optional<std::size_t> number) const {
  return number && *number < accessors.size() && accessors[*number] ? &*accessors[*number] : nullptr;
}

const BufferView* Gate::view(std::optional<std::size_t> number) const {
  if (!number || *number >= document_.views.size() || document_.views[*number].length == 0) return nullptr;
  return &document_.views[*number];
}

bool check_structure(Gate& gate) {
  const Json& json = gate.json();
  if (!json.is_object()) {
    gate.error({}, "wrong-type", fmt::format("the JSON must be an object, but is {}", kind_name(json)));
    return false;
  }
  for (const char* kind : kinds) {
    const Json* values = gate.array(json, kind, {});
    for (std::size_t i = 0; values != nullptr && i < values->size(); ++i) {
      if (!(*values)[i].is_object())
        gate.error(at(kind, i), "wrong-type", fmt::format("must be an object, but is {}", kind_name((*values)[i])));
    }
  }
  const Json* asset = gate.object(json, "asset", {});
  if (asset == nullptr) {
    gate.required(json, "asset", "the file");
    return false;
  }
  const auto found = asset->find("version");
  const bool is_number = found != asset->end() && found->is_number();
  if (is_number) gate.fault("version-number", "asset.version", "must be a string, but is a number");
  if (is_number) gate.mend_at("asset.version") = fmt::format("{:.1f}", found->get<double>());
  const auto version = gate.text(*asset, "version", "asset");
  gate.required(*asset, "version", "asset");
  const auto least = gate.text(*asset, "minVersion", "asset");
  for (const auto& wanted : {version, least}) {
    if (wanted && wanted->substr(0, 2) != "2.") {
      gate.error("asset.version", "gltf-version", fmt::format("glTF version is '{}', but must be 2.x", *wanted),
                 "convert the file to glTF 2.0 first");
    }
  }
  return gate.sound();
}

namespace {

enum class Levels { read, left_out };

struct FoundLevels {
  bool any = false;
  std::vector<Ladder> ladders;
};

std::optional<Document> checked(Shared<std::byte> file, const std::string& name, const std::filesystem::path& folder,
                                const SceneInput& how, Levels levels, FoundLevels& found, Diagnostics& diagnostics) {
  Document document;
  document.products = how.products;
  document.name = name;
  document.folder = folder;
  document.file = std::move(file);
  Gate gate(document, diagnostics, how);

  const auto container = open_container(gate);
  const bool readable = container && parse_json(gate, container->json) && check_structure(gate);
  found.any = readable && has_extension(document.json, levels_extension);
  if (found.any && levels == Levels::read) {
    if (const auto why = expose_levels(document.json, document.ladders)) gate.error({}, "bad-levels", *why);
    found.ladders = document.ladders;
  } else if (found.any) {
    take_out(document, levels_card());
  }
  if (readable && gate.sound()) {
    check_extensions(gate);
    check_buffers(gate, container->bin);
    check_views(gate);
    check_compression(gate);
    if (!check_draco(gate, how.executor)) {  // accessors then lack bytes that other checks look for
      gate.finish();
      return std::nullopt;
    }
    check_accessors(gate);
    check_images(gate);
    check_materials(gate);
    check_meshes(gate);
    check_nodes(gate);
    check_instances(gate);
    check_skins(gate);
    check_animations(gate);
    if (gate.sound()) gate.let_go_of_unused();
    if (gate.sound()) check_finite(gate);
  }
  if (!gate.finish()) return std::nullopt;
  for (const auto& accessor : gate.accessors) document.accessors.push_back(*accessor);
  return document;
}

}  // namespace

std::optional<Document> open_document(Shared<std::byte> file, const std::string& name,
                                      const std::filesystem::path& folder, const SceneInput& how,
                                      Diagnostics& diagnostics) {
  FoundLevels levels, none;
  Diagnostics found;
  auto document = checked(file, name, folder, how, Levels::read, levels, found);
  if (document || !levels.any) {
    for (const Diagnostic& diagnostic : found.all()) diagnostics.add(diagnostic);
    return document;
  }
  // They are optional: what is wrong in them costs them alone.
  document = checked(std::move(file), name, folder, how, Levels::left_out, none, diagnostics);
  const auto first = std::ranges::find(found.all(), Severity::error, &Diagnostic::severity);
  if (!document || first == found.all().end()) return document;
  const std::string place = place_of_level(levels.ladders, first->where.inside);
  const std::string why = place.empty() ? first->message : fmt::format("{}: {}", place, first->message);
  tell_taken_out(name, levels_card(), why, how.strict, diagnostics);
  if (how.strict) return std::nullopt;
  return document;
}

}  // namespace foredraw::gltf
