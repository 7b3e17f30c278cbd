#include <foredraw/io/gltf/private/streams.h>

#include <algorithm>
#include <numeric>

namespace foredraw::gltf {

namespace {

Primitive::Attributes attributes_of(const Json& json) {
  Primitive::Attributes attributes;
  for (const auto& [semantic, number] : json.items()) attributes.emplace(semantic, number.get<std::size_t>());
  return attributes;
}

/// One strip, loop or fan, taken apart.
void add_connected(std::vector<std::uint32_t>& list, std::span<const std::uint32_t> corners, Mode mode) {
  const std::size_t n = corners.size();
  switch (mode) {
    case Mode::line_loop:
    case Mode::line_strip:
      for (std::size_t i = 0; i + 1 < n; ++i) list.insert(list.end(), {corners[i], corners[i + 1]});
      if (mode == Mode::line_loop && n > 1) list.insert(list.end(), {corners[n - 1], corners[0]});
      return;
    case Mode::triangle_strip:  // every second triangle is turned, so that all wind alike
      for (std::size_t i = 0; i + 2 < n; ++i) {
        list.insert(list.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
      }
      return;
    default:
      for (std::size_t i = 0; i + 2 < n; ++i) list.insert(list.end(), {corners[i + 1], corners[i + 2], corners[0]});
  }
}

std::vector<std::uint32_t> as_list(std::vector<std::uint32_t> corners, Mode mode,
                                   std::optional<std::uint32_t> restart) {
  if (mode == Mode::points || mode == Mode::lines || mode == Mode::triangles) {
    const std::size_t each = mode == Mode::lines ? 2 : mode == Mode::triangles ? 3 : 1;
    corners.erase(corners.end() - static_cast<std::ptrdiff_t>(corners.size() % each), corners.end());
    return corners;
  }
  std::vector<std::uint32_t> list;
  for (auto from = corners.begin();;) {
    const auto to = restart ? std::find(from, corners.end(), *restart) : corners.end();
    add_connected(list, {from, to}, mode);
    if (to == corners.end()) return list;
    from = to + 1;
  }
}

}  // namespace

Primitive::Primitive(const Json& json) : attributes(attributes_of(json["attributes"])) {
  if (const auto found = json.find("targets"); found != json.end()) {
    for (const Json& target : *found) targets.push_back(attributes_of(target));
  }
  if (const auto found = json.find("indices"); found != json.end()) indices = found->get<std::size_t>();
  if (const auto found = json.find("mode"); found != json.end()) mode = static_cast<Mode>(found->get<int>());
}

Streams::Streams(const Document& document) : document_(document) {
  using Layout = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, Component, int, bool>;
  std::map<Layout, std::size_t> known;
  for (const Accessor& a : document.accessors) {
    first_alike_.push_back(first_alike_.size());
    if (!a.rows || a.sparse) continue;
    const Layout layout{a.rows->view,       a.rows->offset,      a.rows->stride,     a.count,
                        a.format.component, a.format.components, a.format.normalized};
    first_alike_.back() = known.try_emplace(layout, first_alike_.back()).first->second;
  }
}

std::shared_ptr<const VertexStreams> Streams::vertices(const Primitive& primitive) {
  const Attributes base = first_alike(primitive.attributes);
  std::vector<Attributes> targets;
  for (const Attributes& target : primitive.targets) targets.push_back(first_alike(target));
  auto& made = vertices_[{base, targets}];
  if (made) return made;
  VertexStreams streams;
  for (const auto& [semantic, accessor] : base) streams.base.push_back(stream(semantic, accessor));
  for (const Attributes& target : targets) {
    auto& own = streams.morph_targets.emplace_back();
    for (const auto& [semantic, accessor] : target) own.push_back(stream(semantic, accessor));
  }
  streams.count = static_cast<std::uint32_t>(vertex_count(primitive));
  made = std::make_shared<const VertexStreams>(std::move(streams));
  return made;
}

Shared<std::uint32_t> Streams::indices(const Primitive& primitive) {
  const std::size_t count = vertex_count(primitive);
  std::optional<std::size_t> number;
  if (primitive.indices) number = first_alike_[*primitive.indices];
  const auto [made, is_new] = indices_.try_emplace({number, number ? 0 : count, primitive.mode});
  if (!is_new) return made->second;
  std::vector<std::uint32_t> corners;
  std::optional<std::uint32_t> restart;
  if (number) {
    corners = index_elements(document_, document_.accessors[*number]);
    restart = restart_of(document_.accessors[*number].format.component);
  } else {
    corners.resize(count);
    std::iota(corners.begin(), corners.end(), 0u);
  }
  made->second = Shared<std::uint32_t>(as_list(std::move(corners), primitive.mode, restart));
  return made->second;
}

Shared<float> Streams::decoded(std::size_t accessor) {
  const auto [made, is_new] = decoded_.try_emplace(first_alike_[accessor]);
  if (is_new) made->second = Shared<float>(decoded_elements(document_, document_.accessors[accessor]));
  return made->second;
}

/// Accessors that name the same bytes alike are one.
Streams::Attributes Streams::first_alike(Attributes attributes) const {
  for (auto& [semantic, accessor] : attributes) accessor = first_alike_[accessor];
  return attributes;
}

/// That many rows has every attribute.
std::size_t Streams::vertex_count(const Primitive& primitive) const {
  return document_.accessors[primitive.attributes.begin()->second].count;
}

VertexStream Streams::stream(const std::string& semantic, std::size_t accessor) {
  const auto [made, is_new] = bytes_.try_emplace(accessor);
  if (is_new) made->second = Shared<std::byte>(elements(document_, document_.accessors[accessor]));
  return {semantic, document_.accessors[accessor].format, made->second};
}

}  // namespace foredraw::gltf
