#pragma once
// PLY: a header that says what follows, and a walk over what follows. Private to io.

#include <foredraw/io/mesh/private/polygon_mesh.h>
#include <foredraw/io/mesh/private/text.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstring>

namespace foredraw::mesh_files {

enum class PlyType : std::uint8_t { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
std::size_t bytes_of(PlyType type);
inline bool is_whole(PlyType type) { return type < PlyType::float32; }

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;
  std::optional<PlyType> list;  ///< the type of its length, where it is a list
  std::string_view type_token;  ///< where the header says which type
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  std::string_view count_token;  ///< where the header says how many
  std::string_view lines;        ///< of the header, from its own to that of its last property, their ends included
};

struct PlyHeader {
  enum class Encoding { ascii, little, big } encoding = Encoding::ascii;
  std::vector<PlyElement> elements;
  std::size_t end = 0;            ///< where the first record begins
  std::string_view unknown_word;  ///< the first that begins a line and is no keyword; the line was skipped

  const PlyElement* find(std::string_view name) const;
  /// The list that holds the faces' corners; nullptr: there is none.
  const PlyProperty* corner_list() const;
};

std::optional<PlyHeader> read_ply_header(const Reading& reading);
/// False, with the error: a line of the header that was skipped may have said something about the records.
bool refuse_unknown_word(const Reading& reading, const PlyHeader& header);
bool read_ply(const Reading& reading, PolygonMesh& mesh);

/// Whether a face's property may be its list of corners: "vertex_indices" or "vertex_index". Of both the first is.
inline bool names_vertices(const PlyProperty& p) {
  return p.list && is_whole(p.type) && (p.name == "vertex_indices" || p.name == "vertex_index");
}

/// An element of triangle strips, as Stanford's and Cyberware's tools write them, beside or instead of the faces.
inline constexpr std::string_view strips_name = "tristrips";

/// A strip's triangles, number by number.
class PlyStrip {
 public:
  static constexpr double restart = -1;  ///< begins a strip anew

  void begin() { length_ = 0; }

  /// The triangle that ends with this vertex, all of them wound alike; nothing where there are less than three so far,
  /// and where two corners are one, which only leads from one part of a strip to the next. `number`: of a vertex, below
  /// `none`, or a restart.
  std::optional<std::array<std::uint32_t, 3>> add(double number);

 private:
  std::uint32_t before_ = 0, last_ = 0;
  std::size_t length_ = 0;
};

/// The text with an element of faces for that of strips, so that each triangle is a record; empty where there are no
/// strips, or faces too, or more about strips than their vertices. The text is one that the reader has read.
std::string ply_with_faces_for_strips(const Reading& reading, const PlyHeader& header);

/// A value as the walk comes by it.
struct PlyValue {
  double value = 0;
  std::size_t begin = 0, end = 0;  ///< its bytes in the file
};

/// Goes through every record of the file. Nothing is believed of counts that the bytes present do not bear out. Where a
/// text has a line for each record, values that a line has too many, or of those that nobody wants too few, are a
/// fault.
class PlyWalk {
 public:
  PlyWalk(const Reading& reading, const PlyHeader& header)
      : reading_(reading), header_(header), at_(header.end), by_lines_(has_line_for_each_record()) {}

  /// Calls visit.value(element, property, value) for each value, visit.list(element, property, length) before those of
  /// a list, visit.record(element, begin, end) after each record; numbers of elements and properties as in the header.
  /// Values of a property that visit.wants(element, property) denies are passed over, whatever they are. False, with an
  /// error, where the file does not hold what its header says, or where a visitor said false.
  template <class Visitor>
  bool run(Visitor& visit) {
    for (std::size_t e = 0; e < header_.elements.size(); ++e) {
      const PlyElement& element = header_.elements[e];
      if (element.properties.empty()) continue;
      if (!by_lines_ && !may_hold(element)) return false;
      for (std::uint64_t i = 0; i < element.count; ++i) {
        begin_ = none_yet;
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
          if (!property(visit, e, p)) return false;
        }
        if (by_lines_) end_line();
        if (!visit.record(e, begin_, at_)) return false;
      }
    }
    return true;
  }

  /// Where the last record ends, once all have been gone through.
  std::size_t end() const { return at_; }

 private:
  static constexpr std::size_t none_yet = ~std::size_t{0};

  template <class Visitor>
  bool property(Visitor& visit, std::size_t e, std::size_t p) {
    const PlyProperty& property = header_.elements[e].properties[p];
    const bool wanted = visit.wants(e, p);
    PlyValue value;
    if (!wanted && is_line_over()) return miss();
    if (!property.list && !wanted) return pass_over(property.type, 1);
    if (!property.list) return read(property.type, value) && visit.value(e, p, value);
    if (!read(*property.list, value)) return false;
    const std::size_t left = reading_.text.size() - at_;
    const std::size_t least = header_.encoding == PlyHeader::Encoding::ascii ? 1 : bytes_of(property.type);
    if (value.value < 0 || value.value > static_cast<double>(left / least)) return refuse_list(value, left);
    const auto length = static_cast<std::size_t>(value.value);
    if (!wanted) return pass_over(property.type, length);
    if (!visit.list(e, p, length)) return false;
    for (std::size_t i = 0; i < length; ++i) {
      if (!read(property.type, value) || !visit.value(e, p, value)) return false;
    }
    return true;
  }

  bool has_line_for_each_record() const;
  bool is_line_over() const;  ///< inside a record
  bool miss() const;
  void end_line();
  bool may_hold(const PlyElement& element) const;
  bool refuse_list(const PlyValue& value, std::size_t left) const;
  /// Finds the bytes of the next value.
  bool find(PlyType type, PlyValue& value);
  bool read(PlyType type, PlyValue& value);
  bool read_text(PlyType type, PlyValue& value) const;
  bool pass_over(PlyType type, std::size_t count);

  const Reading& reading_;
  const PlyHeader& header_;
  std::size_t at_;
  std::size_t begin_ = none_yet;  ///< of the record
  bool by_lines_;
};

/// A value written over its old place in a binary file; only whole numbers.
void put_ply_integer(std::span<char> bytes, std::uint32_t value, bool big_endian);

}  // namespace foredraw::mesh_files
