#include <foredraw/frames/camera_path.h>

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/random.h>
#include <foredraw/frames/frame_moment.h>
#include <foredraw/scene/turn.h>

#include <glm/common.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <array>
#include <fstream>
#include <limits>
#include <locale>
#include <sstream>

namespace foredraw {

namespace {

constexpr std::size_t most_keys = 100000;

double half_height_of(double radians) {
  const Turn half = turn_by(radians / 2);
  return half.sine / half.cosine;
}

/// The sphere around everything that is shown.
BoundingSphere around_all(const FrameMoment& moment) {
  glm::dvec3 low(std::numeric_limits<double>::infinity()), high(-low);
  for (const auto& [sphere, half_box] : moment.bounds) {
    const glm::dvec3 reach = glm::abs(half_box[0]) + glm::abs(half_box[1]) + glm::abs(half_box[2]);
    low = glm::min(low, sphere.centre - reach);
    high = glm::max(high, sphere.centre + reach);
  }
  if (!(low.x <= high.x)) return {glm::dvec3(0), 1};
  return {(low + high) / 2.0, glm::length(high - low) / 2};
}

/// Through q and r, with the tangents that their neighbours give (Catmull, Rom 1974).
glm::dvec3 curve(const glm::dvec3& p, const glm::dvec3& q, const glm::dvec3& r, const glm::dvec3& s, double t) {
  return 0.5 * (2.0 * q + (r - p) * t + (2.0 * p - 5.0 * q + 4.0 * r - s) * (t * t) +
                (3.0 * q - p - 3.0 * r + s) * (t * t * t));
}

void set_picture(FrameCamera& camera, double radians, double size_of_scene) {
  camera.half_height = half_height_of(radians);
  camera.near = size_of_scene * 1e-4;
}

CameraPath path_around(const BoundingSphere& all, double seconds, const FrameSet& set) {
  constexpr std::size_t places = 8;
  std::array<glm::dvec3, places> eyes{};
  Random random(static_cast<std::uint64_t>(set.seed));
  const double first = random.unit();
  for (std::size_t i = 0; i < places; ++i) {
    const Turn turn =
        turn_by(2 * glm::pi<double>() * (first + (static_cast<double>(i) + 0.5 * random.unit()) / places));
    const double away = 0.6 + (i % 2 == 0 ? 0.5 : 1.6) * random.unit(), above = 0.1 + 0.5 * random.unit();
    eyes[i] = all.centre + all.radius * glm::dvec3(away * turn.sine, above * away, away * turn.cosine);
  }
  CameraPath path;
  for (int frame = 0; frame < set.frames; ++frame) {
    const double share = static_cast<double>(frame) / set.frames, at = share * places;
    const auto i = static_cast<std::size_t>(at);
    const glm::dvec3 eye = curve(eyes[(i + places - 1) % places], eyes[i], eyes[(i + 1) % places],
                                 eyes[(i + 2) % places], at - static_cast<double>(i));
    path.push_back({seconds * share, looking_at(eye, all.centre)});
  }
  return path;
}

CameraPath path_by_keys(const std::vector<CameraKey>& keys, const FrameSet& set) {
  CameraPath path;
  const double seconds = keys.back().seconds - keys.front().seconds;
  std::size_t next = 0;
  for (int frame = 0; frame < set.frames; ++frame) {
    const double at = keys.front().seconds + (set.frames < 2 ? 0 : seconds * frame / (set.frames - 1));
    while (next < keys.size() && keys[next].seconds <= at) ++next;
    const CameraKey &a = keys[next == 0 ? 0 : next - 1], &b = keys[std::min(next, keys.size() - 1)];
    const double part = b.seconds > a.seconds ? (at - a.seconds) / (b.seconds - a.seconds) : 0;
    path.push_back({at, looking_at(a.eye + part * (b.eye - a.eye), a.target + part * (b.target - a.target))});
  }
  return path;
}

/// Whether an animation moves the node, or one above it.
std::vector<bool> moved_nodes_of(const Scene& scene) {
  std::vector<bool> is_moved(scene.nodes.size());
  std::vector<NodeId> open;
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (channel.node < scene.nodes.size() && has_keys(channel)) open.push_back(channel.node);
    }
  }
  while (!open.empty()) {
    const NodeId node = open.back();
    open.pop_back();
    if (is_moved[node]) continue;
    is_moved[node] = true;
    open.insert(open.end(), scene.nodes[node].children.begin(), scene.nodes[node].children.end());
  }
  return is_moved;
}

std::optional<NodeId> moved_camera(const Scene& scene) {
  const std::vector<bool> is_moved = moved_nodes_of(scene);
  for (NodeId i = 0; i < scene.nodes.size(); ++i) {
    if (scene.nodes[i].camera_angle && is_moved[i]) return i;
  }
  return std::nullopt;
}

/// The time of the last key of all clips.
double end_of_clips(const Scene& scene) {
  float last = 0;
  for (const Animation& animation : scene.animations) {
    for (const AnimationChannel& channel : animation.channels) {
      if (has_keys(channel)) last = std::max(last, channel.times.view().back());
    }
  }
  return static_cast<double>(last);
}

CameraPath path_of_camera(const Scene& scene, NodeId node, const FrameSet& set) {
  CameraPath path;
  const double seconds = end_of_clips(scene);
  for (int frame = 0; frame < set.frames; ++frame) {
    const double at = set.frames < 2 ? 0 : seconds * frame / (set.frames - 1);
    const glm::dmat4 world(posed_nodes_of_all_clips(scene, at).world[node]);
    // A camera looks along -Z of its node. Whatever else the node does to it is left out.
    path.push_back({at, looking_at(glm::dvec3(world[3]), glm::dvec3(world[3]) - glm::dvec3(world[2]))});
  }
  return path;
}

}  // namespace

bool is_camera_file(std::string_view path) { return path.find_first_of("./") != std::string_view::npos; }

std::optional<std::string> mistake_in(const FrameSet& set) {
  static const std::vector<std::string> words = {"auto", "around", "camera"};
  if (is_camera_file(set.path) || std::ranges::find(words, set.path) != words.end()) return std::nullopt;
  const std::string_view meant = nearest(set.path, words);
  return "there is no path '" + set.path + "'; " +
         (meant.empty() ? "expected auto, around, camera or a file (with a dot or a slash in its path)"
                        : "did you mean '" + std::string(meant) + "'?");
}

std::variant<std::vector<CameraKey>, std::string> read_camera_keys(const std::string& path) {
  std::ifstream file(path);
  if (!file) return path + ": there is no such file, or it cannot be read; expected a list of camera keys";
  std::vector<CameraKey> keys;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    line.resize(std::min(line.find('#'), line.size()));
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string place = path + ":" + std::to_string(number) + ": ";
    std::istringstream words(line);
    words.imbue(std::locale::classic());
    CameraKey key;
    words >> key.seconds >> key.eye.x >> key.eye.y >> key.eye.z >> key.target.x >> key.target.y >> key.target.z;
    if (words.fail() || !(words >> std::ws).eof()) {
      constexpr std::size_t most = 80;
      return place + "expected seven numbers, 'seconds eye-x eye-y eye-z target-x target-y target-z', but found '" +
             line.substr(0, most) + (line.size() > most ? "...'" : "'");
    }
    const glm::dvec3 ahead = key.target - key.eye;
    if (!std::isfinite(key.seconds) || !std::isfinite(glm::dot(ahead, ahead)) || !(glm::dot(ahead, ahead) > 0)) {
      return place + "all numbers must be finite, and the target must be somewhere else than the eye";
    }
    if (!keys.empty() && !(key.seconds > keys.back().seconds)) return place + "times must rise from key to key";
    if (keys.size() == most_keys) return place + "a path has at most " + std::to_string(most_keys) + " keys";
    keys.push_back(key);
  }
  if (keys.empty()) return path + ": it has no keys; expected lines such as '0  0 2 5  0 0 0'";
  return keys;
}

std::variant<CameraPath, std::string> camera_path(const FrameScene& frames, const FrameSet& set) {
  if (const auto mistake = mistake_in(set)) return *mistake;
  const Scene& scene = frames.scene();
  const BoundingSphere all = around_all(frame_moment(frames, 0));
  double radians = glm::radians(set.angle);
  CameraPath path;
  if (is_camera_file(set.path)) {
    const auto keys = read_camera_keys(set.path);
    if (const std::string* why = std::get_if<std::string>(&keys)) return *why;
    path = path_by_keys(std::get<std::vector<CameraKey>>(keys), set);
  } else if (const auto camera = moved_camera(scene); camera.has_value() && set.path != "around") {
    radians = static_cast<double>(*scene.nodes[*camera].camera_angle);
    path = path_of_camera(scene, *camera, set);
  } else if (set.path == "camera") {
    return std::string("the scene has no perspective camera that an animation moves; expected one, or path = around");
  } else {
    path = path_around(all, end_of_clips(scene), set);
  }
  for (PathFrame& frame : path) set_picture(frame.camera, radians, all.radius);
  return path;
}

}  // namespace foredraw
