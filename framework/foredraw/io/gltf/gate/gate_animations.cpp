// Checks of animations, and of the numbers that are no vertex data.
#include <foredraw/io/gltf/gate/private/gate.h>
#include <foredraw/io/gltf/patch/private/write.h>
#include <foredraw/io/gltf/private/products.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace foredraw::gltf {

namespace {

void check_times(Gate& gate, const Accessor& accessor, std::size_t number, const std::string& place) {
  if (accessor.format.component != Component::float32 || accessor.format.components != 1) {
    gate.error(place, "accessor-type", fmt::format("accessor {} must be SCALAR of floats", number));
    return;
  }
  const std::vector<float> times = decoded_elements(gate.document(), accessor);
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i])) {
      gate.error(place, "animation-times",
                 fmt::format("accessor {}: time {} is {}, but must be finite", number, i, times[i]));
      return;
    }
    if (times[i] < 0 || (i > 0 && times[i] <= times[i - 1])) {
      gate.fault("key-times", place,
                 fmt::format("accessor {}: time {} is {}; times must not be negative, and must rise strictly", number,
                             i, times[i]));
      return;
    }
  }
}

/// How many output elements the channel's path wants for a key; 0 where it is not known.
std::size_t outputs_for_a_key(Gate& gate, const Json& channel) {
  const Json& target = channel["target"];
  if (target.value("path", "") != "weights") return 1;
  if (!target.contains("node")) return 0;
  const Json& node = gate.all("nodes")[target["node"].get<std::size_t>()];
  if (!node.contains("mesh")) return 0;
  std::size_t most = 0;
  for (const Json& primitive : gate.all("meshes")[node["mesh"].get<std::size_t>()]["primitives"]) {
    if (primitive.contains("targets")) most = std::max(most, primitive["targets"].size());
  }
  return most;
}

std::size_t components_of(const std::string& path) {
  return path == "rotation" ? 4 : path == "weights" ? 1 : path == "translation" || path == "scale" ? 3 : 0;
}

class AnimationCheck {
 public:
  AnimationCheck(Gate& gate, const Json& animation, std::string place)
      : gate_(gate), animation_(animation), place_(std::move(place)) {}

  void run() {
    gate_.required(animation_, "samplers", place_);
    gate_.required(animation_, "channels", place_);
    const Json* samplers = gate_.array(animation_, "samplers", place_);
    const Json* channels = gate_.array(animation_, "channels", place_);
    if (samplers == nullptr || channels == nullptr) return;
    for (std::size_t i = 0; i < samplers->size(); ++i) sampler((*samplers)[i], at(in(place_, "samplers"), i));
    for (std::size_t i = 0; i < channels->size(); ++i)
      channel((*channels)[i], *samplers, at(in(place_, "channels"), i));
  }

 private:
  void sampler(const Json& sampler, const std::string& place) {
    if (!sampler.is_object()) {
      gate_.error(place, "wrong-type", "must be an object");
      return;
    }
    for (const char* key : {"input", "output"}) gate_.required(sampler, key, place);
    const auto input = gate_.reference(sampler, "input", "accessors", place);
    gate_.reference(sampler, "output", "accessors", place);
    if (const Accessor* times = gate_.accessor(input)) check_times(gate_, *times, *input, in(place, "input"));
    gate_.leave_out_if_wrong("interpolation", in(place, "interpolation"), [&] {
      const auto between = gate_.text(sampler, "interpolation", place);
      if (between && *between != "LINEAR" && *between != "STEP" && *between != "CUBICSPLINE") {
        gate_.error(in(place, "interpolation"), "out-of-range",
                    fmt::format("is '{}', but must be LINEAR, STEP or CUBICSPLINE", *between));
      }
    });
  }

  void channel(const Json& channel, const Json& samplers, const std::string& place) {
    if (!channel.is_object()) {
      gate_.error(place, "wrong-type", "must be an object");
      return;
    }
    for (const char* key : {"sampler", "target"}) gate_.required(channel, key, place);
    const auto number = gate_.whole(channel, "sampler", place);
    if (number && *number >= samplers.size()) {
      gate_.error(in(place, "sampler"), "bad-reference",
                  fmt::format("is {}, but the animation has {} samplers", *number, samplers.size()));
    }
    const Json* target = gate_.object(channel, "target", place);
    if (target == nullptr) return;
    gate_.required(*target, "path", in(place, "target"));
    gate_.reference(*target, "node", "nodes", in(place, "target"));
    const auto path = gate_.text(*target, "path", in(place, "target"));
    if (path && *path != "pointer" && components_of(*path) == 0) {
      gate_.error(in(place, "target.path"), "out-of-range",
                  fmt::format("is '{}', but must be translation, rotation, scale or weights", *path));
    }
    if (gate_.sound() && components_of(*path) > 0 && target->contains("node"))
      values(channel, samplers[*number], *path, place);
  }

  void values(const Json& channel, const Json& sampler, const std::string& path, const std::string& place) {
    const Accessor& input = *gate_.accessor(sampler["input"].get<std::size_t>());
    const Accessor& output = *gate_.accessor(sampler["output"].get<std::size_t>());
    if (output.format.components != components_of(path) || output.format.component == Component::uint32) {
      gate_.error(place, "accessor-type",
                  fmt::format("the sampler's output has {} components, but {} has {}", output.format.components, path,
                              components_of(path)));
      return;
    }
    const auto between = sampler.find("interpolation");
    const std::size_t tangents = between != sampler.end() && *between == "CUBICSPLINE" ? 3 : 1;
    const std::size_t wanted = input.count * tangents * outputs_for_a_key(gate_, channel);
    if (output.count == wanted) return;
    gate_.error(place, "animation-count",
                fmt::format("the sampler's output has {} elements, but {} keys of {} need {}", output.count,
                            input.count, path, wanted));
  }

  Gate& gate_;
  const Json& animation_;
  std::string place_;
};

}  // namespace

void check_animations(Gate& gate) {
  const Json& animations = gate.all("animations");
  for (std::size_t i = 0; i < animations.size(); ++i) AnimationCheck(gate, animations[i], at("animations", i)).run();
}

void check_finite(Gate& gate) {
  // Vertices may hold what is not finite; what products name, their rows look at, and what was taken out nobody reads.
  std::set<std::size_t> vertex_data = used_by_products(gate.json(), gate.document().products);
  vertex_data.insert(gate.document().let_go.begin(), gate.document().let_go.end());
  for (const std::size_t number : used_elsewhere(gate.document())) vertex_data.erase(number);
  for (const Json& mesh : gate.all("meshes")) {
    for (const Json& primitive : mesh["primitives"]) {
      for (const auto& [semantic, number] : primitive["attributes"].items())
        vertex_data.insert(number.get<std::size_t>());
      if (!primitive.contains("targets")) continue;
      for (const Json& target : primitive["targets"]) {
        for (const auto& [semantic, number] : target.items()) vertex_data.insert(number.get<std::size_t>());
      }
    }
  }
  for (std::size_t i = 0; i < gate.accessors.size(); ++i) {
    const Accessor& accessor = *gate.accessors[i];
    if (accessor.format.component != Component::float32 || vertex_data.contains(i)) continue;
    for (float value : decoded_elements(gate.document(), accessor)) {
      if (std::isfinite(value)) continue;
      gate.error(at("accessors", i), "non-finite", "holds a number that is infinite or NaN");
      break;
    }
  }
}

}  // namespace foredraw::gltf
