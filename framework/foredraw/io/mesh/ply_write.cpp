// PLY written back: the records of vertices and faces change places, faces with their vertices' new numbers.
#include <foredraw/io/mesh/private/ply.h>
#include <foredraw/io/mesh/private/source.h>

namespace foredraw::mesh_files {

namespace {

/// Where the records of vertices and faces lie, and where in a face its corners stand.
struct PlyPlaces {
  explicit PlyPlaces(const PlyHeader& header, std::string_view text)
      : header(header), text(text), corner_list(header.corner_list()) {}

  struct Face {
    std::string_view record;
    std::size_t first_corner = 0, end_corner = 0;  ///< in `corners`
  };
  struct Vertex {
    std::string_view place;
    std::uint32_t number = 0;
  };

  // The visitor of the walk.
  bool wants(std::size_t e, std::size_t p) const {
    const PlyProperty* property = &header.elements[e].properties[p];
    return property == corner_list || (header.elements[e].name == strips_name && names_vertices(*property));
  }
  bool list(std::size_t, std::size_t, std::size_t) {
    strip.begin();
    return true;
  }
  bool value(std::size_t e, std::size_t, const PlyValue& value) {
    if (header.elements[e].name == strips_name) {
      if (strip.add(value.value)) ++strip_triangles;
      return true;
    }
    corners.push_back({text.substr(value.begin, value.end - value.begin), static_cast<std::uint32_t>(value.value)});
    return true;
  }
  bool record(std::size_t e, std::size_t begin, std::size_t end) {
    const std::string_view bytes = text.substr(begin, end - begin);
    if (header.elements[e].name == "vertex") vertices.push_back(bytes);
    if (header.elements[e].name == "face") {
      faces.push_back({bytes, faces.empty() ? 0 : faces.back().end_corner, corners.size()});
    }
    return true;
  }

  const PlyHeader& header;
  std::string_view text;
  const PlyProperty* corner_list;  ///< not null where there are corners
  std::vector<std::string_view> vertices;
  std::vector<Face> faces;
  std::vector<Vertex> corners;
  PlyStrip strip;
  std::size_t strip_triangles = 0;
};

/// Whether every vertex has a number that the type of the corners can hold.
bool can_number(std::size_t vertices, PlyType type) {
  const bool is_signed = type == PlyType::int8 || type == PlyType::int16 || type == PlyType::int32;
  return vertices <= std::uint64_t{1} << (8 * bytes_of(type) - (is_signed ? 1 : 0));
}

class PlyWriting {
 public:
  PlyWriting(const PlyPlaces& places, const MeshOrder& order) : places_(places), order_(order) {}

  std::string run() {
    std::vector<std::string_view> moved = places_.vertices;
    for (std::size_t v = 0; v < order_.positions.size(); ++v) moved[order_.positions[v]] = places_.vertices[v];
    done_ = places_.text.data();
    result_.reserve(places_.text.size());
    // Elements stand in the sequence of the header.
    for (const PlyElement& element : places_.header.elements) {
      if (element.name == "vertex") {
        for (std::size_t i = 0; i < moved.size(); ++i) put(places_.vertices[i], moved[i]);
      }
      if (element.name == "face") {
        for (std::size_t i = 0; i < places_.faces.size(); ++i) {
          put(places_.faces[i].record, face(places_.faces[order_.faces[i]]));
        }
      }
    }
    return std::move(result_.append(done_, places_.text.data() + places_.text.size()));
  }

 private:
  void put(std::string_view place, std::string_view content) {
    result_.append(done_, place.data());
    result_ += content;
    done_ = place.data() + place.size();
  }

  std::string face(const PlyPlaces::Face& face) const {
    if (order_.positions.empty()) return std::string(face.record);
    std::string result;
    const char* done = face.record.data();
    for (std::size_t c = face.first_corner; c < face.end_corner; ++c) {
      const PlyPlaces::Vertex& corner = places_.corners[c];
      result.append(done, corner.place.data());
      done = corner.place.data() + corner.place.size();
      const std::uint32_t number = order_.positions[corner.number];
      if (places_.header.encoding == PlyHeader::Encoding::ascii) {
        result += std::to_string(number);
        continue;
      }
      result += corner.place;
      put_ply_integer(std::span(result).last(corner.place.size()), number,
                      places_.header.encoding == PlyHeader::Encoding::big);
    }
    return result.append(done, face.record.data() + face.record.size());
  }

  const PlyPlaces& places_;
  const MeshOrder& order_;
  std::string result_;
  const char* done_ = nullptr;
};

}  // namespace

std::optional<std::string> reordered_ply(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics) {
  Reading reading{source.as_read.name, source.text(), diagnostics};
  auto header = read_ply_header(reading);
  if (!header) return std::nullopt;
  const std::string listed = ply_with_faces_for_strips(reading, *header);
  if (!listed.empty()) {
    reading.text = listed;
    header = read_ply_header(reading);
  }
  PlyPlaces places(*header, reading.text);
  if (!PlyWalk(reading, *header).run(places)) return std::nullopt;
  const std::size_t faces = places.faces.size() + places.strip_triangles;
  const auto order = order_of(scene, source, {faces, places.vertices.size()}, diagnostics);
  if (!order) return std::nullopt;
  if (!order->moved) return std::string(source.text());
  for (const PlyElement& element : header->elements) {
    const bool is_ours = element.name == "vertex" || element.name == "face";
    if (is_ours || element.count == 0) continue;
    diagnostics.error(
        reading.at(element.count_token), "cannot-express",
        "element '" + element.name + "' may refer to vertices or faces by number, and the numbers would become wrong",
        "give the output the extension .glb");
    return std::nullopt;
  }
  if (order->positions.empty() || places.corners.empty()) return PlyWriting(places, *order).run();
  for (const PlyProperty& property : header->find("face")->properties) {
    if (!names_vertices(property) || &property == places.corner_list) continue;
    diagnostics.error({.file = reading.name}, "cannot-express",
                      "'" + property.name + "' names vertices besides '" + places.corner_list->name +
                          "', and its numbers would become wrong",
                      "give the output the extension .glb");
    return std::nullopt;
  }
  if (!can_number(places.vertices.size(), places.corner_list->type)) {
    diagnostics.error({.file = reading.name}, "cannot-express",
                      "the type of 'vertex_indices' is too narrow to name every vertex",
                      "give the output the extension .glb");
    return std::nullopt;
  }
  return PlyWriting(places, *order).run();
}

}  // namespace foredraw::mesh_files
