#include <foredraw/io/mesh/private/ply_meanings.h>

#include <fmt/format.h>

#include <map>

namespace foredraw::mesh_files {

namespace {

class PlyReader {
 public:
  PlyReader(const Reading& reading, const PlyHeader& header, const PlyMeanings& meanings, PolygonMesh& mesh)
      : reading_(reading), header_(header), meanings_(meanings), mesh_(mesh) {}

  bool run() {
    mesh_.whole_vertices = true;
    mesh_.color_format = meanings_.color_format;
    PlyWalk walk(reading_, header_);
    if (!walk.run(*this) || !all_vertices_exist()) return false;
    if (meanings_.has_wedges && mesh_.face_count() > 0) mesh_.whole_vertices = false;
    give_corners_their_attributes();
    return look_behind(walk.end());
  }

  // The visitor of the walk.
  bool wants(std::size_t e, std::size_t p) const { return meanings_.of[e][p] != Meaning::nothing; }

  bool list(std::size_t e, std::size_t p, std::size_t) {
    if (meanings_.of[e][p] == Meaning::wedges) wedge_.clear();
    if (meanings_.of[e][p] == Meaning::strip) strip_.begin();
    return true;
  }

  bool value(std::size_t e, std::size_t p, const PlyValue& value) {
    const Meaning meaning = meanings_.of[e][p];
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
    if (meanings_.has_wedges && wedge_.size() == 2 * corners) {
      for (std::size_t i = 0; i < corners; ++i) mesh_.corners[first + i].texcoord = wedge_number(i);
    } else if (meanings_.has_wedges && !wedge_.empty()) {
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

  double at(Meaning meaning) const { return row_[static_cast<std::size_t>(meaning)]; }
  float number(Meaning meaning) const { return static_cast<float>(at(meaning)); }

  void add_vertex() {
    mesh_.positions.emplace_back(number(Meaning::x), number(Meaning::y), number(Meaning::z));
    if (meanings_.has_normals)
      mesh_.normals.emplace_back(number(Meaning::nx), number(Meaning::ny), number(Meaning::nz));
    if (meanings_.has_texcoords) mesh_.texcoords.emplace_back(number(Meaning::u), 1 - number(Meaning::v));
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
      if (meanings_.has_normals) corner.normal = corner.position;
      if (meanings_.has_texcoords) corner.texcoord = corner.position;
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
      reading_.fault("lines-left-out", token, "the file continues after its last record");
    } else if (has_more) {
      reading_.fault_at_byte("bytes-left-out", end, fmt::format("{} bytes follow the last record", size));
    }
    return true;
  }

  const Reading& reading_;
  const PlyHeader& header_;
  const PlyMeanings& meanings_;
  PolygonMesh& mesh_;
  std::array<double, 12> row_{};  // of the vertex being read, by meaning
  std::vector<float> wedge_;
  std::map<std::array<float, 2>, std::uint32_t> wedge_numbers_;
  PlyStrip strip_;
  std::vector<std::size_t> places_;  // [face] = where its record begins, or the last vertex of its part of a strip
};

}  // namespace

bool read_ply(const Reading& reading, PolygonMesh& mesh) {
  const auto header = read_ply_header(reading);
  const auto meanings = header ? ply_meanings(reading, *header) : std::nullopt;
  if (!meanings || !PlyReader(reading, *header, *meanings, mesh).run()) return false;
  tell_left_out(reading, *header, *meanings);
  return true;
}

}  // namespace foredraw::mesh_files
