// Animations put back: what a stage changed of their keys. Rotations that 16 bits hold to the last bit are written so.
#include <foredraw/io/gltf/private/each_extension.h>
#include <foredraw/io/gltf/private/write.h>

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

/// Those of the accessors that nothing in the document names.
std::set<std::size_t> unused(std::set<std::size_t> candidates, Json& json) {
  std::set<std::size_t> used;
  each_extension(json, [&](const std::string&, const Json& held) { collect_numbers(held, used); });
  each_accessor_named(json, [&](const Json& number) { used.insert(number.get<std::size_t>()); });
  std::erase_if(candidates, [&](std::size_t number) { return used.contains(number); });
  return candidates;
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

bool same_target(const AnimationChannel& a, const AnimationChannel& b) {
  return a.node == b.node && a.path == b.path && a.interpolation == b.interpolation;
}

bool same_keys(const AnimationChannel& a, const AnimationChannel& b) {
  return a.times == b.times && a.values == b.values;
}

/// The channels of the document that the scene knows, in its sequence.
std::vector<Json*> channels_of(Json& animation) {
  std::vector<Json*> known;
  for (Json& channel : animation["channels"]) {
    if (moves_a_node(channel)) known.push_back(&channel);
  }
  return known;
}

/// [channel] its number before; nullopt where some channel was not there, or came behind a later one.
std::optional<std::vector<std::size_t>> numbers_before(const Animation& now, const Animation& was) {
  std::vector<std::size_t> numbers;
  std::size_t before = 0;
  for (const AnimationChannel& channel : now.channels) {
    while (before < was.channels.size() && !same_target(channel, was.channels[before])) ++before;
    if (before == was.channels.size()) return std::nullopt;
    numbers.push_back(before++);
  }
  return numbers;
}

void put_channels(const Animation& now, const Animation& was, const std::vector<std::size_t>& numbers, Json& json,
                  AccessorStore& store) {
  const std::vector<Json*> channels = channels_of(json);
  for (std::size_t c = 0; c < numbers.size(); ++c) {
    const AnimationChannel& before = was.channels[numbers[c]];
    if (same_keys(now.channels[c], before)) continue;
    Json& channel = *channels[numbers[c]];
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

std::optional<std::string> patch_animations(const std::vector<Animation>& now, const std::vector<Animation>& was,
                                            Json& json, AccessorStore& store) {
  std::set<std::size_t> left;
  for (std::size_t i = 0; i < was.size(); ++i) {
    const auto numbers = numbers_before(now[i], was[i]);
    if (now[i].name != was[i].name || !numbers || (numbers->empty() && !was[i].channels.empty())) {
      return "animations[" + std::to_string(i) + ']';
    }
    if (std::ranges::equal(now[i].channels, was[i].channels, same_keys)) continue;
    left.merge(used_by_samplers(json["animations"][i]));
    put_channels(now[i], was[i], *numbers, json["animations"][i], store);
  }
  for (std::size_t i = was.size(); i < now.size(); ++i) json["animations"][i] = json_of(now[i], store);
  if (!left.empty()) {
    for (const std::size_t accessor : unused(std::move(left), json)) store.release(accessor);
  }
  return std::nullopt;
}

}  // namespace foredraw::gltf
