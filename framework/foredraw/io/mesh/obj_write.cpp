// OBJ written back: faces change places within their draw, records within the block they stand in, and every line
// that is neither stays where it was.
#include <foredraw/io/mesh/private/obj.h>
#include <foredraw/io/mesh/private/source.h>

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace foredraw::mesh_files {

namespace {

struct StateWord {
  std::string_view keyword;
  std::string_view at_first;  ///< the line that brings back what holds before any such line
};

/// What lines say of all faces after them. Objects and materials are missing: they part draws.
constexpr std::array<StateWord, 8> state_words = {{{"g", "g default"},
                                                   {"s", "s off"},
                                                   {"mg", "mg off"},
                                                   {"lod", "lod 0"},
                                                   {"bevel", "bevel off"},
                                                   {"c_interp", "c_interp off"},
                                                   {"d_interp", "d_interp off"},
                                                   {"usemap", "usemap off"}}};

using State = std::array<std::string_view, state_words.size()>;  ///< [word] = the line that holds; empty: none yet

bool change_state(const ObjLine& line, State& state) {
  for (std::size_t i = 0; i < state_words.size(); ++i) {
    if (state_words[i].keyword != line.keyword) continue;
    state[i] = trimmed(line.whole);
    return true;
  }
  return false;
}

bool is_face(std::string_view keyword) { return keyword == "f" || keyword == "fo"; }
bool is_line_or_point(std::string_view keyword) { return keyword == "l" || keyword == "p"; }
bool is_free_form(std::string_view keyword) {
  return keyword == "curv" || keyword == "curv2" || keyword == "surf" || keyword == "bzp" || keyword == "bsp" ||
         keyword == "cdc" || keyword == "res";
}

/// The records of one kind, and the block of each: those without a face between them.
struct Records {
  std::vector<std::string_view> lines;
  std::vector<std::size_t> blocks;
  std::vector<std::uint32_t> numbers;         ///< [old] = new
  std::vector<std::string_view> moved_lines;  ///< [new]

  void add(const ObjLine& line, std::size_t block) {
    lines.push_back(line.whole);
    blocks.push_back(block);
  }

  /// Ranks put records in order within each block.
  void arrange(const std::vector<std::uint32_t>& ranks) {
    std::vector<std::uint32_t> old(lines.size());
    std::iota(old.begin(), old.end(), 0u);
    if (!ranks.empty()) {
      std::ranges::sort(old, [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(blocks[a], ranks[a]) < std::pair(blocks[b], ranks[b]);
      });
    }
    numbers.resize(lines.size());
    for (std::uint32_t place = 0; place < old.size(); ++place) {
      numbers[old[place]] = place;
      moved_lines.push_back(lines[old[place]]);
    }
  }
};

struct FaceLine {
  ObjLine line;
  ObjCounts so_far;
  std::size_t state = 0;  ///< in the states
};

constexpr std::size_t most_growth = std::size_t{1} << 20;  // besides 4 times the file

class ObjWriting {
 public:
  ObjWriting(const MeshSource& source, Diagnostics& diagnostics)
      : reading_{source.as_read.name, source.text(), diagnostics}, body_(without_mark(source.text())) {
    behind_ = body_.substr(std::min(body_.find('\0'), body_.size()));
    body_.remove_suffix(behind_.size());
    line_end_ = body_.find("\r\n") == std::string_view::npos ? "\n" : "\r\n";
    collect();
  }

  RecordCounts counts() const {
    return {faces_.size(), positions_.lines.size(), texcoords_.lines.size(), normals_.lines.size()};
  }

  /// The text in another order. False, with an error, where OBJ can not say it.
  bool run(const MeshOrder& order) {
    renumbers_ = !order.positions.empty();
    positions_.arrange(order.positions);
    texcoords_.arrange(order.texcoords);
    normals_.arrange(order.normals);
    result = std::string(reading_.text.substr(0, reading_.text.size() - body_.size() - behind_.size()));
    result.reserve(reading_.text.size() + reading_.text.size() / 16);
    State original;
    std::size_t place = 0;
    std::string_view text = body_;
    ObjLine line;
    while (take_obj_line(text, line)) {
      if (change_state(line, original)) change_state(line, current_);
      if (is_face(line.keyword)) {
        const std::uint32_t face = order.faces[place];
        put_state(states_[faces_[face].state]);
        if (result.size() > most_growth + 4 * reading_.text.size()) return grows_too_much(line);
        if (!put_face(faces_[face], face != place)) return false;
        ++place;
      } else if (is_line_or_point(line.keyword) || is_free_form(line.keyword)) {
        put_state(original);
        if (!put_element(line)) return false;
      } else {
        put_other(line);
      }
      so_far_.count(line.keyword);
      result.append(line.whole.data() + line.whole.size(), text.data());  // the line feed, where there is one
    }
    result += behind_;
    return true;
  }

  std::string result;

 private:
  bool grows_too_much(const ObjLine& line) {
    reading_.diagnostics.error(
        reading_.at(line.keyword), "cannot-express",
        "in the new order, repeated lines of groups and materials would make the file several times as long",
        "give the output the extension .glb");
    return false;
  }

  void collect() {
    State state;
    states_.push_back(state);
    ObjCounts so_far;
    std::size_t block = 0;
    std::string_view text = body_;
    ObjLine line;
    while (take_obj_line(text, line)) {
      if (change_state(line, state)) states_.push_back(state);
      if (line.keyword == "v") positions_.add(line, block);
      if (line.keyword == "vt") texcoords_.add(line, block);
      if (line.keyword == "vn") normals_.add(line, block);
      so_far.count(line.keyword);
      if (is_face(line.keyword) || is_line_or_point(line.keyword) || is_free_form(line.keyword)) ++block;
      if (is_face(line.keyword)) faces_.push_back({line, so_far, states_.size() - 1});
    }
  }

  void put_state(const State& wanted) {
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      if (wanted[i] == current_[i]) continue;
      result += wanted[i].empty() ? state_words[i].at_first : wanted[i];
      result += line_end_;
      current_[i] = wanted[i];
    }
  }

  void put_other(const ObjLine& line) {
    const auto moved = [&](const Records& records, std::size_t place) { result += records.moved_lines[place]; };
    if (line.keyword == "v") return moved(positions_, so_far_.positions);
    if (line.keyword == "vt") return moved(texcoords_, so_far_.texcoords);
    if (line.keyword == "vn") return moved(normals_, so_far_.normals);
    result += line.whole;
  }

  /// The line with its records' new numbers, all of them counted from the first.
  Corner put_renumbered(const ObjLine& line, const ObjCounts& so_far) {
    Corner most{0, 0, 0};
    const char* done = line.whole.data();
    std::string_view rest = line.rest;
    for (std::string_view token = take_obj_token(rest); !token.empty(); token = take_obj_token(rest)) {
      Corner corner;
      read_obj_corner(token, so_far, corner);
      result.append(done, token.data());
      done = token.data() + token.size();
      const std::size_t first = token.find('/'), second = token.find('/', first + 1);
      put_number(positions_, token.substr(0, first), corner.position, most.position);
      if (first == std::string_view::npos) continue;
      result += '/';
      put_number(texcoords_, token.substr(first + 1, second - first - 1), corner.texcoord, most.texcoord);
      if (second == std::string_view::npos) continue;
      result += '/';
      put_number(normals_, token.substr(second + 1), corner.normal, most.normal);
    }
    result.append(done, line.whole.data() + line.whole.size());
    return most;
  }

  /// What names nothing stays as it is written.
  void put_number(const Records& records, std::string_view written, std::uint32_t old, std::uint32_t& most) {
    if (old >= records.numbers.size()) {
      result += written;
      return;
    }
    const std::uint32_t number = records.numbers[old] + 1;
    most = std::max(most, number);
    result += std::to_string(number);
  }

  bool put_face(const FaceLine& face, bool is_moved) {
    const Corner most = put_renumbered(face.line, face.so_far);
    if (!is_moved ||
        (most.position <= so_far_.positions && most.texcoord <= so_far_.texcoords && most.normal <= so_far_.normals)) {
      return true;
    }
    reading_.diagnostics.error(
        reading_.at(face.line.keyword), "cannot-express",
        "the face would come before a vertex that it names, which many OBJ readers do not accept",
        "give the output the extension .glb");
    return false;
  }

  bool put_element(const ObjLine& line) {
    if (!renumbers_) {
      result += line.whole;
      return true;
    }
    if (is_line_or_point(line.keyword)) {
      // The reader left it out, so nobody has looked at it yet.
      std::string_view rest = line.rest;
      for (std::string_view token = take_obj_token(rest); !token.empty(); token = take_obj_token(rest)) {
        Corner corner;
        std::string wrong = read_obj_corner(token, so_far_, corner);
        const auto missing = [](std::uint32_t record, const Records& records) {
          return record != none && record >= records.lines.size();
        };
        if (wrong.empty() && (missing(corner.position, positions_) || missing(corner.texcoord, texcoords_) ||
                              missing(corner.normal, normals_))) {
          wrong = "names a record that does not exist";
        }
        if (!wrong.empty()) return reading_.refuse(reading_.at(token), wrong);
      }
      put_renumbered(line, so_far_);
      return true;
    }
    reading_.diagnostics.error(
        reading_.at(line.keyword), "cannot-express",
        fmt::format("'{}' may refer to vertices by number, and the numbers would become wrong", line.keyword),
        "give the output the extension .glb");
    return false;
  }

  Reading reading_;
  std::string_view body_, behind_;  // behind the text: zero bytes
  std::string_view line_end_;
  Records positions_, texcoords_, normals_;
  std::vector<FaceLine> faces_;
  std::vector<State> states_;
  State current_;
  ObjCounts so_far_;
  bool renumbers_ = false;
};

}  // namespace

std::optional<std::string> reordered_obj(const Scene& scene, const MeshSource& source, Diagnostics& diagnostics) {
  ObjWriting writing(source, diagnostics);
  const auto order = order_of(scene, source, writing.counts(), diagnostics);
  if (!order) return std::nullopt;
  if (!order->moved) return std::string(source.text());
  if (!writing.run(*order)) return std::nullopt;
  return std::move(writing.result);
}

}  // namespace foredraw::mesh_files
