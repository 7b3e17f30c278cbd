#include <foredraw/io/mesh/private/ply.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace foredraw::mesh_files {

namespace {

/// What a property of a vertex or face means to us.
enum class Meaning : std::uint8_t {
  x,
  y,
  z,
  nx,
  ny,
  nz,
  u,
  v,
  red,
  green,
  blue,
  alpha,
  corners,
  wedges,
  strip,
  nothing
};

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

class PlyReader {
 public:
  PlyReader(const Reading& reading, const PlyHeader& header, PolygonMesh& mesh)
      : reading_(reading), header_(header), mesh_(mesh) {}

  bool run() {
    mesh_.whole_vertices = true;
    for (const PlyElement& element : header_.elements) {
      auto& meanings = meanings_.emplace_back();
      std::set<std::string_view> names;
      for (const PlyProperty& property : element.properties) {
        const Meaning meaning = meaning_of(element.name, property);
        if (!names.insert(property.name).second && !may_be_twice(property, meaning)) return false;
        // Of several that mean the same the first counts.
        meanings.push_back(this->property(meaning) == nullptr ? meaning : Meaning::nothing);
      }
    }
    if (!find_columns()) return false;
    for (auto& meanings : meanings_) {
      std::ranges::replace_if(
          meanings, [&](Meaning meaning) { return !is_read(meaning); }, Meaning::nothing);
    }
    PlyWalk walk(reading_, header_);
    if (!walk.run(*this) || !all_vertices_exist()) return false;
    if (has_wedges_ && mesh_.face_count() > 0) mesh_.whole_vertices = false;
    give_corners_their_attributes();
    if (!look_behind(walk.end())) return false;
    tell_left_out();
    return true;
  }

  // The visitor of the walk.
  bool wants(std::size_t e, std::size_t p) const { return meanings_[e][p] != Meaning::nothing; }

  bool list(std::size_t e, std::size_t p, std::size_t) {
    if (meanings_[e][p] == Meaning::wedges) wedge_.clear();
    if (meanings_[e][p] == Meaning::strip) strip_.begin();
    return true;
  }

  bool value(std::size_t e, std::size_t p, const PlyValue& value) {
    const Meaning meaning = meanings_[e][p];
    if (meaning == Meaning::corners) return corner(value);
    if (meaning == Meaning::strip) return strip_vertex(value);
    double number = value.value;
    if (!std::isfinite(static_cast<float>(number))) {
      std::string message = fmt::format("'{}' is not a finite 32-bit float", header_.elements[e].properties[p].name);
      if (meaning <= Meaning::z) return refuse(value, std::move(message));
      fault("not-finite", value.begin, std::move(message));
      number = 0;
    }
    if (meaning == Meaning::wedges) {
      wedge_.push_back(static_cast<float>(number));
    } else {
      row_[static_cast<std::size_t>(meaning)] = number;
    }
    return true;
  }

  bool record(std::size_t e, std::size_t begin, std::size_t) {
    if (header_.elements[e].name == "vertex") add_vertex();
    if (header_.elements[e].name != "face") return true;
    const std::size_t first = mesh_.ends.empty() ? 0 : mesh_.ends.back();
    const std::size_t corners = mesh_.corners.size() - first;
    if (has_wedges_ && wedge_.size() == 2 * corners) {
      for (std::size_t i = 0; i < corners; ++i) mesh_.corners[first + i].texcoord = wedge_number(i);
    } else if (has_wedges_ && !wedge_.empty()) {
      return refuse({.begin = begin},
                    fmt::format("found {} texture coordinates for {} corners", wedge_.size(), corners));
    }
    wedge_.clear();
    end_face(begin);
    return true;
  }

 private:
  bool is_text() const { return header_.encoding == PlyHeader::Encoding::ascii; }

  bool refuse(const PlyValue& value, std::string message) const {
    return reading_.refuse(is_text() ? reading_.at(reading_.text.substr(value.begin)) : reading_.at_byte(value.begin),
                           std::move(message));
  }

  void fault(std::string_view code, std::size_t place, std::string message) const {
    if (is_text()) {
      reading_.fault(code, reading_.text.substr(place), std::move(message));
    } else {
      reading_.fault_at_byte(code, place, std::move(message));
    }
  }

  bool may_be_twice(const PlyProperty& property, Meaning meaning) const {
    std::string message = fmt::format("the element has two properties {}", shown(property.name));
    if (meaning != Meaning::nothing) return reading_.refuse(reading_.at(property.type_token), std::move(message));
    reading_.fault("property-twice", property.type_token, std::move(message));
    return true;
  }

  const PlyProperty* property(Meaning meaning) const {
    for (std::size_t e = 0; e < meanings_.size(); ++e) {
      for (std::size_t p = 0; p < meanings_[e].size(); ++p) {
        if (meanings_[e][p] == meaning) return &header_.elements[e].properties[p];
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
    has_normals_ = all({Meaning::nx, Meaning::ny, Meaning::nz});
    has_texcoords_ = all({Meaning::u, Meaning::v});
    has_wedges_ = property(Meaning::wedges) != nullptr;
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
      case PlyType::uint8: mesh_.color_format = {Component::uint8, components, true, components}; break;
      case PlyType::uint16:
        mesh_.color_format = {Component::uint16, components, true, static_cast<std::uint16_t>(2 * components)};
        break;
      case PlyType::float32:
      case PlyType::float64:
        mesh_.color_format = {Component::float32, components, false, static_cast<std::uint16_t>(4 * components)};
        break;
      default: break;
    }
    return true;
  }

  double at(Meaning meaning) const { return row_[static_cast<std::size_t>(meaning)]; }
  float number(Meaning meaning) const { return static_cast<float>(at(meaning)); }

  void add_vertex() {
    mesh_.positions.emplace_back(number(Meaning::x), number(Meaning::y), number(Meaning::z));
    if (has_normals_) mesh_.normals.emplace_back(number(Meaning::nx), number(Meaning::ny), number(Meaning::nz));
    if (has_texcoords_ && !has_wedges_) mesh_.texcoords.emplace_back(number(Meaning::u), 1 - number(Meaning::v));
    for (std::uint8_t c = 0; c < mesh_.color_format.components; ++c) {
      const double value = at(static_cast<Meaning>(static_cast<std::uint8_t>(Meaning::red) + c));
      switch (mesh_.color_format.component) {
        case Component::uint8: put_color(static_cast<std::uint8_t>(value)); break;
        case Component::uint16: put_color(static_cast<std::uint16_t>(value)); break;
        default: put_color(static_cast<float>(value)); break;
      }
    }
  }

  template <class T>
  void put_color(T value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    mesh_.colors.insert(mesh_.colors.end(), bytes.begin(), bytes.end());
  }

  bool may_name(const PlyValue& value) const {
    return (value.value >= 0 && value.value < none) ||
           refuse(value, fmt::format("the face names vertex {}, which cannot exist", value.value));
  }

  bool corner(const PlyValue& value) {
    if (!may_name(value)) return false;
    mesh_.corners.push_back({static_cast<std::uint32_t>(value.value), none, none});
    return true;
  }

  bool strip_vertex(const PlyValue& value) {
    if (value.value != PlyStrip::restart && !may_name(value)) return false;
    const auto triangle = strip_.add(value.value);
    if (!triangle) return true;
    if (mesh_.corners.size() > none - 3) return refuse(value, "the strips have too many triangles");
    for (const std::uint32_t vertex : *triangle) mesh_.corners.push_back({vertex, none, none});
    end_face(value.begin);
    return true;
  }

  void end_face(std::size_t place) {
    mesh_.ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    places_.push_back(place);
  }

  /// The number of the wedge's texture coordinate; equal ones are one.
  std::uint32_t wedge_number(std::size_t i) {
    const std::array<float, 2> uv{wedge_[2 * i], wedge_[2 * i + 1]};
    const auto [found, is_new] = wedge_numbers_.try_emplace(uv, static_cast<std::uint32_t>(mesh_.texcoords.size()));
    if (is_new) mesh_.texcoords.emplace_back(uv[0], 1 - uv[1]);
    return found->second;
  }

  /// Faces may come before the vertices, so all are looked at in the end.
  bool all_vertices_exist() const {
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      for (const Corner& corner : mesh_.face(f)) {
        if (corner.position < mesh_.positions.size()) continue;
        return refuse({.begin = places_[f]}, fmt::format("the face names vertex {}, but there are {}, counted from 0",
                                                         corner.position, mesh_.positions.size()));
      }
    }
    return true;
  }

  void give_corners_their_attributes() {
    for (Corner& corner : mesh_.corners) {
      if (has_normals_) corner.normal = corner.position;
      if (has_texcoords_ && !has_wedges_) corner.texcoord = corner.position;
    }
  }

  /// What follows the last record.
  bool look_behind(std::size_t end) const {
    std::string_view rest = reading_.text.substr(end);
    const std::size_t size = rest.size();
    const std::string_view token = take_token(rest);
    const bool has_more = is_text() ? !token.empty() : size > 0;
    if (!header_.unknown_word.empty()) {
      if (has_more) return refuse_unknown_word(reading_, header_);
      reading_.fault("header-line", header_.unknown_word,
                     fmt::format("{} is not a keyword of a PLY header", shown(header_.unknown_word)));
    } else if (has_more && is_text()) {
      reading_.fault("lines-left-out", token, "the file goes on behind its last record");
    } else if (has_more) {
      reading_.fault_at_byte("bytes-left-out", end, fmt::format("{} bytes follow the last record", size));
    }
    return true;
  }

  void tell_left_out() const {
    std::string names;
    for (std::size_t e = 0; e < meanings_.size(); ++e) {
      const PlyElement& element = header_.elements[e];
      if (element.count == 0) continue;
      for (std::size_t p = 0; p < meanings_[e].size(); ++p) {
        if (wants(e, p)) continue;
        names += fmt::format("{}{}.{}", names.empty() ? "" : ", ", element.name, element.properties[p].name);
      }
    }
    if (names.empty()) return;
    reading_.diagnostics.note({.file = reading_.name}, "properties-left-out",
                              fmt::format("properties that a scene cannot hold are left out: {}", names));
  }

  bool is_read(Meaning meaning) const {
    switch (meaning) {
      case Meaning::nothing: return false;
      case Meaning::nx:
      case Meaning::ny:
      case Meaning::nz: return has_normals_;
      case Meaning::u:
      case Meaning::v: return has_texcoords_ && !has_wedges_;
      case Meaning::red:
      case Meaning::green:
      case Meaning::blue: return mesh_.color_format.components > 0;
      case Meaning::alpha: return mesh_.color_format.components == 4;
      default: return true;
    }
  }

  const Reading& reading_;
  const PlyHeader& header_;
  PolygonMesh& mesh_;
  std::vector<std::vector<Meaning>> meanings_;  // [element][property]
  std::array<double, 12> row_{};                // of the vertex being read, by meaning
  bool has_normals_ = false, has_texcoords_ = false, has_wedges_ = false;
  std::vector<float> wedge_;
  std::map<std::array<float, 2>, std::uint32_t> wedge_numbers_;
  PlyStrip strip_;
  std::vector<std::size_t> places_;  // [face] = where its record begins, or the last vertex of its part of a strip
};

}  // namespace

bool read_ply(const Reading& reading, PolygonMesh& mesh) {
  const auto header = read_ply_header(reading);
  return header && PlyReader(reading, *header, mesh).run();
}

}  // namespace foredraw::mesh_files
