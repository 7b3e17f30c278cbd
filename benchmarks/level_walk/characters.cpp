#include "characters.h"

#include "clip.h"
#include "gltf_copier.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace foredraw::bench {

namespace {

using Json = GltfDocument::Json;

constexpr std::size_t keys_per_second = 15;

/// The times of a walk, once in a document.
std::size_t walk_times(GltfDocument& to, double seconds) {
  std::vector<float> times;
  const auto count = static_cast<std::size_t>(seconds * keys_per_second);
  for (std::size_t i = 0; i <= count; ++i) times.push_back(static_cast<float>(i) / keys_per_second);
  return to.add_bounded(times, "SCALAR");
}

}  // namespace

class Character::Impl {
 public:
  Impl(GltfDocument& to, Kind kind)
      : to_(to),
        kind_(std::move(kind)),
        file_(GltfDocument::opened(kind_.file)),
        copier_(to, file_, kind_.file.parent_path()) {
    for (const std::string& name : kind_.clips) clips_.emplace_back(file_, name);
    shown_.resize(file_.json.at("nodes").size());
    const Json& scene = file_.json.at("scenes").at(file_.json.value("scene", std::size_t{0}));
    for (const Json& root : scene.at("nodes")) roots_.push_back(root);
    for (const std::size_t root : roots_) show(root);
    std::size_t count = 0;
    for (std::size_t number = 0; number < shown_.size(); ++number) {
      slots_.push_back(count);
      if (is_node(number)) ++count;
    }
  }

  std::size_t clips() const { return clips_.size(); }

  std::vector<std::size_t> place(const glm::dvec3& at, const glm::quat& turn, std::size_t clip, std::size_t phase) {
    const std::size_t above = to_.add("nodes", {{"name", kind_.file.stem().string()}});
    std::vector<std::size_t> roots = {above};
    add_nodes(above, roots);
    Json& node = to_.json["nodes"][above];
    node["translation"] = {round(at.x), round(at.y), round(at.z)};
    node["rotation"] = {turn.x, turn.y, turn.z, turn.w};
    if (kind_.size != 1) node["scale"] = {kind_.size, kind_.size, kind_.size};
    animate(above + 1, clip, phase);
    return roots;
  }

 private:
  static double round(double value) { return std::floor(value * 1024 + 0.5) / 1024; }

  void show(std::size_t number) {
    const Json& node = file_.json["nodes"].at(number);
    if (std::ranges::count(kind_.hidden, node.value("name", std::string())) > 0) return;
    shown_[number] = true;
    if (!node.contains("children")) return;
    for (const Json& child : node["children"]) show(child);
  }

  /// The nodes of the file, in its sequence, behind the one above them; a skinned mesh is drawn by a root, as it stands
  /// where its joints are and not where its node is.
  void add_nodes(std::size_t above, std::vector<std::size_t>& roots) {
    const std::size_t first = above + 1;
    std::map<std::size_t, std::size_t> skins;
    std::vector<Json> skinned;
    Json below = Json::array();
    for (const std::size_t root : roots_) {
      if (is_node(root)) below.push_back(first + slots_[root]);
    }
    to_.json["nodes"][above]["children"] = std::move(below);
    for (std::size_t number = 0; number < shown_.size(); ++number) {
      const Json& from = file_.json["nodes"][number];
      Json node;
      for (const char* key : {"name", "translation", "rotation", "scale", "matrix"}) {
        if (from.contains(key)) node[key] = from[key];
      }
      if (!shown_[number]) continue;
      if (from.contains("mesh")) {
        const std::size_t mesh = copier_.mesh(from["mesh"], kind_.file.stem().string());
        if (from.contains("skin")) {
          const auto [known, is_new] = skins.try_emplace(from["skin"].get<std::size_t>(), 0);
          if (is_new) known->second = add_skin(known->first, first);
          skinned.push_back(
              {{"name", node.value("name", std::string("skin"))}, {"mesh", mesh}, {"skin", known->second}});
        } else {
          node["mesh"] = mesh;
        }
      }
      if (from.contains("children")) {
        Json children = Json::array();
        for (const Json& child : from["children"]) {
          const std::size_t below_it = child;
          if (is_node(below_it)) children.push_back(first + slots_[below_it]);
        }
        if (!children.empty()) node["children"] = std::move(children);
      }
      if (is_node(number)) to_.add("nodes", std::move(node));
    }
    for (Json& node : skinned) roots.push_back(to_.add("nodes", std::move(node)));
  }

  /// Whether each of it has a node for this one of the file's.
  bool is_node(std::size_t number) const { return shown_[number] && !file_.json["nodes"][number].contains("skin"); }

  std::size_t add_skin(std::size_t number, std::size_t first) {
    const Json& from = file_.json.at("skins").at(number);
    Json joints = Json::array();
    for (const Json& joint : from.at("joints")) joints.push_back(first + slots_[joint.get<std::size_t>()]);
    return to_.add("skins",
                   {{"inverseBindMatrices", copier_.accessor(from.at("inverseBindMatrices"))}, {"joints", joints}});
  }

  void animate(std::size_t first, std::size_t clip, std::size_t phase) {
    Json& animation = to_.json["animations"].back();
    const auto [known, is_new] = samplers_.try_emplace({clip, phase}, animation["samplers"].size());
    if (is_new) add_samplers(animation, clips_.at(clip), phase);
    std::size_t sampler = known->second;
    for (const Clip::Track& track : clips_.at(clip).tracks()) {
      if (!is_node(track.node)) continue;
      animation["channels"].push_back(
          {{"sampler", sampler++}, {"target", {{"node", first + slots_[track.node]}, {"path", track.path}}}});
    }
  }

  void add_samplers(Json& animation, const Clip& clip, std::size_t phase) {
    const Json& walk = animation["samplers"][0]["input"];
    const double seconds = to_.json["accessors"][walk.get<std::size_t>()]["max"][0];
    const std::size_t input = known_times(seconds);
    const auto count = static_cast<std::size_t>(seconds * keys_per_second);
    for (const Clip::Track& track : clip.tracks()) {
      if (!is_node(track.node)) continue;
      std::vector<float> values;
      for (std::size_t i = 0; i <= (track.moves ? count : 0); ++i) {
        const double time = static_cast<double>(i) / keys_per_second;
        const double turns = time / clip.seconds() + static_cast<double>(phase) / phases;
        Clip::add_value(track, (turns - std::floor(turns)) * clip.seconds(), values);
      }
      const std::size_t output = to_.add_values<float>(values, track.width == 4 ? "VEC4" : "VEC3");
      animation["samplers"].push_back({{"input", track.moves ? input : still_}, {"output", output}});
    }
  }

  /// All of this kind share the times of their keys.
  std::size_t known_times(double seconds) {
    if (!times_) {
      times_ = walk_times(to_, seconds);
      still_ = to_.add_bounded(std::vector<float>{0}, "SCALAR");
    }
    return *times_;
  }

  GltfDocument& to_;
  const Kind kind_;
  const GltfDocument::Opened file_;
  GltfCopier copier_;
  std::vector<Clip> clips_;
  std::vector<std::size_t> roots_;
  std::vector<bool> shown_;
  std::vector<std::size_t> slots_;  ///< [node of the file] how many of those before it each of it has
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> samplers_;  ///< clip and phase: the first
  std::optional<std::size_t> times_;
  std::size_t still_ = 0;
};

Character::Character(GltfDocument& to, Kind kind) : impl_(std::make_unique<Impl>(to, std::move(kind))) {}
Character::~Character() = default;
Character::Character(Character&&) noexcept = default;

std::size_t Character::clips() const { return impl_->clips(); }

std::vector<std::size_t> Character::place(const glm::dvec3& at, const glm::quat& turn, std::size_t clip,
                                          std::size_t phase) {
  return impl_->place(at, turn, clip, phase);
}

}  // namespace foredraw::bench
