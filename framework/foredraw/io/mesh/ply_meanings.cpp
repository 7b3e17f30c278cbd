#include <foredraw/io/mesh/private/ply_meanings.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace foredraw::mesh_files {

namespace {

Meaning meaning_of(std::string_view element, const PlyProperty& property) {
  struct Row {
    std::string_view name;
    Meaning meaning;
  };
  static constexpr Row rows[] = {
      {"x", Meaning::x},     {"y", Meaning::y},         {"z", Meaning::z},         {"nx", Meaning::nx},
      {"ny", Meaning::ny},   {"nz", Meaning::nz},       {"u", Meaning::u},         {"v", Meaning::v},
      {"s", Meaning::u},     {"t", Meaning::v},         {"texture_u", Meaning::u}, {"texture_v", Meaning::v},
      {"red", Meaning::red}, {"green", Meaning::green}, {"blue", Meaning::blue},   {"alpha", Meaning::alpha}};
  if (element == strips_name && names_vertices(property)) return Meaning::strip;
  if (element == "face" && names_vertices(property)) return Meaning::corners;
  if (element == "face" && property.list && !is_whole(property.type) && property.name == "texcoord")
    return Meaning::wedges;
  for (const Row& row : rows) {
    if (element == "vertex" && !property.list && row.name == property.name) return row.meaning;
  }
  return Meaning::nothing;
}

class MeaningFinder {
 public:
  MeaningFinder(const Reading& reading, const PlyHeader& header) : reading_(reading), header_(header) {}

  std::optional<PlyMeanings> run() {
    for (const PlyElement& element : header_.elements) {
      auto& meanings = meanings_.of.emplace_back();
      std::set<std::string_view> names;
      for (const PlyProperty& property : element.properties) {
        const Meaning meaning = meaning_of(element.name, property);
        if (!names.insert(property.name).second && !may_be_twice(property, meaning)) return std::nullopt;
        // Of several that mean the same the first counts.
        meanings.push_back(this->property(meaning) == nullptr ? meaning : Meaning::nothing);
      }
    }
    if (!find_columns()) return std::nullopt;
    for (auto& meanings : meanings_.of) {
      std::ranges::replace_if(
          meanings, [&](Meaning meaning) { return !is_read(meaning); }, Meaning::nothing);
    }
    return std::move(meanings_);
  }

 private:
  bool may_be_twice(const PlyProperty& property, Meaning meaning) const {
    std::string message = fmt::format("the element has two properties {}", shown(property.name));
    if (meaning != Meaning::nothing) return reading_.refuse(reading_.at(property.type_token), std::move(message));
    reading_.fault("property-twice", property.type_token, std::move(message));
    return true;
  }

  const PlyProperty* property(Meaning meaning) const {
    for (std::size_t e = 0; e < meanings_.of.size(); ++e) {
      for (std::size_t p = 0; p < meanings_.of[e].size(); ++p) {
        if (meanings_.of[e][p] == meaning) return &header_.elements[e].properties[p];
      }
    }
    return nullptr;
  }

  /// Where there are such elements, their list of vertices has to be, too.
  bool has_list(std::string_view name, Meaning list) const {
    const PlyElement* element = header_.find(name);
    if (element == nullptr || element->count == 0 || property(list) != nullptr) return true;
    return reading_.refuse(reading_.at(element->count_token),
                           fmt::format("the elements '{}' have no list 'vertex_indices'", name));
  }

  /// A colour that we can keep has one type; texture coordinates and normals are there whole or not at all.
  bool find_columns() {
    const auto all = [&](std::initializer_list<Meaning> meanings) {
      return std::ranges::all_of(meanings, [&](Meaning m) { return property(m) != nullptr; });
    };
    if (!all({Meaning::x, Meaning::y, Meaning::z})) {
      return reading_.refuse({.file = reading_.name}, "there is no element 'vertex' with x, y and z");
    }
    meanings_.has_normals = all({Meaning::nx, Meaning::ny, Meaning::nz});
    meanings_.has_wedges = property(Meaning::wedges) != nullptr;
    meanings_.has_texcoords = all({Meaning::u, Meaning::v}) && !meanings_.has_wedges;
    if (!has_list("face", Meaning::corners) || !has_list(strips_name, Meaning::strip)) return false;
    if (!all({Meaning::red, Meaning::green, Meaning::blue})) return true;
    const PlyType type = property(Meaning::red)->type;
    const PlyProperty* alpha = property(Meaning::alpha);
    if (property(Meaning::green)->type != type || property(Meaning::blue)->type != type ||
        (alpha != nullptr && alpha->type != type)) {
      return true;
    }
    const std::uint8_t components = alpha != nullptr ? 4 : 3;
    switch (type) {
      case PlyType::uint8: meanings_.color_format = {Component::uint8, components, true, components}; break;
      case PlyType::uint16:
        meanings_.color_format = {Component::uint16, components, true, static_cast<std::uint16_t>(2 * components)};
        break;
      case PlyType::float32:
      case PlyType::float64:
        meanings_.color_format = {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)};
        break;
      default: break;
    }
    return true;
  }

  bool is_read(Meaning meaning) const {
    switch (meaning) {
      case Meaning::nothing: return false;
      case Meaning::nx:
      case Meaning::ny:
      case Meaning::nz: return meanings_.has_normals;
      case Meaning::u:
      case Meaning::v: return meanings_.has_texcoords;
      case Meaning::red:
      case Meaning::green:
      case Meaning::blue: return meanings_.color_format.components > 0;
      case Meaning::alpha: return meanings_.color_format.components == 4;
      default: return true;
    }
  }

  const Reading& reading_;
  const PlyHeader& header_;
  PlyMeanings meanings_;
};

}  // namespace

std::optional<PlyMeanings> ply_meanings(const Reading& reading, const PlyHeader& header) {
  return MeaningFinder(reading, header).run();
}

void tell_left_out(const Reading& reading, const PlyHeader& header, const PlyMeanings& meanings) {
  std::string names;
  for (std::size_t e = 0; e < header.elements.size(); ++e) {
    const PlyElement& element = header.elements[e];
    if (element.count == 0) continue;
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      if (meanings.of[e][p] != Meaning::nothing) continue;
      names += fmt::format("{}{}.{}", names.empty() ? "" : ", ", element.name, element.properties[p].name);
    }
  }
  if (names.empty()) return;
  reading.diagnostics.note({.file = reading.name}, "properties-left-out",
                           fmt::format("properties that a scene cannot hold are left out: {}", names));
}

}  // namespace foredraw::mesh_files
