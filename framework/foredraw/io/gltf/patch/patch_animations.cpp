// Animations put back: what a stage changed of their keys. Rotations that 16 bits hold to the last bit are written so.
#include <foredraw/io/gltf/patch/private/write.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw::gltf {

namespace {

const char* word(AnimatedPath path) {
  switch (path) {
    case AnimatedPath::translation: return "translation";
    case AnimatedPath::rotation: return "rotation";
    case AnimatedPath::scale: return "scale";
    case AnimatedPath::weights: return "weights";
  }
  return "weights";
}

const char* word(Interpolation between) {
  return between == Interpolation::step ? "STEP" : between == Interpolation::cubic_spline ? "CUBICSPLINE" : "LINEAR";
}

Content content_of(Format format, std::size_t count, Bytes bytes, bool wants_range = false) {
  return {Content::Kind::other, format, count, Shared<std::byte>({bytes.begin(), bytes.end()}), wants_range};
}

Content floats(std::span<const float> values, std::uint8_t components, bool wants_range) {
  return content_of({Component::float32, components, false, static_cast<std::uint16_t>(4 * components)},
                    values.size() / components, std::as_bytes(values), wants_range);
}

/// The numbers that stand for these values as normalized integers of 16 bits; empty where some value has none.
std::vector<std::int16_t> as_16_bits(std::span<const float> values) {
  std::vector<std::int16_t> whole(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(std::abs(values[i]) <= 1)) return {};
    whole[i] = static_cast<std::int16_t>(std::lround(values[i] * 32767.0f));
    if (static_cast<float>(whole[i]) / 32767.0f != values[i]) return {};
  }
  return whole;
}

std::size_t output_of(const AnimationChannel& channel, AccessorStore& store) {
  const auto values = channel.values.view();
  if (channel.path == AnimatedPath::rotation) {
    if (const auto whole = as_16_bits(values); !whole.empty()) {
      return store.append(
          content_of({Component::int16, 4, true, 8}, whole.size() / 4, std::as_bytes(std::span(whole))));
    }
    return store.append(floats(values, 4, false));
  }
  return store.append(floats(values, channel.path == AnimatedPath::weights ? 1 : 3, false));
}

std::set<std::size_t> used_by_samplers(const Json& animation) {
  std::set<std::size_t> numbers;
  for (const Json& sampler : animation["samplers"]) {
    for (const char* part : {"input", "output"}) numbers.insert(sampler[part].get<std::size_t>());
  }
  return numbers;
}

/// Samplers that no channel names are gone; the others keep their sequence.
void leave_out_unused_samplers(Json& animation) {
  std::vector<std::optional<std::size_t>> numbers(animation["samplers"].size());
  for (const Json& channel : animation["channels"]) numbers[channel["sampler"].get<std::size_t>()] = 0;
  Json samplers = Json::array();
  for (std::size_t s = 0; s < numbers.size(); ++s) {
    if (!numbers[s]) continue;
    numbers[s] = samplers.size();
    samplers.push_back(animation["samplers"][s]);
  }
  for (Json& channel : animation["channels"]) channel["sampler"] = *numbers[channel["sampler"].get<std::size_t>()];
  animation["samplers"] = std::move(samplers);
}

/// The same; or, of weights, a child that was added to the node that they moved.
bool is_target(const AnimationChannel& now, const AnimationChannel& was, const Scene& scene, std::size_t old) {
  if (now.path != was.path || now.interpolation != was.interpolation) return false;
  if (now.node == was.node) return true;
  const std::vector<NodeId>& children = scene.nodes[was.node].children;
  return now.path == AnimatedPath::weights && now.node >= old &&
         std::ranges::find(children, now.node) != children.end();
}

/// Whether each key of weights holds one for each morph target of the node's mesh.
bool fits(const AnimationChannel& weights, const Scene& scene) {
  const std::optional<MeshId> mesh = scene.nodes[weights.node].mesh;
  if (!mesh || *mesh >= scene.meshes.size()) return false;
  std::size_t targets = 0;
  for (const DrawId draw : scene.meshes[*mesh].draws) {
    if (draw >= scene.draws.size()) return false;
    targets = std::max(targets, scene.draws[draw].full().vertices->morph_targets.size());
  }
  const std::size_t parts = weights.interpolation == Interpolation::cubic_spline ? 3 : 1;
  return weights.values.size() == weights.times.size() * parts * targets;
}

bool same_keys(const AnimationChannel& a, const AnimationChannel& b) {
  return a.times == b.times && a.values == b.values;
}

bool same_channel(const AnimationChannel& a, const AnimationChannel& b) { return a.node == b.node && same_keys(a, b); }

/// The channels of the document that the scene knows, in its sequence.
std::vector<Json*> channels_of(Json& animation) {
  std::vector<Json*> known;
  for (Json& channel : animation["channels"]) {
    if (moves_a_node(channel)) known.push_back(&channel);
  }
  return known;
}

/// [channel] its number before; nullopt where some channel was not there, or came behind a later one.
std::optional<std::vector<std::size_t>> numbers_before(const Animation& now, const Animation& was, const Scene& scene,
                                                       std::size_t old) {
  std::vector<std::size_t> numbers;
  std::size_t before = 0;
  for (const AnimationChannel& channel : now.channels) {
    while (before < was.channels.size() && !is_target(channel, was.channels[before], scene, old)) ++before;
    if (before == was.channels.size()) return std::nullopt;
    numbers.push_back(before++);
  }
  return numbers;
}

/// Why channels can not be written; empty: they can.
std::string why_not(const Animation& now, const Scene& scene, const Scene& was) {
  for (const AnimationChannel& channel : now.channels) {
    if (channel.path != AnimatedPath::weights) continue;
    const bool is_new = channel.node >= was.nodes.size();
    if (!is_new && scene.nodes[channel.node].mesh == was.nodes[channel.node].mesh) continue;
    if (!fits(channel, scene)) {
      return "it moves the morph weights of node " + std::to_string(channel.node) +
             ", whose mesh is gone or has another number of morph targets";
    }
  }
  return {};
}

void put_channels(const Animation& now, const Animation& was, const std::vector<std::size_t>& numbers, Json& json,
                  AccessorStore& store) {
  const std::vector<Json*> channels = channels_of(json);
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    const AnimationChannel& before = was.channels[numbers[c]];
    Json& channel = *channels[numbers[c]];
    if (now.channels[c].node != before.node) channel["target"]["node"] = now.channels[c].node;
    if (same_keys(now.channels[c], before)) continue;
    Json sampler = json["samplers"][channel["sampler"].get<std::size_t>()];
    if (!(now.channels[c].times == before.times)) {
      sampler["input"] = store.append(floats(now.channels[c].times.view(), 1, true));
    }
    sampler["output"] = output_of(now.channels[c], store);
    channel["sampler"] = json["samplers"].size();
    json["samplers"].push_back(std::move(sampler));
  }
  Json left = Json::array();
  std::size_t known = 0;
  for (Json& channel : json["channels"]) {
    const bool stays = !moves_a_node(channel) || std::ranges::binary_search(numbers, known++);
    if (stays) left.push_back(std::move(channel));
  }
  json["channels"] = std::move(left);
  leave_out_unused_samplers(json);
}

Json json_of(const Animation& animation, AccessorStore& store) {
  Json json = Json::object();
  if (!animation.name.empty()) json["name"] = animation.name;
  json["channels"] = Json::array();
  json["samplers"] = Json::array();
  for (const AnimationChannel& channel : animation.channels) {
    json["channels"].push_back(
        JsonObject{{"sampler", json["samplers"].size()},
                   {"target", JsonObject{{"node", channel.node}, {"path", word(channel.path)}}}});
    json["samplers"].push_back(JsonObject{{"input", store.append(floats(channel.times.view(), 1, true))},
                                          {"interpolation", word(channel.interpolation)},
                                          {"output", output_of(channel, store)}});
  }
  return json;
}

}  // namespace

std::optional<Refusal> patch_animations(const Scene& scene, const Scene& was, Json& json, AccessorStore& store,
                                        std::set<std::size_t>& left) {
  const std::vector<Animation>& now = scene.animations;
  const std::size_t old = was.animations.size();
  if (now.size() < old) return Refusal{"animations", "some were removed"};
  for (std::size_t i = 0; i < old; ++i) {
    const Animation& before = was.animations[i];
    const std::string place = "animations[" + std::to_string(i) + ']';
    const auto numbers = numbers_before(now[i], before, scene, was.nodes.size());
    if (now[i].name != before.name || !numbers || (numbers->empty() && !before.channels.empty()))
      return Refusal{place, "channels were added or moved, or all are gone"};
    if (const std::string why = why_not(now[i], scene, was); !why.empty()) return Refusal{place, why};
    if (std::ranges::equal(now[i].channels, before.channels, same_channel)) continue;
    left.merge(used_by_samplers(json["animations"][i]));
    put_channels(now[i], before, *numbers, json["animations"][i], store);
  }
  for (std::size_t i = old; i < now.size(); ++i) json["animations"][i] = json_of(now[i], store);
  return std::nullopt;
}

}  // namespace foredraw::gltf
