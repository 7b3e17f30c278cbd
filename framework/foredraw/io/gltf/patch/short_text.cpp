// Text that says what holds anyway, left out; samplers of animations that say the same, made one.
#include <foredraw/io/gltf/patch/private/list_care.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

void erase_where(Json& holder, const char* key, const Json& value) {
  const auto found = holder.find(key);
  if (found != holder.end() && *found == value) holder.erase(found);
}

void shorten(Json& animation, bool joins_equal) {
  Json& samplers = animation["samplers"];
  constexpr std::size_t unused = ~std::size_t{0};
  std::vector<std::size_t> to(samplers.size(), unused);
  for (const Json& channel : animation["channels"]) to[channel["sampler"].get<std::size_t>()] = 0;
  std::map<std::string, std::size_t> first;
  Json left = Json::array();
  for (std::size_t s = 0; s < to.size(); ++s) {
    if (to[s] == unused) continue;
    erase_where(samplers[s], "interpolation", "LINEAR");
    const auto [known, is_new] = first.try_emplace(joins_equal ? samplers[s].dump() : std::to_string(s), left.size());
    to[s] = known->second;
    if (is_new) left.push_back(std::move(samplers[s]));
  }
  for (Json& channel : animation["channels"]) channel["sampler"] = to[channel["sampler"].get<std::size_t>()];
  samplers = std::move(left);
}

}  // namespace

void shorten_text(Json& json, bool joins_equal) {
  if (const auto animations = json.find("animations"); animations != json.end()) {
    for (Json& animation : *animations) shorten(animation, joins_equal);
  }
  if (const auto nodes = json.find("nodes"); nodes != json.end()) {
    for (Json& node : *nodes) {
      erase_where(node, "translation", {0, 0, 0});
      erase_where(node, "rotation", {0, 0, 0, 1});
      erase_where(node, "scale", {1, 1, 1});
    }
  }
}

}  // namespace foredraw::gltf
