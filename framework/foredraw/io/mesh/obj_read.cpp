#include <foredraw/io/mesh/private/obj.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw::mesh_files {

namespace {

constexpr std::array<std::string_view, 26> without_faces = {
    "s",      "mg",     "bevel", "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj", "usemap",
    "maplib", "cstype", "deg",   "bmat",     "step",     "parm", "trim",       "hole",      "scrv",
    "sp",     "end",    "con",   "ctech",    "stech",    "call", "csh",        "vp"};
constexpr std::size_t most_names_bytes = std::size_t{16} << 20;  // besides 4 times the file

constexpr std::array<std::string_view, 8> left_out_elements = {"l", "p", "curv", "curv2", "surf", "bzp", "bsp", "cdc"};

class ObjReader {
 public:
  ObjReader(const Reading& reading, PolygonMesh& mesh, std::vector<std::string>& libraries)
      : reading_(reading), mesh_(mesh), libraries_(libraries) {}

  bool run() {
    std::string_view text = without_mark(reading_.text);
    ObjLine line;
    while (take_obj_line(text, line)) {
      if (!line.keyword.empty() && !read(line)) return false;
    }
    if (!all_records_exist()) return false;
    choose_parts();
    keep_colors();
    tell();
    return true;
  }

 private:
  bool read(const ObjLine& line) {
    const std::string_view key = line.keyword;
    if (key == "v") return position(line);
    if (key == "vt") return texcoord(line);
    if (key == "vn") return normal(line);
    if (key == "f" || key == "fo") return face(line);
    if (key == "o") has_objects_ = true;
    if (key == "o") names_[0] = obj_name(line.rest);
    if (key == "g") names_[1] = obj_name(line.rest);
    if (key == "usemtl") names_[2] = obj_name(line.rest);
    if (key == "o" || key == "g" || key == "usemtl") {
      part_.reset();
      return true;
    }
    if (key == "mtllib") {
      libraries_.emplace_back(trimmed(line.rest));
    } else if (std::ranges::count(left_out_elements, key) > 0) {
      reading_.fault("elements-left-out", key, fmt::format("'{}' makes no faces, and only faces are read", key));
    } else if (std::ranges::count(without_faces, key) == 0) {
      reading_.fault("unknown-line", key, fmt::format("{} is not a keyword of OBJ", shown(key)));
    }
    return true;
  }

  /// All numbers of a record, `least` at least; false, with an error, where one is none. The first `exact` ones place
  /// vertices; of others, those that are not finite are 0.
  bool numbers(const ObjLine& line, std::size_t least, std::size_t most, std::size_t exact) {
    values_.clear();
    std::string_view rest = line.rest;
    for (std::string_view token = take_obj_token(rest); !token.empty(); token = take_obj_token(rest)) {
      if (values_.size() == most) {
        return reading_.refuse(reading_.at(token), fmt::format("'{}' takes at most {} numbers", line.keyword, most));
      }
      float value = 0;
      const bool is_exact = values_.size() < exact;
      if (!(is_exact ? reading_.read(token, value) : reading_.read_attribute(token, value))) return false;
      values_.push_back(value);
    }
    if (values_.size() >= least) return true;
    return reading_.refuse(reading_.at(line.keyword), fmt::format("'{}' takes at least {} numbers, but has {}",
                                                                  line.keyword, least, values_.size()));
  }

  bool position(const ObjLine& line) {
    if (!numbers(line, 3, 7, 3)) return false;
    mesh_.positions.emplace_back(values_[0], values_[1], values_[2]);
    ++so_far_.positions;
    if (values_.size() == 5)
      return reading_.refuse(reading_.at(line.keyword), "a vertex has 3, 4, 6 or 7 numbers, not 5");
    if (values_.size() == 4 && values_[3] != 1) ++weights_;
    if (values_.size() >= 6) {
      colors_.resize(3 * (mesh_.positions.size() - 1), 1.0f);
      colors_.insert(colors_.end(), values_.begin() + 3, values_.begin() + 6);
    }
    return true;
  }

  bool texcoord(const ObjLine& line) {
    if (!numbers(line, 1, 3, 0)) return false;
    mesh_.texcoords.emplace_back(values_[0], 1 - (values_.size() > 1 ? values_[1] : 0));
    ++so_far_.texcoords;
    return true;
  }

  bool normal(const ObjLine& line) {
    if (!numbers(line, 3, 3, 0)) return false;
    mesh_.normals.emplace_back(values_[0], values_[1], values_[2]);
    ++so_far_.normals;
    return true;
  }

  bool face(const ObjLine& line) {
    std::string_view rest = line.rest;
    for (std::string_view token = take_obj_token(rest); !token.empty(); token = take_obj_token(rest)) {
      Corner corner;
      const std::string wrong = read_obj_corner(token, so_far_, corner);
      if (!wrong.empty()) return reading_.refuse(reading_.at(token), wrong);
      mesh_.corners.push_back(corner);
    }
    mesh_.ends.push_back(static_cast<std::uint32_t>(mesh_.corners.size()));
    places_.push_back(line.keyword.data());
    if (!part_) {
      const auto [found, is_new] = name_numbers_.try_emplace(names_, static_cast<std::uint32_t>(name_numbers_.size()));
      if (is_new) {
        parts_.push_back(names_);
        for (const std::string& name : names_) names_bytes_ += name.size();
        if (names_bytes_ > most_names_bytes + 4 * reading_.text.size()) {
          return reading_.refuse(reading_.at(line.keyword),
                                 "there are too many objects, groups and materials with names of this length");
        }
      }
      part_ = found->second;
    }
    mesh_.part.push_back(*part_);
    return true;
  }

  /// Corners may name records that come after them, so all are looked at in the end. Texture coordinates and normals
  /// that are not there are none.
  bool all_records_exist() {
    const auto exists = [&](std::string_view what, std::uint32_t& record, std::size_t count, std::size_t face) {
      if (record == none || record < count) return true;
      const std::string_view place(places_[face], 1);
      std::string message = record == absent ? fmt::format("the face names a '{}' before the first", what)
                                             : fmt::format("the face names '{}' number {}, but the file has {}", what,
                                                           std::size_t{record} + 1, count);
      if (what == "v") return reading_.refuse(reading_.at(place), std::move(message));
      reading_.fault("missing-attribute", place, std::move(message));
      record = none;
      return true;
    };
    for (std::size_t f = 0; f < mesh_.face_count(); ++f) {
      for (std::size_t c = mesh_.first_corner(f); c < mesh_.ends[f]; ++c) {
        Corner& corner = mesh_.corners[c];
        if (!exists("v", corner.position, mesh_.positions.size(), f) ||
            !exists("vt", corner.texcoord, mesh_.texcoords.size(), f) ||
            !exists("vn", corner.normal, mesh_.normals.size(), f)) {
          return false;
        }
      }
    }
    return true;
  }

  /// Objects part a file; where it has none, its groups do.
  void choose_parts() {
    if (parts_.empty()) return;
    std::map<Part, std::uint32_t> numbers;
    std::vector<std::uint32_t> of_names;
    mesh_.parts.clear();
    for (const auto& [object, group, material] : parts_) {
      const Part part{has_objects_ ? object : group, material};
      const auto [found, is_new] = numbers.try_emplace(part, static_cast<std::uint32_t>(mesh_.parts.size()));
      if (is_new) mesh_.parts.push_back(part);
      of_names.push_back(found->second);
    }
    for (std::uint32_t& part : mesh_.part) part = of_names[part];
  }

  void keep_colors() {
    if (colors_.empty()) return;
    colors_.resize(3 * mesh_.positions.size(), 1.0f);
    mesh_.color_format = {Component::float32, 3, false, 12};
    const auto bytes = std::as_bytes(std::span(colors_));
    mesh_.colors.assign(bytes.begin(), bytes.end());
  }

  void tell() const {
    Diagnostics& diagnostics = reading_.diagnostics;
    const Where where{.file = reading_.name};
    if (weights_ > 0) {
      diagnostics.warning(where, "weights-left-out", fmt::format("the weights of {} vertices are left out", weights_));
    }
  }

  using Names = std::array<std::string, 3>;  // object, group, material
  const Reading& reading_;
  PolygonMesh& mesh_;
  std::vector<std::string>& libraries_;
  ObjCounts so_far_;
  std::vector<float> values_, colors_;
  std::vector<const char*> places_;  // [face] = where its line is
  Names names_;
  bool has_objects_ = false;
  std::map<Names, std::uint32_t> name_numbers_;
  std::optional<std::uint32_t> part_;  // of the names that hold now
  std::vector<Names> parts_;
  std::size_t names_bytes_ = 0;  ///< of all parts: a long name that stays is held anew by each part that has it
  std::size_t weights_ = 0;
};

}  // namespace

bool read_obj(const Reading& reading, PolygonMesh& mesh, std::vector<std::string>& libraries) {
  const std::size_t zero = reading.text.find('\0');
  if (zero == std::string_view::npos) return ObjReader(reading, mesh, libraries).run();
  const std::string_view rest = reading.text.substr(zero);
  if (!std::ranges::all_of(rest, [](char c) { return c == '\0' || is_space(c); })) {
    return reading.refuse(reading.at_byte(zero), "found a zero byte: the file is not text");
  }
  reading.fault("zero-bytes", rest, "found zero bytes after the text");
  Reading before = reading;
  before.text = reading.text.substr(0, zero);
  return ObjReader(before, mesh, libraries).run();
}

}  // namespace foredraw::mesh_files
