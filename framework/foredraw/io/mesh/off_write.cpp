// OFF written back: the lines of vertices and faces change places, faces with their vertices' new numbers.
#include <foredraw/io/mesh/private/off.h>
#include <foredraw/io/mesh/private/source.h>

namespace foredraw::mesh_files {

namespace {

/// The face's line, or lines, with other numbers.
std::string renumbered(std::string_view whole, const std::vector<std::uint32_t>& numbers) {
  std::string result;
  const char* done = whole.data();
  std::string_view rest = whole;
  OffFace face;
  take_off_face(rest, face);
  for (const std::string_view token : face.corners) {
    std::uint32_t vertex = 0;
    read_integer(token, vertex);
    result.append(done, token.data());
    result += std::to_string(numbers[vertex]);
    done = token.data() + token.size();
  }
  return result.append(done, whole.data() + whole.size());
}

}  // namespace

std::optional<std::string> reordered_off(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics) {
  const std::string_view text = source.text();
  const Reading reading{source.as_read.name, text, diagnostics};
  const auto header = read_off_header(reading);
  if (!header) return std::nullopt;
  std::string_view rest = header->body;
  std::vector<std::string_view> vertices(header->vertices);
  for (std::string_view& vertex : vertices) vertex = take_off_line(rest);
  std::vector<std::string_view> faces(header->faces);
  for (OffFace face; std::string_view & whole : faces) {
    take_off_face(rest, face);
    whole = face.whole;
  }
  const auto order = order_of(scene, source, {faces.size(), vertices.size()}, diagnostics);
  if (!order) return std::nullopt;

  std::vector<std::string_view> moved = vertices;
  for (std::size_t v = 0; v < order->positions.size(); ++v) moved[order->positions[v]] = vertices[v];
  std::string result;
  result.reserve(text.size());
  const char* done = text.data();
  const auto put = [&](std::string_view place, std::string_view content) {
    result.append(done, place.data());
    result += content;
    done = place.data() + place.size();
  };
  for (std::size_t place = 0; place < vertices.size(); ++place) put(vertices[place], moved[place]);
  for (std::size_t place = 0; place < faces.size(); ++place) {
    const std::string_view face = faces[order->faces[place]];
    put(faces[place], order->positions.empty() ? std::string(face) : renumbered(face, order->positions));
  }
  return result.append(done, text.data() + text.size());
}

}  // namespace foredraw::mesh_files
