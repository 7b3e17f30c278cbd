#include <foredraw/io/mesh/private/off.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace foredraw::mesh_files {

namespace {

/// "STCNOFF" into what vertices have. False where it is no such word.
bool read_keyword(std::string_view word, OffHeader& header) {
  const auto take = [&](std::string_view prefix) {
    const bool has = word.starts_with(prefix);
    if (has) word.remove_prefix(prefix.size());
    return has;
  };
  header.has_texcoords = take("ST");
  header.has_colors = take("C");
  header.has_normals = take("N");
  return word == "OFF";
}

bool read_counts(const Reading& reading, std::string_view line, OffHeader& header) {
  const std::string_view vertices = take_token(line), faces = take_token(line);
  if (!read_integer(vertices, header.vertices)) {
    return reading.refuse(reading.at(vertices),
                          fmt::format("expected the number of vertices, found {}", shown(vertices)));
  }
  if (!read_integer(faces, header.faces)) {
    return reading.refuse(reading.at(faces), fmt::format("expected the number of faces, found {}", shown(faces)));
  }
  // "0 0 0" and "0" with their line ends are the shortest that a vertex and a face can be.
  const std::uint64_t left = header.body.size() + 1;
  if (header.vertices > left / 6) {
    return reading.refuse(reading.at(vertices), fmt::format("{} vertices do not fit in the {} bytes that are left",
                                                            header.vertices, header.body.size()));
  }
  if (header.faces > left / 2) {
    return reading.refuse(reading.at(faces), fmt::format("{} faces do not fit in the {} bytes that are left",
                                                         header.faces, header.body.size()));
  }
  return true;
}

class OffReader {
 public:
  OffReader(const Reading& reading, const OffHeader& header, PolygonMesh& mesh)
      : reading_(reading), header_(header), mesh_(mesh), text_(header.body) {}

  bool run() {
    mesh_.whole_vertices = true;
    for (std::uint64_t i = 0; i < header_.vertices; ++i) {
      if (!vertex()) return false;
    }
    keep_colors();
    for (std::uint64_t i = 0; i < header_.faces; ++i) {
      if (!face()) return false;
    }
    tell();
    return true;
  }

 private:
  bool next(std::string_view& line) {
    line = take_off_line(text_);
    return !line.empty() || refuse_end();
  }

  bool refuse_end() const {
    return reading_.refuse(reading_.at(text_), "the file ends before all vertices and faces are there");
  }

  bool numbers(std::string_view& line, float* values, int count) {
    for (int i = 0; i < count; ++i) {
      if (!reading_.read(take_token(line), values[i])) return false;
    }
    return true;
  }

  bool attributes(std::string_view& line, float* values, int count) {
    for (int i = 0; i < count; ++i) {
      if (!reading_.read_attribute(take_token(line), values[i])) return false;
    }
    return true;
  }

  bool vertex() {
    std::string_view line;
    std::array<float, 3> v{};
    if (!next(line) || !numbers(line, v.data(), 3)) return false;
    mesh_.positions.emplace_back(v[0], v[1], v[2]);
    if (header_.has_normals) {
      if (!attributes(line, v.data(), 3)) return false;
      mesh_.normals.emplace_back(v[0], v[1], v[2]);
    }
    if (header_.has_colors && !color(line)) return false;
    if (header_.has_texcoords) {
      if (!attributes(line, v.data(), 2)) return false;
      mesh_.texcoords.emplace_back(v[0], 1 - v[1]);
    }
    if (!trimmed(line).empty()) ++vertices_with_more_;
    return true;
  }

  /// Three or four numbers: four where the line has so many besides the texture coordinates. On all lines as on the
  /// first, for the format does not say.
  bool color(std::string_view& line) {
    std::string_view rest = line;
    std::size_t there = 0;
    while (!take_token(rest).empty()) ++there;
    if (header_.has_texcoords) there -= std::min<std::size_t>(there, 2);
    const std::uint8_t size = there >= 4 ? 4 : 3;
    if (color_size_ == 0) color_size_ = size;
    if (size != color_size_) {
      return reading_.refuse(
          reading_.at(line),
          fmt::format("the colour has {} numbers, but that of the first vertex has {}", size, color_size_));
    }
    for (std::uint8_t i = 0; i < color_size_; ++i) {
      const std::string_view token = take_token(line);
      float value = 0;
      if (!reading_.read_attribute(token, value)) return false;
      colors_.push_back(value);
      are_bytes_ = are_bytes_ && token.find_first_not_of("0123456789") == std::string_view::npos && value <= 255;
    }
    return true;
  }

  /// Whole numbers are bytes, others are fractions: the format has no other word for which they are.
  void keep_colors() {
    if (colors_.empty()) return;
    if (!are_bytes_) {
      mesh_.color_format = {Component::float32, color_size_, false, static_cast<std::uint16_t>(4 * color_size_)};
      const auto bytes = std::as_bytes(std::span(colors_));
      mesh_.colors.assign(bytes.begin(), bytes.end());
      return;
    }
    mesh_.color_format = {Component::uint8, color_size_, true, color_size_};
    for (float value : colors_) mesh_.colors.push_back(static_cast<std::byte>(static_cast<std::uint8_t>(value)));
  }

  bool face() {
    if (!take_off_face(text_, face_)) {
      if (face_.size.empty()) return refuse_end();
      return reading_.refuse(reading_.at(face_.size),
                             fmt::format("a face of {} corners does not fit its lines", shown(face_.size)));
    }
    for (const std::string_view token : face_.corners) {
      std::uint32_t vertex = 0;
      if (!read_integer(token, vertex)) {
        return reading_.refuse(reading_.at(token),
                               fmt::format("expected the number of a vertex, found {}", shown(token)));
      }
      if (vertex >= mesh_.positions.size()) {
        return reading_.refuse(
            reading_.at(token),
            fmt::format("the face names vertex {}, but there are {}, counted from 0", vertex, mesh_.positions.size()));
      }
      mesh_.corners.push_back({vertex, header_.has_texcoords ? vertex : none, header_.has_normals ? vertex : none});
    }
    mesh_.ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    if (face_.has_more) ++faces_with_more_;
    return true;
  }

  void tell() {
    const Where where{.file = reading_.name};
    if (vertices_with_more_ > 0) {
      reading_.diagnostics.warning(
          where, "numbers-left-out",
          fmt::format("{} vertices have more numbers than the first line announces; the extra ones are left out",
                      vertices_with_more_));
    }
    if (faces_with_more_ > 0) {
      reading_.diagnostics.note(where, "face-colors-left-out",
                                fmt::format("the colours of {} faces are left out", faces_with_more_));
    }
    if (const std::string_view line = take_off_line(text_); !line.empty()) {
      reading_.fault("lines-left-out", line, "the file continues after its last face");
    }
  }

  const Reading& reading_;
  const OffHeader& header_;
  PolygonMesh& mesh_;
  std::string_view text_;
  OffFace face_;
  std::vector<float> colors_;
  std::uint8_t color_size_ = 0;
  bool are_bytes_ = true;
  std::size_t vertices_with_more_ = 0, faces_with_more_ = 0;
};

}  // namespace

std::string_view take_off_line(std::string_view& text) {
  while (!text.empty()) {
    std::string_view line = take_line(text);
    line = trimmed(line.substr(0, line.find('#')));
    if (!line.empty()) return line;
  }
  return text;
}

bool take_off_face(std::string_view& text, OffFace& face) {
  std::string_view line = take_off_line(text);
  const char* begin = line.data();
  face.size = take_token(line);
  face.corners.clear();
  std::uint64_t size = 0;
  if (!read_integer(face.size, size)) return false;
  bool goes_on = false;
  while (face.corners.size() < size) {
    const std::string_view token = take_token(line);
    if (!token.empty()) {
      face.corners.push_back(token);
      continue;
    }
    line = take_off_line(text);
    if (line.empty()) return false;
    goes_on = true;
  }
  face.has_more = !trimmed(line).empty();
  face.whole = {begin, static_cast<std::size_t>(line.data() + line.size() - begin)};
  return !goes_on || !face.has_more;
}

std::optional<OffHeader> read_off_header(const Reading& reading) {
  OffHeader header;
  header.body = without_mark(reading.text);
  std::string_view line = take_off_line(header.body);
  std::string_view rest = line;
  std::string_view word = take_token(rest);
  const std::string_view letters = word.substr(0, word.find_first_of("0123456789"));
  if (letters.size() < word.size() && read_keyword(letters, header)) {
    reading.fault("keyword", word,
                  fmt::format("there is no space between the keyword and the number of {}", shown(word)));
    word = letters;
  }
  if (read_keyword(word, header)) {
    if (const std::string_view next = take_token(rest); next == "BINARY") {
      reading.refuse(reading.at(next), "binary OFF is not read", "save the mesh as ASCII OFF, or as PLY");
      return std::nullopt;
    }
    line.remove_prefix(word.size());
    line = trimmed(line);
    if (line.empty()) line = take_off_line(header.body);
  } else if (word.empty() || word.find_first_not_of("0123456789") != std::string_view::npos) {
    reading.refuse(reading.at(word),
                   fmt::format("expected OFF, with at most ST, C or N before it, found {}", shown(word)));
    return std::nullopt;
  }
  if (!read_counts(reading, line, header)) return std::nullopt;
  return header;
}

bool read_off(const Reading& reading, PolygonMesh& mesh) {
  const auto header = read_off_header(reading);
  return header && OffReader(reading, *header, mesh).run();
}

}  // namespace foredraw::mesh_files
