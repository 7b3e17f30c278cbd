#include "animations.h"

#include <cmath>

namespace foredraw::import {

namespace {

using Json = nlohmann::json;

struct Keys {
  std::vector<float> times;
  std::vector<float> values;

  /// Keys that do not go forward in time take the place of the one before.
  void put(double time, const std::vector<float>& value) {
    const float at = static_cast<float>(time);
    if (!std::isfinite(at) || at < 0) return;
    for (const float one : value) {
      if (!std::isfinite(one)) return;
    }
    if (!times.empty() && at <= times.back()) {
      values.resize(values.size() - value.size());
      times.pop_back();
      if (!times.empty() && at <= times.back()) return put_back(value);
    }
    times.push_back(at);
    values.insert(values.end(), value.begin(), value.end());
  }

 private:
  void put_back(const std::vector<float>& value) { values.resize(times.size() * value.size()); }
};

class AnimationMade {
 public:
  explicit AnimationMade(Glb& glb) : glb_(glb) {}

  void add(const Keys& keys, const char* type, std::size_t width, std::size_t node, const char* path) {
    if (keys.times.empty()) return;
    const std::size_t input = glb_.add_floats(keys.times, "SCALAR", 1, 0, true);
    const std::size_t output = glb_.add_floats(keys.values, type, width, 0);
    channels_.push_back({{"sampler", samplers_.size()}, {"target", {{"node", node}, {"path", path}}}});
    samplers_.push_back({{"input", input}, {"output", output}, {"interpolation", "LINEAR"}});
  }

  void finish(const std::string& name) {
    if (channels_.empty()) return;
    glb_.add("animations", {{"name", name}, {"channels", channels_}, {"samplers", samplers_}});
  }

 private:
  Glb& glb_;
  Json channels_ = Json::array();
  Json samplers_ = Json::array();
};

void add_moves(const aiNodeAnim& from, double per_second, std::size_t node, AnimationMade& made) {
  Keys places, turns, scales;
  for (unsigned i = 0; i < from.mNumPositionKeys; ++i) {
    const aiVectorKey& key = from.mPositionKeys[i];
    places.put(key.mTime / per_second, {key.mValue.x, key.mValue.y, key.mValue.z});
  }
  for (unsigned i = 0; i < from.mNumRotationKeys; ++i) {
    aiQuatKey key = from.mRotationKeys[i];
    key.mValue.Normalize();
    turns.put(key.mTime / per_second, {key.mValue.x, key.mValue.y, key.mValue.z, key.mValue.w});
  }
  for (unsigned i = 0; i < from.mNumScalingKeys; ++i) {
    const aiVectorKey& key = from.mScalingKeys[i];
    scales.put(key.mTime / per_second, {key.mValue.x, key.mValue.y, key.mValue.z});
  }
  made.add(places, "VEC3", 3, node, "translation");
  made.add(turns, "VEC4", 4, node, "rotation");
  made.add(scales, "VEC3", 3, node, "scale");
}

void add_morphs(const aiMeshMorphAnim& from, double per_second, std::size_t node, Glb& glb, AnimationMade& made) {
  const Json& mesh = glb.json["meshes"][glb.json["nodes"][node]["mesh"].get<std::size_t>()];
  const std::size_t targets = mesh["weights"].size();
  Keys keys;
  for (unsigned i = 0; i < from.mNumKeys; ++i) {
    const aiMeshMorphKey& key = from.mKeys[i];
    std::vector<float> weights(targets, 0.0f);
    for (unsigned k = 0; k < key.mNumValuesAndWeights; ++k) {
      if (key.mValues[k] < targets) weights[key.mValues[k]] = static_cast<float>(key.mWeights[k]);
    }
    keys.put(key.mTime / per_second, weights);
  }
  made.add(keys, "SCALAR", 1, node, "weights");
}

}  // namespace

void add_animations(const aiScene& scene, const NodeNumbers& nodes, Glb& glb, Told& told) {
  for (unsigned a = 0; a < scene.mNumAnimations; ++a) {
    const aiAnimation& from = *scene.mAnimations[a];
    const double per_second = from.mTicksPerSecond > 0 ? from.mTicksPerSecond : 25;
    AnimationMade made(glb);
    for (unsigned i = 0; i < from.mNumChannels; ++i) {
      const std::string name = from.mChannels[i]->mNodeName.C_Str();
      const auto node = nodes.by_name.find(name);
      if (node == nodes.by_name.end()) {
        told.left_out.push_back("an animation of '" + name + "' is left out: there is no such node");
        continue;
      }
      add_moves(*from.mChannels[i], per_second, node->second, made);
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
        add_morphs(*from.mMorphMeshChannels[i], per_second, node, glb, made);
      }
    }
    made.finish(from.mName.C_Str());
  }
}

}  // namespace foredraw::import
