#include "include_rules.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <regex>
#include <span>
#include <sstream>

namespace foredraw::architecture {

const std::vector<Room>& rooms() {
  static const std::vector<Room> all =
      rooms_in(text_of(std::filesystem::path(FOREDRAW_SOURCE_DIR) / "framework/cmake/ForedrawBuild.cmake"));
  return all;
}

std::vector<Room> rooms_in(const std::string& cmake) {
  static const std::regex pattern(R"(foredraw_room\((\w+)((?: \w+)*)\))");
  std::vector<Room> rooms;
  for (std::sregex_iterator match(cmake.begin(), cmake.end(), pattern), end; match != end; ++match) {
    if ((*match)[1] == "name") continue;  // the macro itself
    std::istringstream links((*match)[2]);
    rooms.push_back({(*match)[1], {std::istream_iterator<std::string>(links), {}}});
  }
  return rooms;
}

namespace {

/// The room of a file below framework/foredraw, or of a header that is included: "io_gltf" of io/gltf/read.cpp and of
/// io/gltf/gate/private/gate.h. A folder that is no room belongs to the one that it is in.
std::string room_of(std::vector<std::string> place) {
  for (place.pop_back(); !place.empty(); place.pop_back()) {
    std::string name;
    for (const std::string& part : place) name += (name.empty() ? "" : "_") + part;
    if (place.size() == 1 || std::ranges::find(rooms(), name, &Room::name) != rooms().end()) return name;
  }
  return {};
}

/// Whether `from` links `to`, directly or not.
bool reaches(const std::string& from, const std::string& to) {
  for (const Room& room : rooms()) {
    if (room.name != from) continue;
    return std::ranges::any_of(room.links, [&](const std::string& link) { return link == to || reaches(link, to); });
  }
  return false;
}

constexpr std::array<std::string_view, 29> c_headers = {
    "assert.h",  "complex.h", "ctype.h",  "errno.h",  "fenv.h",   "float.h",       "inttypes.h", "iso646.h",
    "limits.h",  "locale.h",  "math.h",   "setjmp.h", "signal.h", "stdalign.h",    "stdarg.h",   "stdatomic.h",
    "stdbool.h", "stddef.h",  "stdint.h", "stdio.h",  "stdlib.h", "stdnoreturn.h", "string.h",   "tgmath.h",
    "threads.h", "time.h",    "uchar.h",  "wchar.h",  "wctype.h"};

constexpr std::array<std::string_view, 14> posix_headers = {
    "unistd.h", "fcntl.h",   "dirent.h", "dlfcn.h", "fnmatch.h", "ftw.h",     "glob.h",
    "poll.h",   "pthread.h", "pwd.h",    "sched.h", "spawn.h",   "termios.h", "syslog.h"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Packages that a technique is made of. All its plain files but the header that bears its name may include them, and
/// its CMakeLists.txt asks for them.
constexpr std::array<std::string_view, 4> packages_of_techniques = {"embree3/", "CGAL/", "OpenMesh/", "hwy/"};

bool begins_with_one_of(std::span<const std::string_view> beginnings, std::string_view name) {
  return std::any_of(beginnings.begin(), beginnings.end(), [&](std::string_view b) { return name.starts_with(b); });
}

/// Rooms of families that a technique may be made of, besides frames and what frames links.
constexpr std::array<std::string_view, 5> rooms_of_families = {"collapses", "crowds", "instances", "packing", "shells"};

struct Include {
  int line = 0;
  std::string target;
  bool quoted = false;

  bool is_c() const { return is_one_of(c_headers, target); }
  bool is_cpp_standard() const { return !quoted && target.find_first_of("./") == std::string::npos; }
  bool is_standard() const { return is_c() || is_cpp_standard(); }
  bool is_posix() const { return is_one_of(posix_headers, target) || target.starts_with("sys/"); }
  bool is_glm() const { return target.starts_with("glm/"); }
  bool is_draco() const { return target.starts_with("draco/"); }
  bool is_vulkan() const { return target.starts_with("vulkan/"); }
  bool is_private() const { return target.find("/private/") != std::string::npos; }
  bool is_own_folder() const { return quoted && target.find("..") == std::string::npos; }
  std::string room() const {
    const std::vector<std::string> parts = parts_of(target);
    return parts.front() == "foredraw" && parts.size() > 2 ? room_of({parts.begin() + 1, parts.end()}) : std::string();
  }
};

std::vector<Include> includes_of(const std::string& text) {
  static const std::regex pattern(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  std::vector<Include> includes;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    std::smatch match;
    if (std::regex_match(line, match, pattern)) includes.push_back({number, match[2], match[1] == "\""});
  }
  return includes;
}

/// Why a file of a room may not include this; empty: it may.
std::string refused_in_framework(const std::string& room, bool is_public_header, const Include& include) {
  const std::string other = include.room();
  if (room == "runtime") {
    return include.is_c() || other == room ? "" : "runtime/ is C for frame loops: only C's own headers, and its own";
  }
  if (other == room || other == "runtime") return "";
  if (!other.empty() && !reaches(room, other)) {
    return "framework/cmake/ForedrawBuild.cmake does not let " + room + " link " + other;
  }
  if (is_public_header && other.empty() && !include.is_standard() && !include.is_glm() && !include.is_vulkan()) {
    return "headers of the framework include the standard library, GLM and the framework; move it into the .cpp";
  }
  return "";
}

/// Whether the CMakeLists.txt of a plugin's folder asks for the room.
bool links(std::vector<std::string> place, const std::string& room) {
  std::filesystem::path build = FOREDRAW_SOURCE_DIR;
  place.back() = "CMakeLists.txt";
  for (const std::string& part : place) build /= part;
  return std::regex_search(text_of(build), std::regex("foredraw::" + room + "\\b"));
}

/// The same for a file of a plugin or evaluator.
std::string refused_in_plugin(const std::vector<std::string>& place, const Include& include) {
  const std::string& file = place.back();
  const bool is_face = place.size() > 1 && file == place[place.size() - 2] + ".h";
  const std::string room = include.room();
  if (room == "runtime") return "";
  if (room == "c") return file.ends_with("_c.cpp") ? "" : "C is spoken in the folder's _c.cpp alone";
  if (room == "gpu" || room == "frames_gpu") {
    if (!links(place, room)) return "the folder's CMakeLists.txt does not link foredraw::" + room;
    if (is_face && include.target != "foredraw/gpu/choice.h") return "who calls the function needs no header of Vulkan";
    return "";
  }
  if (room.empty()) {
    if (include.is_standard() || include.is_glm() || include.is_own_folder()) return "";
    if (!is_face && begins_with_one_of(packages_of_techniques, include.target)) return "";
    if (include.quoted || include.target.starts_with("plugins/") || include.target.starts_with("evaluators/")) {
      return "plugins and evaluators include only their own folder; what two need goes to a room of the framework";
    }
  }
  if (!room.empty() && room != "measuring" && !reaches("measuring", room)) {
    return "plugins and evaluators include the framework up to measuring only";
  }
  const bool is_plain = file.find("_plugin.") == std::string::npos && file.find("_product") == std::string::npos;
  const bool is_plain_room = room == "frames" || is_one_of(rooms_of_families, room) || reaches("frames", room);
  if (is_plain && !is_plain_room) {
    return "a technique's plain files include the standard library, GLM, their own folder, the framework up to frames "
           "and rooms of families, and behind its header what they are made of; what dresses it goes to its "
           "_plugin.cpp";
  }
  return "";
}

std::string refused(const std::vector<std::string>& place, const Include& include) {
  const bool in_framework = place.size() > 3 && place[0] == "framework" && place[1] == "foredraw";
  const std::string room = in_framework ? room_of({place.begin() + 2, place.end()}) : std::string();
  if (include.is_posix() && room != "platform") return "POSIX calls live in platform/ alone";
  if (include.is_draco() && room != "io_gltf") return "Draco is used by io/gltf/ alone";
  if (include.is_vulkan() && room != "gpu") return "Vulkan is called through gpu/ alone";
  const bool is_tree = include.target == "foredraw/io/text/private/json_tree.h";
  if (include.is_private() && !(in_framework && place[2] == parts_of(include.target).at(1)) &&
      !(is_tree && room.starts_with("report"))) {
    return "private/ is for its own room, and in io for the rooms of io; the tree of JSON is for reports, too";
  }
  if (in_framework) {
    const bool is_public_header = place.back().ends_with(".h") && place[place.size() - 2] != "private";
    return refused_in_framework(room, is_public_header, include);
  }
  if (place[0] == "plugins" || place[0] == "evaluators") return refused_in_plugin(place, include);
  return "";
}

}  // namespace

Breaches include_breaches(const std::string& path, const std::string& text) {
  Breaches breaches;
  const std::vector<std::string> place = parts_of(path);
  if (!is_cpp(path) || place[0] == "tests" || place[0] == "benchmarks" || place[0] == "docs") return breaches;
  for (const Include& include : includes_of(text)) {
    const std::string reason = refused(place, include);
    if (reason.empty()) continue;
    breaches.push_back(path + ':' + std::to_string(include.line) + ": includes " + include.target + ", but " + reason);
  }
  return breaches;
}

Breaches host_breaches(const std::string& path, const std::string& text) {
  Breaches breaches;
  if (!is_cpp(path) || !(path.starts_with("hosts/") || path.starts_with("framework/foredraw/c/"))) return breaches;
  for (const char* call : {"foredraw::plan(", "foredraw::optimize(", "foredraw::measure(", "contest(", "encode_scene(",
                           "encode_level(", "encode_gltf(", "encode_sprites(", "GltfOutput"}) {
    if (text.find(call) == std::string::npos) continue;
    breaches.push_back(path + ": has " + call + ", but hosts plan, run and encode by the room job");
  }
  return breaches;
}

}  // namespace foredraw::architecture
