// PLY's triangle strips: one triangle after the other, and the file with a list of them instead.
#include <foredraw/io/mesh/private/ply.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::mesh_files {

namespace {

/// Goes through the strips and writes their triangles as records of faces, lengths in one byte and vertices in four.
struct FacesOfStrips {
  explicit FacesOfStrips(const PlyHeader& header) : header(header), strips(header.find(strips_name)) {}

  // The visitor of the walk.
  bool wants(std::size_t e, std::size_t) const { return &header.elements[e] == strips; }
  bool list(std::size_t, std::size_t, std::size_t) {
    strip.begin();
    return true;
  }
  bool value(std::size_t, std::size_t, const PlyValue& value) {
    if (const auto triangle = strip.add(value.value)) put(*triangle);
    return true;
  }
  bool record(std::size_t e, std::size_t from, std::size_t to) {
    if (&header.elements[e] != strips) return true;
    begin = std::min(begin, from);
    end = to;
    return true;
  }

  void put(const std::array<std::uint32_t, 3>& triangle) {
    ++count;
    if (header.encoding == PlyHeader::Encoding::ascii) {
      if (count > 1) records += '\n';
      records += fmt::format("3 {} {} {}", triangle[0], triangle[1], triangle[2]);
      return;
    }
    records += '\3';
    for (const std::uint32_t vertex : triangle) {
      records.append(4, '\0');
      put_ply_integer(std::span(records).last(4), vertex, header.encoding == PlyHeader::Encoding::big);
    }
  }

  const PlyHeader& header;
  const PlyElement* strips;
  PlyStrip strip;
  std::size_t count = 0;
  std::string records;
  std::size_t begin = ~std::size_t{0}, end = 0;  ///< of the strips' records in the file
};

}  // namespace

std::optional<std::array<std::uint32_t, 3>> PlyStrip::add(double number) {
  if (number == restart) {
    begin();
    return std::nullopt;
  }
  const auto vertex = static_cast<std::uint32_t>(number);
  const bool is_turned = length_ % 2 == 1;
  const std::array<std::uint32_t, 3> triangle{is_turned ? last_ : before_, is_turned ? before_ : last_, vertex};
  before_ = last_;
  last_ = vertex;
  const bool is_whole = ++length_ >= 3;
  if (!is_whole || triangle[0] == triangle[1] || triangle[1] == vertex || vertex == triangle[0]) return std::nullopt;
  return triangle;
}

std::string ply_with_faces_for_strips(const Reading& reading, const PlyHeader& header) {
  FacesOfStrips faces(header);
  const PlyElement* strips = faces.strips;
  const bool can_be_faces = strips != nullptr && strips->count > 0 && strips->properties.size() == 1;
  if (!can_be_faces || header.find("face") != nullptr || !PlyWalk(reading, header).run(faces)) return {};
  const std::string_view text = reading.text, lines = strips->lines;
  const std::string_view line_end =
      lines.ends_with("\r\n") ? lines.substr(lines.size() - 2) : lines.substr(lines.size() - 1);
  std::string result(text.data(), lines.data());
  result += fmt::format("element face {1}{0}property list uchar int vertex_indices{0}", line_end, faces.count);
  const char* after = lines.data() + lines.size();
  result.append(after, text.data() + faces.begin).append(faces.records);
  return result += text.substr(faces.end);
}

}  // namespace foredraw::mesh_files
