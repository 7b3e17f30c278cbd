// Checks of skins, and of the joints that vertices name.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <optional>
#include <set>

namespace foredraw::gltf {

namespace {

/// Joint numbers are followed by whoever poses the vertices, so they are held against the skin's joints. Each mesh and
/// each pair of accessors is looked through once, however many nodes draw it.
class JointCheck {
 public:
  explicit JointCheck(Gate& gate) : gate_(gate) {}

  void check(std::size_t mesh, std::size_t joints, const std::string& place) {
    const auto [known, is_new] = meshes_.try_emplace(mesh);
    if (is_new) known->second = greatest_in_mesh(mesh);
    const Greatest& greatest = known->second;
    if (greatest.where.empty() || greatest.in.any < joints) return;
    std::string message =
        fmt::format("{} names joint {}, but the skin has {} joints", greatest.where, greatest.in.any, joints);
    if (greatest.in.weighted < static_cast<std::int64_t>(joints)) {
      gate_.fault("unused-joint", place, std::move(message));
    } else {
      gate_.error(place, "joint-range", std::move(message));
    }
  }

 private:
  struct Joints {
    std::uint32_t any = 0;
    std::int64_t weighted = -1;  ///< of those with a weight; -1: none has one
  };
  struct Greatest {
    Joints in;
    std::string where;  ///< of the greatest one; empty: there are none
  };

  Greatest greatest_in_mesh(std::size_t mesh) {
    Greatest greatest;
    const Json& primitives = gate_.all("meshes")[mesh]["primitives"];
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const Json& attributes = primitives[p]["attributes"];
      for (const auto& [semantic, number] : attributes.items()) {
        if (semantic.compare(0, 7, "JOINTS_") != 0) continue;
        const auto weights = attributes.find("WEIGHTS_" + semantic.substr(7));
        const Joints found = greatest_in_accessor(
            number.get<std::size_t>(),
            weights == attributes.end() ? std::nullopt : std::optional(weights->get<std::size_t>()));
        greatest.in.weighted = std::max(greatest.in.weighted, found.weighted);
        if (!greatest.where.empty() && found.any <= greatest.in.any) continue;
        greatest.in.any = found.any;
        greatest.where = fmt::format("meshes[{}].primitives[{}].attributes.{}", mesh, p, semantic);
      }
    }
    return greatest;
  }

  /// Without weights a joint moves nothing.
  Joints greatest_in_accessor(std::size_t number, std::optional<std::size_t> weights_number) {
    const auto [known, is_new] = accessors_.try_emplace({number, weights_number});
    if (!is_new) return known->second;
    const Accessor& fours = *gate_.accessor(number);
    const std::vector<std::byte> bytes = elements(gate_.document(), fours);
    std::vector<float> weights;
    if (weights_number) weights = decoded_elements(gate_.document(), *gate_.accessor(weights_number));
    const std::size_t width = bytes_of(fours.format.component);
    Joints& greatest = known->second;
    for (std::size_t i = 0; i * width < bytes.size(); ++i) {
      std::uint32_t joint = 0;
      std::memcpy(&joint, bytes.data() + i * width, width);
      greatest.any = std::max(greatest.any, joint);
      if (i < weights.size() && weights[i] != 0) greatest.weighted = std::max<std::int64_t>(greatest.weighted, joint);
    }
    return greatest;
  }

  Gate& gate_;
  std::map<std::size_t, Greatest> meshes_;
  std::map<std::pair<std::size_t, std::optional<std::size_t>>, Joints> accessors_;
};

}  // namespace

void check_skins(Gate& gate) {
  const Json& skins = gate.all("skins");
  for (std::size_t i = 0; i < skins.size(); ++i) {
    const std::string place = at("skins", i);
    gate.required(skins[i], "joints", place);
    const std::vector<std::size_t> joints = gate.references(skins[i], "joints", "nodes", place);
    if (skins[i].contains("joints") && skins[i]["joints"].is_array() && skins[i]["joints"].empty()) {
      gate.error(in(place, "joints"), "out-of-range", "must not be empty");
    }
    if (std::set(joints.begin(), joints.end()).size() != joints.size()) {
      gate.fault("joint-twice", in(place, "joints"), "names a node twice");
    }
    gate.reference(skins[i], "skeleton", "nodes", place);
    const auto number = gate.reference(skins[i], "inverseBindMatrices", "accessors", place);
    const Accessor* matrices = gate.accessor(number);
    if (matrices == nullptr) continue;
    if (matrices->format.component != Component::float32 || matrices->format.components != 16) {
      gate.error(in(place, "inverseBindMatrices"), "accessor-type",
                 fmt::format("accessor {} must be MAT4 of floats", *number));
    }
    if (matrices->count < joints.size()) {
      gate.error(in(place, "inverseBindMatrices"), "unequal-counts",
                 fmt::format("accessor {} has {} matrices for {} joints", *number, matrices->count, joints.size()));
    }
  }
  if (!gate.sound()) return;
  JointCheck joint_check(gate);
  std::set<std::pair<std::size_t, std::size_t>> seen;
  const Json& nodes = gate.all("nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!nodes[i].contains("mesh") || !nodes[i].contains("skin")) continue;
    const auto mesh = nodes[i]["mesh"].get<std::size_t>();
    const auto skin = nodes[i]["skin"].get<std::size_t>();
    if (seen.emplace(mesh, skin).second) joint_check.check(mesh, skins[skin]["joints"].size(), at("nodes", i));
  }
}

}  // namespace foredraw::gltf
