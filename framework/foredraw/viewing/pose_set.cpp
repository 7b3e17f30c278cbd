#include <foredraw/viewing/pose_set.h>

#include <foredraw/base/diagnostics.h>
#include <foredraw/base/name_pattern.h>
#include <foredraw/base/whole_number.h>
#include <foredraw/viewing/animation.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <locale>
#include <map>
#include <numeric>
#include <sstream>
#include <stdexcept>

namespace foredraw {

namespace {

constexpr std::size_t most_poses = 100000;

/// Rising, each once; nothing where the text is no list of seconds.
std::optional<std::vector<double>> times_in(const std::string& text) {
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> times;
  while (!(words >> std::ws).eof()) {
    double time = 0;
    if (!(words >> time) || !(time >= 0) || !std::isfinite(time)) return std::nullopt;
    times.push_back(time);
  }
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// A clip with keys. It lasts from its first key to its last one.
struct Clip {
  AnimationId id = 0;
  std::vector<double> keys;  ///< seconds, rising: those of all channels

  double seconds() const { return keys.back() - keys.front(); }
};

std::vector<double> keys_of(const Animation& animation) {
  std::vector<double> keys;
  for (const AnimationChannel& channel : animation.channels) {
    if (!has_keys(channel)) continue;
    for (const float time : channel.times.view()) {
      if (std::isfinite(time)) keys.push_back(time);
    }
  }
  std::ranges::sort(keys);
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  return keys;
}

/// Those with keys whose names match.
std::vector<Clip> clips_of(const Scene& scene, const std::string& pattern) {
  const std::vector<std::string> names = clip_names(scene);
  std::vector<Clip> clips;
  for (AnimationId id = 0; id < names.size(); ++id) {
    if (!matches(pattern, names[id]) && !matches(pattern, scene.animations[id].name)) continue;
    Clip clip{id, keys_of(scene.animations[id])};
    if (!clip.keys.empty()) clips.push_back(std::move(clip));
  }
  return clips;
}

class PoseMaker {
 public:
  explicit PoseMaker(std::vector<Clip> clips) : clips_(std::move(clips)) {}

  void at_keys() {
    for (const Clip& clip : clips_) {
      for (const double time : clip.keys) add(clip, time);
    }
  }

  void at_rate(double rate) {
    for (const Clip& clip : clips_) {
      // The last frame may miss the clip's end by what a float of seconds leaves open.
      const double frames = std::floor(clip.seconds() * rate + 1e-3);
      if (!(frames < static_cast<double>(most_poses))) refuse();
      for (double frame = 0; frame <= frames; ++frame) add(clip, clip.keys.front() + frame / rate);
    }
  }

  void at_times(const std::vector<double>& times) {
    for (const Clip& clip : clips_) {
      for (const double time : times) {
        if (time >= clip.keys.front() && time <= clip.keys.back()) add(clip, time);
      }
    }
  }

  /// As many in each clip, the longest ones first to have one more. They stand at `at` of equal parts of the clip; a
  /// clip that stands still has one, which weighs as many.
  void spread(std::size_t count, double at = 0.5) {
    at_ = at;
    const std::size_t clips = clips_.size();
    if (clips == 0) return;
    if (count < clips) {
      for (std::size_t i = 0; i < count; ++i) add_spread(clips_[(2 * i + 1) * clips / (2 * count)], 1);
      return;
    }
    std::vector<std::size_t> by_length(clips);
    std::iota(by_length.begin(), by_length.end(), std::size_t{0});
    std::ranges::stable_sort(by_length, std::greater(), [&](std::size_t clip) { return clips_[clip].seconds(); });
    std::vector<std::size_t> shares(clips, count / clips);
    for (std::size_t i = 0; i < count % clips; ++i) ++shares[by_length[i]];
    for (std::size_t clip = 0; clip < clips; ++clip) add_spread(clips_[clip], shares[clip]);
  }

  Poses made() && { return poses_.empty() ? rest_pose : Poses{std::move(poses_)}; }

 private:
  void add_spread(const Clip& clip, std::size_t count) {
    if (clip.seconds() == 0) return add(clip, clip.keys.front(), static_cast<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
      add(clip, clip.keys.front() + clip.seconds() * (static_cast<double>(i) + at_) / static_cast<double>(count));
    }
  }

  void add(const Clip& clip, double time, double weight = 1) {
    if (poses_.size() == most_poses) refuse();
    poses_.push_back({clip.id, time, weight});
  }

  [[noreturn]] static void refuse() {
    throw std::invalid_argument("the clips have more than " + std::to_string(most_poses) +
                                " such poses; ask for fewer, such as poses = 64");
  }

  std::vector<Clip> clips_;
  std::vector<Pose> poses_;
  double at_ = 0.5;  ///< of its part of the clip
};

bool is_at_rest(const PoseSet& set) { return set.poses == "bind" && !set.rate && set.moments.empty(); }

Poses made_of(const Scene& scene, const PoseSet& set) {
  if (is_at_rest(set)) return rest_pose;
  PoseMaker maker(clips_of(scene, set.clips));
  const bool is_auto = set.poses == "auto" && !set.rate && set.moments.empty();
  if (is_auto) {
    // Evaluators look at the middles of as many parts: an order is judged by poses that it was not made for.
    maker.spread(16, 0.25);
  } else if (set.rate) {
    maker.at_rate(*set.rate);
  } else if (!set.moments.empty()) {
    maker.at_times(*times_in(set.moments));
  } else if (const auto count = whole_number(set.poses)) {
    maker.spread(static_cast<std::size_t>(*count));
  } else {
    maker.at_keys();
  }
  Poses poses = std::move(maker).made();
  poses.share_views = is_auto && poses.poses.size() > 1;
  return poses;
}

std::optional<std::string> mistake_in_word(const std::string& word) {
  static const std::vector<std::string> words = {"all", "auto", "bind"};
  if (std::ranges::find(words, word) != words.end()) return std::nullopt;
  if (const auto number = whole_number(word)) {
    if (*number >= 1 && *number <= static_cast<std::int64_t>(most_poses)) return std::nullopt;
    return "poses is " + word + ", but must be 1 to " + std::to_string(most_poses);
  }
  const std::string_view meant = nearest(word, words);
  return "there is no pose set '" + word + "'; " +
         (meant.empty() ? "expected auto, all, bind or a number" : "did you mean '" + std::string(meant) + "'?");
}

}  // namespace

std::optional<std::string> mistake_in(const PoseSet& set) {
  if (const auto mistake = mistake_in_word(set.poses)) return mistake;
  if (set.rate && !(*set.rate > 0 && std::isfinite(*set.rate))) {
    return "rate is " + std::to_string(*set.rate) + ", but must be above 0 poses a second";
  }
  if (!times_in(set.moments)) return "moments is '" + set.moments + "', but must be seconds such as '0 0.5 2'";
  if (set.rate && !set.moments.empty()) return "rate and moments both choose the poses; leave one of them out";
  if (set.clips.empty()) return "clips is empty; leave it out, or name some, with * and ?";
  return std::nullopt;
}

Poses make_poses(const Scene& scene, const PoseSet& set) {
  if (const auto mistake = mistake_in(set)) throw std::invalid_argument(*mistake);
  return made_of(scene, set);
}

std::optional<std::string> why_at_rest(const Scene& scene, const PoseSet& set) {
  if (is_at_rest(set) || clips_of(scene, "*").empty() || make_poses(scene, set) != rest_pose) return std::nullopt;
  if (!clips_of(scene, set.clips).empty()) return "no clip lasts for any of the moments " + set.moments;
  const std::vector<std::string> all_names = clip_names(scene);
  std::vector<std::string> names;
  for (const Clip& clip : clips_of(scene, "*")) names.push_back(all_names[clip.id]);
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  const std::string_view meant = nearest(set.clips, names);
  return "no clip with keys is called '" + set.clips + "'; " +
         (meant.empty() ? "there are " + list : "did you mean '" + std::string(meant) + "'?");
}

std::vector<std::string> clip_names(const Scene& scene) {
  std::map<std::string, int> uses;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < scene.animations.size(); ++i) {
    const std::string& given = scene.animations[i].name;
    const std::string name = given.empty() ? "animation" + std::to_string(i) : given;
    const int use = ++uses[name];
    names.push_back(use == 1 ? name : name + '#' + std::to_string(use));
  }
  return names;
}

std::string pose_name(const Pose& pose, const std::vector<std::string>& clip_names) {
  if (!pose.clip) return "rest";
  std::array<char, 32> time{};
  const auto end = std::to_chars(time.data(), time.data() + time.size(), pose.time, std::chars_format::general, 6).ptr;
  return clip_names[*pose.clip] + '@' + std::string(time.data(), end);
}

}  // namespace foredraw
