#include "animations.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;

/// When a clip begins and ends, in the file's ticks, and how many of them are a second. Keys that lie outside are
/// replaced by what the track has at the edge.
struct Span {
  double ends = 0;  ///< 0: with the last key
  double per_second = 25;
};

struct Keys {
  std::vector<float> times;
  std::vector<float> values;
};

/// Collects the keys of one track, and cuts them to the clip.
class Track {
 public:
  Track(Span span, std::size_t width, bool is_rotation) : span_(span), width_(width), is_rotation_(is_rotation) {}

  void put(double tick, const std::vector<double>& value) {
    if (!std::isfinite(tick)) return;
    for (const double one : value) {
      if (!std::isfinite(one)) return;
    }
    if (!keys_.empty() && tick <= keys_.back().tick) {
      if (tick == keys_.back().tick) keys_.back().value = value;
      return;  // does not go forward in time
    }
    keys_.push_back({tick, value});
    if (is_rotation_ && keys_.size() > 1) turn_short(keys_[keys_.size() - 2].value, keys_.back().value);
  }

  Keys cut() const {
    Keys made;
    for (std::size_t i = 0; i < keys_.size(); ++i) {
      const bool is_before = keys_[i].tick < 0;
      const bool is_behind = span_.ends > 0 && keys_[i].tick > span_.ends;
      if (!is_before && !is_behind) add(keys_[i].tick, keys_[i].value, made);
      if (is_before && (i + 1 == keys_.size() || keys_[i + 1].tick > 0)) add(0, value_at(0), made);
      if (is_behind && (i == 0 || keys_[i - 1].tick < span_.ends)) add(span_.ends, value_at(span_.ends), made);
    }
    return made;
  }

 private:
  struct Key {
    double tick;
    std::vector<double> value;
  };

  static void turn_short(const std::vector<double>& from, std::vector<double>& to) {
    if (from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3] >= 0) return;
    for (double& one : to) one = -one;
  }

  std::vector<double> value_at(double tick) const {
    const auto next = std::ranges::find_if(keys_, [&](const Key& key) { return key.tick >= tick; });
    if (next == keys_.begin()) return next->value;
    if (next == keys_.end()) return keys_.back().value;
    const Key& before = *std::prev(next);
    const double share = (tick - before.tick) / (next->tick - before.tick);
    std::vector<double> value(width_);
    double length = 0;
    for (std::size_t k = 0; k < width_; ++k) {
      value[k] = before.value[k] + share * (next->value[k] - before.value[k]);
      length += value[k] * value[k];
    }
    if (!is_rotation_ || !(length > 0)) return value;
    for (double& one : value) one /= std::sqrt(length);
    return value;
  }

  void add(double tick, const std::vector<double>& value, Keys& made) const {
    const auto seconds = static_cast<float>(tick / span_.per_second);
    if (!made.times.empty() && seconds <= made.times.back()) return;
    made.times.push_back(seconds);
    for (const double one : value) made.values.push_back(static_cast<float>(one));
  }

  Span span_;
  std::size_t width_;
  bool is_rotation_;
  std::vector<Key> keys_;
};

class AnimationMade {
 public:
  void add(Keys keys, const char* type, std::size_t width, std::size_t node, const char* path) {
    if (!keys.times.empty()) tracks_.push_back({std::move(keys), type, width, node, path});
  }

  /// A clip that lasts for longer than its tracks (in seconds, 0: it does not) stands still at its end.
  void finish(const std::string& name, float lasts, Glb& glb) {
    if (tracks_.empty()) return;
    float last = 0;
    for (const Made& track : tracks_) last = std::max(last, track.keys.times.back());
    if (std::isfinite(lasts) && lasts > last) {
      Made& first = tracks_.front();
      first.keys.times.push_back(lasts);
      const std::vector<float> stays(first.keys.values.end() - static_cast<std::ptrdiff_t>(first.width),
                                     first.keys.values.end());
      first.keys.values.insert(first.keys.values.end(), stays.begin(), stays.end());
    }
    Json channels = Json::array(), samplers = Json::array();
    for (const Made& track : tracks_) {
      const std::size_t input = glb.add_floats(track.keys.times, "SCALAR", 1, 0, true);
      const std::size_t output = glb.add_floats(track.keys.values, track.type, track.type_width(), 0);
      channels.push_back({{"sampler", samplers.size()}, {"target", {{"node", track.node}, {"path", track.path}}}});
      samplers.push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
    }
    glb.add("animations", {{"name", name}, {"channels", channels}, {"samplers", samplers}});
  }

 private:
  struct Made {
    Keys keys;
    const char* type;
    std::size_t width;  ///< numbers to a key
    std::size_t node;
    const char* path;
    std::size_t type_width() const { return std::string_view(type) == "SCALAR" ? 1 : width; }
  };
  std::vector<Made> tracks_;
};

void add_moves(const aiNodeAnim& from, Span span, std::size_t node, AnimationMade& made) {
  Track places(span, 3, false), turns(span, 4, true), scales(span, 3, false);
  for (unsigned i = 0; i < from.mNumPositionKeys; ++i) {
    const aiVectorKey& key = from.mPositionKeys[i];
    places.put(key.mTime, {key.mValue.x, key.mValue.y, key.mValue.z});
  }
  for (unsigned i = 0; i < from.mNumRotationKeys; ++i) {
    aiQuatKey key = from.mRotationKeys[i];
    key.mValue.Normalize();
    turns.put(key.mTime, {key.mValue.x, key.mValue.y, key.mValue.z, key.mValue.w});
  }
  for (unsigned i = 0; i < from.mNumScalingKeys; ++i) {
    const aiVectorKey& key = from.mScalingKeys[i];
    scales.put(key.mTime, {key.mValue.x, key.mValue.y, key.mValue.z});
  }
  made.add(places.cut(), "VEC3", 3, node, "translation");
  made.add(turns.cut(), "VEC4", 4, node, "rotation");
  made.add(scales.cut(), "VEC3", 3, node, "scale");
}

void add_morphs(const aiMeshMorphAnim& from, Span span, std::size_t node, const Glb& glb, AnimationMade& made) {
  const std::size_t mesh = glb.json.at("nodes").at(node).at("mesh").get<std::size_t>();
  const std::size_t targets = glb.json.at("meshes").at(mesh).at("weights").size();
  Track track(span, targets, false);
  for (unsigned i = 0; i < from.mNumKeys; ++i) {
    const aiMeshMorphKey& key = from.mKeys[i];
    std::vector<double> weights(targets, 0.0);
    for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
      if (key.mValues[k] < targets) weights[key.mValues[k]] = key.mWeights[k];
    }
    track.put(key.mTime, weights);
  }
  made.add(track.cut(), "SCALAR", targets, node, "weights");
}

}  // namespace

void add_animations(const aiScene& scene, const NodeNumbers& nodes, bool is_cut, Glb& glb, Told& told) {
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    const aiAnimation& from = *scene.mAnimations[a];
    const Span span{is_cut ? from.mDuration : 0, from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25};
    AnimationMade made;
    for (unsigned i = 0; i < from.mNumChannels; ++i) {
      const std::string name = from.mChannels[i]->mNodeName.C_Str();
      const auto node = nodes.by_name.find(name);
      if (node == nodes.by_name.end()) {
        told.left_out.push_back("an animation of '" + name + "' is left out: there is no such node");
        continue;
      }
      add_moves(*from.mChannels[i], span, node->second, made);
    }
    for (unsigned i = 0; i < from.mNumMorphMeshChannels; ++i) {
      std::string name = from.mMorphMeshChannels[i]->mName.C_Str();
      if (!nodes.morphs.contains(name)) name = name.substr(0, name.rfind('*'));  // FBX: "mesh*0"
      const auto bearers = nodes.morphs.find(name);
      if (bearers == nodes.morphs.end()) {
        told.left_out.push_back("an animation of the morph targets of '" + name +
                                "' is left out: there is no such mesh");
        continue;
      }
      for (const std::size_t node : bearers->second) {
        add_morphs(*from.mMorphMeshChannels[i], span, node, glb, made);
      }
    }
    made.finish(from.mName.C_Str(), static_cast<float>(span.ends / span.per_second), glb);
  }
}

}  // namespace foredraw::import
