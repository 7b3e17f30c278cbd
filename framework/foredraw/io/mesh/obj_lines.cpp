#include <foredraw/io/mesh/private/obj.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw::mesh_files {

namespace {

/// How many characters the joint of two lines takes here; 0: there is none.
std::size_t joint_length(std::string_view text) {
  if (text.starts_with("\\\n")) return 2;
  return text.starts_with("\\\r\n") ? 3 : 0;
}

/// What places no vertex may be `absent`.
std::string read_index(std::string_view token, std::size_t so_far, bool may_be_absent, std::uint32_t& record) {
  std::int64_t number = 0;
  if (!read_integer(token, number)) return fmt::format("{} is not a whole number", shown(token));
  const bool is_too_far_back = number < 0 && static_cast<std::uint64_t>(-(number + 1)) >= so_far;
  if (may_be_absent && (number == 0 || is_too_far_back)) {
    record = absent;
    return {};
  }
  if (number == 0) return "names record 0, but OBJ counts from 1";
  if (number < 0) {
    if (is_too_far_back) return fmt::format("names record {}, but the file has {} so far", number, so_far);
    number += static_cast<std::int64_t>(so_far) + 1;
  }
  if (number >= absent) return fmt::format("names record {}, which no file can hold", number);
  record = static_cast<std::uint32_t>(number - 1);
  return {};
}

}  // namespace

std::size_t comment_in(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != line.npos && at > 0 && !is_space(line[at - 1])) at = line.find('#', at + 1);
  return at;
}

std::string obj_name(std::string_view rest) {
  for (std::size_t at = comment_in(rest); at < rest.size(); ++at) {
    const bool stands_alone =
        rest[at] == '#' && (at == 0 || is_space(rest[at - 1])) && (at + 1 == rest.size() || is_space(rest[at + 1]));
    if (stands_alone) rest = rest.substr(0, at);
  }
  return name_in(rest);
}

bool take_obj_line(std::string_view& text, ObjLine& line) {
  if (text.empty()) return false;
  const std::string_view from = text;
  std::string_view piece = take_line(text);
  while (!text.empty()) {
    if (piece.ends_with('\r')) piece.remove_suffix(1);
    if (!piece.ends_with('\\') || comment_in(piece) != piece.npos) break;  // a path may end a comment
    piece = take_line(text);
  }
  const std::size_t taken = from.size() - text.size();
  line.whole = from.substr(0, taken);
  if (line.whole.ends_with('\n')) line.whole.remove_suffix(1);
  line.rest = line.whole;
  line.keyword = take_obj_token(line.rest);
  return true;
}

std::string_view take_obj_token(std::string_view& rest) {
  std::size_t begin = 0;
  while (begin < rest.size()) {
    const std::size_t joint = joint_length(rest.substr(begin));
    if (joint == 0 && !is_space(rest[begin])) break;
    begin += std::max<std::size_t>(joint, 1);
  }
  if (begin < rest.size() && rest[begin] == '#') begin = rest.size();
  std::size_t end = begin;
  while (end < rest.size() && !is_space(rest[end]) && joint_length(rest.substr(end)) == 0) ++end;
  const std::string_view token = rest.substr(begin, end - begin);
  rest.remove_prefix(end);
  return token;
}

bool ObjCounts::count(std::string_view keyword) {
  if (keyword == "v") return ++positions > 0;
  if (keyword == "vt") return ++texcoords > 0;
  if (keyword == "vn") return ++normals > 0;
  return false;
}

std::string read_obj_corner(std::string_view token, const ObjCounts& so_far, Corner& corner) {
  corner = {};
  const std::size_t first = token.find('/');
  std::string wrong = read_index(token.substr(0, first), so_far.positions, false, corner.position);
  if (!wrong.empty() || first == std::string_view::npos) return wrong;
  const std::string_view others = token.substr(first + 1);
  const std::size_t second = others.find('/');
  if (const auto texcoord = others.substr(0, second); !texcoord.empty()) {
    wrong = read_index(texcoord, so_far.texcoords, true, corner.texcoord);
  }
  if (!wrong.empty() || second == std::string_view::npos) return wrong;
  const std::string_view normal = others.substr(second + 1);
  return normal.empty() ? wrong : read_index(normal, so_far.normals, true, corner.normal);
}

}  // namespace foredraw::mesh_files
