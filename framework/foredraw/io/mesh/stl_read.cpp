#include <foredraw/io/mesh/private/stl.h>
#include <foredraw/io/mesh/private/stl_colors.h>

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace foredraw::mesh_files {

namespace {

std::uint32_t little_endian(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

std::uint64_t triangles_announced(std::string_view text) { return little_endian(text.data() + stl_header - 4); }

/// STL has no vertices, only corners; corners at equal places, of triangles of equal colours, become one.
class Welding {
 public:
  explicit Welding(PolygonMesh& mesh) : mesh_(mesh) {}

  void corner(glm::vec3 position, StlColor color = {}) {
    position += 0.0f;  // -0 is 0
    const auto [found, is_new] =
        numbers_.try_emplace(Vertex{position, color}, static_cast<std::uint32_t>(mesh_.positions.size()));
    if (is_new) mesh_.positions.push_back(position);
    if (is_new && mesh_.color_format.components > 0) {
      for (const std::uint8_t channel : color) mesh_.colors.push_back(std::byte{channel});
    }
    mesh_.corners.push_back({found->second, none, none});
  }

  void end_face() { mesh_.ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size())); }

 private:
  struct Vertex {
    glm::vec3 position;
    StlColor color;
    friend bool operator==(const Vertex&, const Vertex&) = default;
  };
  struct Hash {
    std::size_t operator()(const Vertex& vertex) const {
      const auto& [p, color] = vertex;
      std::uint64_t h = std::uint64_t{color[0]} << 16 | color[1] << 8 | color[2];
      h = (h ^ std::bit_cast<std::uint32_t>(p.x)) * 0x9E3779B97F4A7C15u;
      h = (h ^ (h >> 29) ^ std::bit_cast<std::uint32_t>(p.y)) * 0xBF58476D1CE4E5B9u;
      h = (h ^ (h >> 32) ^ std::bit_cast<std::uint32_t>(p.z)) * 0x94D049BB133111EBu;
      return h ^ (h >> 31);
    }
  };

  PolygonMesh& mesh_;
  std::unordered_map<Vertex, std::uint32_t, Hash> numbers_;
};

bool read_binary(const Reading& reading, PolygonMesh& mesh) {
  const std::string_view text = reading.text;
  const std::uint64_t count = triangles_announced(text);
  const std::size_t left = text.size() - stl_header;
  if (count > left / stl_record) {
    return reading.refuse(
        reading.at_byte(stl_header - 4),
        fmt::format("{} triangles of {} bytes each do not fit in the {} bytes that are left", count, stl_record, left));
  }
  const StlColors colors(text, count);
  if (colors.are_there()) mesh.color_format = {Component::uint8, 3, true, 3};
  Welding welding(mesh);
  for (std::uint64_t t = 0; t < count; ++t) {
    const std::size_t begin = stl_header + t * stl_record;
    const StlColor color = colors.of(t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      glm::vec3 position;
      for (int i = 0; i < 3; ++i) {
        const std::size_t at = begin + 12 + 12 * corner + 4 * static_cast<std::size_t>(i);
        position[i] = std::bit_cast<float>(little_endian(text.data() + at));
        if (!std::isfinite(position[i])) {
          return reading.refuse(reading.at_byte(at), fmt::format("a coordinate of triangle {} is not finite", t));
        }
      }
      welding.corner(position, color);
    }
    welding.end_face();
  }
  if (const std::string told = colors.told(); !told.empty()) {
    reading.diagnostics.note({.file = reading.name}, colors.are_there() ? "colors-read" : "attributes-left-out", told);
  }
  if (const std::size_t more = left - count * stl_record; more > 0) {
    reading.fault_at_byte("bytes-left-out", text.size() - more, fmt::format("{} bytes follow the last triangle", more));
  }
  return true;
}

class TextReader {
 public:
  TextReader(const Reading& reading, PolygonMesh& mesh) : reading_(reading), mesh_(mesh), welding_(mesh) {}

  bool run() {
    mesh_.parts.clear();
    for (std::string_view word = take(); !word.empty(); word = take()) {
      if (lower_case(word) != "solid") {
        return reading_.refuse(reading_.at(word), fmt::format("expected 'solid', found {}", shown(word)));
      }
      if (!solid()) return false;
    }
    return !mesh_.parts.empty() || reading_.refuse({.file = reading_.name}, "the file has no solid");
  }

 private:
  std::string_view take() { return take_token(text_); }

  bool expect(std::string_view what) {
    const std::string_view word = take();
    if (lower_case(word) == what) return true;
    if (word.empty())
      return reading_.refuse(reading_.at(text_), fmt::format("expected '{}', found the end of the file", what));
    return reading_.refuse(reading_.at(word), fmt::format("expected '{}', found {}", what, shown(word)));
  }

  bool solid() {
    const std::string name = name_in(take_solid_name(text_));
    const auto part = static_cast<std::uint32_t>(mesh_.parts.size());
    mesh_.parts.push_back({name, {}});
    for (;;) {
      const std::string_view word = take();
      const std::string lower = lower_case(word);
      if (lower == "endsolid") {
        take_solid_name(text_);
        return true;
      }
      if (word.empty()) return reading_.refuse(reading_.at(text_), "the file ends inside a solid");
      if (lower != "facet") {
        return reading_.refuse(reading_.at(word), fmt::format("expected 'facet' or 'endsolid', found {}", shown(word)));
      }
      if (!facet()) return false;
      mesh_.part.push_back(part);
    }
  }

  /// The normal follows from the corners, so it is read over, whatever it is.
  bool facet() {
    if (!expect("normal")) return false;
    for (int i = 0; i < 3; ++i) take();
    if (!expect("outer") || !expect("loop")) return false;
    for (;;) {
      const std::string_view word = take();
      const std::string lower = lower_case(word);
      if (lower == "endloop") break;
      if (lower != "vertex") {
        return reading_.refuse(reading_.at(word), fmt::format("expected 'vertex' or 'endloop', found {}", shown(word)));
      }
      glm::vec3 position;
      for (int i = 0; i < 3; ++i) {
        if (!reading_.read(take(), position[i])) return false;
      }
      welding_.corner(position);
    }
    welding_.end_face();
    return expect("endfacet");
  }

  const Reading& reading_;
  PolygonMesh& mesh_;
  Welding welding_;
  std::string_view text_ = without_mark(reading_.text);
};

}  // namespace

bool is_binary_stl(std::string_view text) {
  if (text.size() < stl_header) return false;
  if (stl_header + triangles_announced(text) * stl_record == text.size()) return true;
  std::string_view rest = without_mark(text);
  const bool says_solid = lower_case(take_token(rest)) == "solid";
  // A text file has no zero bytes; a header padded with them is binary, whatever its first word.
  return !says_solid || text.find('\0') != std::string_view::npos;
}

std::string_view take_solid_name(std::string_view& text) {
  std::string_view name = text.substr(0, text.find_first_of("\r\n"));
  std::string_view rest = name;
  for (std::string_view word = take_token(rest); !word.empty(); word = take_token(rest)) {
    std::string_view next = rest;
    if (lower_case(word) != "facet" || lower_case(take_token(next)) != "normal") continue;
    name = name.substr(0, static_cast<std::size_t>(word.data() - name.data()));
    break;
  }
  text.remove_prefix(name.size());
  return name;
}

bool read_stl(const Reading& reading, PolygonMesh& mesh) {
  const bool done = is_binary_stl(reading.text) ? read_binary(reading, mesh) : TextReader(reading, mesh).run();
  mesh.whole_vertices = mesh.parts.size() == 1;  // of several solids each gets its own
  return done;
}

}  // namespace foredraw::mesh_files
