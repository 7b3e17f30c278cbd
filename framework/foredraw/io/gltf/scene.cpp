// A sound document to a scene. tinygltf reads the structure, nodes apart; the bytes come from the layouts that the gate
// checked.
#include <foredraw/image/found_traits.h>
#include <foredraw/io/gltf/private/base_colour.h>
#include <foredraw/io/gltf/private/instances.h>
#include <foredraw/io/gltf/private/kept_sides.h>
#include <foredraw/io/gltf/private/material_stamps.h>
#include <foredraw/io/gltf/private/source.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/text/private/uri.h>

#include <glm/gtc/type_ptr.hpp>

#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#include <tiny_gltf.h>

#include <algorithm>
#include <map>
#include <new>
#include <numeric>

namespace foredraw::gltf {

namespace {

template <class T>
std::optional<T> optional_id(int number) {
  return number < 0 ? std::nullopt : std::optional<T>(static_cast<T>(number));
}

std::vector<float> floats(const std::vector<double>& values) {
  std::vector<float> result;
  for (double value : values) result.push_back(static_cast<float>(value));
  return result;
}

/// The streams of a document, each made once and shared by whoever names the same bytes.
class Streams {
 public:
  explicit Streams(const Document& document) : document_(document) {
    using Layout = std::tuple<std::size_t, std::size_t, std::size_t, std::size_t, Component, int, bool>;
    std::map<Layout, int> known;
    for (const Accessor& a : document.accessors) {
      first_alike_.push_back(static_cast<int>(first_alike_.size()));
      if (!a.rows || a.sparse) continue;
      const Layout layout{a.rows->view,       a.rows->offset,      a.rows->stride,     a.count,
                          a.format.component, a.format.components, a.format.normalized};
      first_alike_.back() = known.try_emplace(layout, first_alike_.back()).first->second;
    }
  }

  std::shared_ptr<const VertexStreams> vertices(const tinygltf::Primitive& primitive) {
    const Attributes base = first_alike(primitive.attributes);
    std::vector<Attributes> targets;
    for (const auto& target : primitive.targets) targets.push_back(first_alike(target));
    auto& made = vertices_[{base, targets}];
    if (made) return made;
    VertexStreams streams;
    for (const auto& [semantic, number] : base) streams.base.push_back(stream(semantic, number));
    for (const auto& target : targets) {
      auto& own = streams.morph_targets.emplace_back();
      for (const auto& [semantic, number] : target) own.push_back(stream(semantic, number));
    }
    streams.count = static_cast<std::uint32_t>(vertex_count(primitive));
    made = std::make_shared<const VertexStreams>(std::move(streams));
    return made;
  }

  /// As lists, strips and fans taken apart.
  Shared<std::uint32_t> indices(const tinygltf::Primitive& primitive) {
    const std::size_t count = vertex_count(primitive);
    const int number = primitive.indices < 0 ? -1 : first_alike_[static_cast<std::size_t>(primitive.indices)];
    const auto [made, is_new] = indices_.try_emplace({number, number < 0 ? count : 0, primitive.mode});
    if (!is_new) return made->second;
    std::vector<std::uint32_t> corners;
    if (primitive.indices >= 0) {
      corners = index_elements(document_, accessor(primitive.indices));
    } else {
      corners.resize(count);
      std::iota(corners.begin(), corners.end(), 0u);
    }
    made->second = Shared<std::uint32_t>(as_list(std::move(corners), primitive.mode));
    return made->second;
  }

  Shared<float> decoded(int number) {
    const auto [made, is_new] = decoded_.try_emplace(number);
    if (is_new) made->second = Shared<float>(decoded_elements(document_, accessor(number)));
    return made->second;
  }

 private:
  using Attributes = std::map<std::string, int>;

  /// Accessors that name the same bytes alike are one: what a file says a thousand times takes memory once.
  Attributes first_alike(Attributes attributes) const {
    for (auto& [semantic, number] : attributes) number = first_alike_[static_cast<std::size_t>(number)];
    return attributes;
  }

  const Accessor& accessor(int number) const { return document_.accessors[static_cast<std::size_t>(number)]; }

  /// That many rows has every attribute.
  std::size_t vertex_count(const tinygltf::Primitive& primitive) const {
    return accessor(primitive.attributes.begin()->second).count;
  }

  VertexStream stream(const std::string& semantic, int number) {
    const auto [made, is_new] = bytes_.try_emplace(number);
    if (is_new) made->second = Shared<std::byte>(elements(document_, accessor(number)));
    return {semantic, accessor(number).format, made->second};
  }

  static std::vector<std::uint32_t> as_list(std::vector<std::uint32_t> corners, int mode) {
    std::vector<std::uint32_t> list;
    const std::size_t n = corners.size();
    switch (mode) {
      case TINYGLTF_MODE_LINE_LOOP:
      case TINYGLTF_MODE_LINE_STRIP:
        for (std::size_t i = 0; i + 1 < n; ++i) list.insert(list.end(), {corners[i], corners[i + 1]});
        if (mode == TINYGLTF_MODE_LINE_LOOP) list.insert(list.end(), {corners[n - 1], corners[0]});
        return list;
      case TINYGLTF_MODE_TRIANGLE_STRIP:  // every second triangle is turned, so that all wind alike
        for (std::size_t i = 0; i + 2 < n; ++i) {
          list.insert(list.end(), {corners[i], corners[i + 1 + i % 2], corners[i + 2 - i % 2]});
        }
        return list;
      case TINYGLTF_MODE_TRIANGLE_FAN:
        for (std::size_t i = 0; i + 2 < n; ++i) list.insert(list.end(), {corners[i + 1], corners[i + 2], corners[0]});
        return list;
      default: {
        const std::size_t each = mode == TINYGLTF_MODE_LINE ? 2 : mode == TINYGLTF_MODE_TRIANGLES ? 3 : 1;
        corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(n - n % each), corners.end());
        return corners;
      }
    }
  }

  const Document& document_;
  std::vector<int> first_alike_;  ///< of each accessor
  std::map<std::pair<Attributes, std::vector<Attributes>>, std::shared_ptr<const VertexStreams>> vertices_;
  std::map<std::tuple<int, std::size_t, int>, Shared<std::uint32_t>> indices_;
  std::map<int, Shared<std::byte>> bytes_;
  std::map<int, Shared<float>> decoded_;
};

Topology topology_of(int mode) {
  switch (mode) {
    case TINYGLTF_MODE_POINTS: return Topology::points;
    case TINYGLTF_MODE_LINE:
    case TINYGLTF_MODE_LINE_LOOP:
    case TINYGLTF_MODE_LINE_STRIP: return Topology::lines;
    default: return Topology::triangles;
  }
}

Draw draw_of(const tinygltf::Primitive& primitive, Streams& streams) {
  Draw draw;
  Level level;
  level.vertices = streams.vertices(primitive);
  IndexStream order;
  // Without positions nothing is drawn, whatever the indices say: no points, for one. Nor with too few corners.
  if (primitive.attributes.contains("POSITION")) order.indices = streams.indices(primitive);
  const bool is_drawn = order.indices.size() > 0;
  level.orders.push_back(std::move(order));
  draw.levels.push_back(std::move(level));
  draw.topology = is_drawn ? topology_of(primitive.mode) : Topology::points;
  draw.material = optional_id<MaterialId>(primitive.material);
  return draw;
}

void add_meshes(Scene& scene, const tinygltf::Model& model, Streams& streams) {
  for (std::uint32_t m = 0; m < model.meshes.size(); ++m) {
    const tinygltf::Mesh& from = model.meshes[m];
    Mesh mesh;
    mesh.name = from.name;
    mesh.weights = floats(from.weights);
    const std::string name = from.name.empty() ? "mesh" + std::to_string(m) : from.name;
    for (std::uint32_t p = 0; p < from.primitives.size(); ++p) {
      Draw draw = draw_of(from.primitives[p], streams);
      draw.name = from.primitives.size() == 1 ? name : name + '/' + std::to_string(p);
      draw.origin = DrawOrigin{m, p};
      mesh.draws.push_back(static_cast<DrawId>(scene.draws.size()));
      scene.draws.push_back(std::move(draw));
    }
    scene.meshes.push_back(std::move(mesh));
  }
}

/// The numbers of an array, or none.
template <class T>
std::vector<T> numbers_in(const Json& holder, const char* key) {
  const auto found = holder.find(key);
  return found == holder.end() ? std::vector<T>() : found->get<std::vector<T>>();
}

Node node_of(const Json& from) {
  Node node;
  const auto id = [&](const char* key) {
    const auto found = from.find(key);
    return found == from.end() ? std::nullopt : std::optional(found->get<std::uint32_t>());
  };
  if (const auto name = from.find("name"); name != from.end() && name->is_string()) node.name = *name;
  node.mesh = id("mesh");
  node.skin = id("skin");
  node.has_camera = from.contains("camera");
  node.weights = numbers_in<float>(from, "weights");
  node.children = numbers_in<NodeId>(from, "children");
  if (const auto m = numbers_in<float>(from, "matrix"); !m.empty()) {  // and nothing beside it
    node.matrix = glm::make_mat4(m.data());
    return node;
  }
  Transform& to = node.transform;
  if (const auto t = numbers_in<float>(from, "translation"); !t.empty()) to.translation = glm::make_vec3(t.data());
  if (const auto s = numbers_in<float>(from, "scale"); !s.empty()) to.scale = glm::make_vec3(s.data());
  if (const auto q = numbers_in<float>(from, "rotation"); !q.empty()) to.rotation = glm::quat(q[3], q[0], q[1], q[2]);
  return node;
}

Skin skin_of(const tinygltf::Skin& from, Streams& streams) {
  Skin skin;
  skin.name = from.name;
  for (int joint : from.joints) skin.joints.push_back(static_cast<NodeId>(joint));
  skin.inverse_bind_matrices.assign(skin.joints.size(), glm::mat4(1));
  if (from.inverseBindMatrices < 0) return skin;
  const Shared<float> values = streams.decoded(from.inverseBindMatrices);
  for (std::size_t i = 0; i < skin.joints.size(); ++i) {
    skin.inverse_bind_matrices[i] = glm::make_mat4(values.view().data() + 16 * i);
  }
  return skin;
}

/// Key times that never fall: one that would is that of the key before.
Shared<float> never_falling(const Shared<float>& times) {
  if (std::ranges::is_sorted(times.view())) return times;
  std::vector<float> risen(times.view().begin(), times.view().end());
  for (std::size_t i = 1; i < risen.size(); ++i) risen[i] = std::max(risen[i], risen[i - 1]);
  return Shared<float>(std::move(risen));
}

Animation animation_of(const tinygltf::Animation& from, Streams& streams) {
  static const std::map<std::string, AnimatedPath> paths = {{"translation", AnimatedPath::translation},
                                                            {"rotation", AnimatedPath::rotation},
                                                            {"scale", AnimatedPath::scale},
                                                            {"weights", AnimatedPath::weights}};
  Animation animation;
  animation.name = from.name;
  for (const tinygltf::AnimationChannel& channel : from.channels) {
    const tinygltf::AnimationSampler& sampler = from.samplers[static_cast<std::size_t>(channel.sampler)];
    AnimationChannel made;
    made.node = static_cast<NodeId>(channel.target_node);
    made.path = paths.at(channel.target_path);
    made.interpolation = sampler.interpolation == "STEP"          ? Interpolation::step
                         : sampler.interpolation == "CUBICSPLINE" ? Interpolation::cubic_spline
                                                                  : Interpolation::linear;
    made.times = never_falling(streams.decoded(sampler.input));
    made.values = streams.decoded(sampler.output);
    animation.channels.push_back(std::move(made));
  }
  return animation;
}

Material material_of(const tinygltf::Material& from) {
  Material material;
  material.name = from.name;
  material.alpha_mode = from.alphaMode == "BLEND"  ? AlphaMode::blend
                        : from.alphaMode == "MASK" ? AlphaMode::mask
                                                   : AlphaMode::opaque;
  material.alpha_cutoff = static_cast<float>(from.alphaCutoff);
  material.double_sided = from.doubleSided;
  return material;
}

using ViewBytes = std::map<std::size_t, Shared<std::byte>>;

/// Images in the same buffer view share its bytes.
Image image_of(const Json& from, const Document& document, ViewBytes& views) {
  const auto text = [&](const char* key) {
    const auto found = from.find(key);
    return found != from.end() && found->is_string() ? found->get<std::string>() : std::string();
  };
  Image image;
  image.name = text("name");
  image.media_type = text("mimeType");
  image.uri = text("uri");
  if (is_data_uri(image.uri)) {
    DataUri data = *decode_data_uri(image.uri);
    if (image.media_type.empty()) image.media_type = data.media_type;
    image.bytes = Shared<std::byte>(std::move(data.bytes));
    image.uri.clear();
  } else if (from.contains("bufferView")) {
    const auto view = from["bufferView"].get<std::size_t>();
    const auto [made, is_new] = views.try_emplace(view);
    const Bytes bytes = document.views[view].bytes;
    if (is_new) made->second = Shared<std::byte>({bytes.begin(), bytes.end()});
    image.bytes = made->second;
  }
  image.facts = image_facts(image.bytes.view());
  return image;
}

}  // namespace

std::optional<Scene> scene_of(const Document& document, Diagnostics& diagnostics) {
  tinygltf::TinyGLTF reader;
  tinygltf::Model model;
  std::string errors, warnings;
  const std::string text = checked_structure(document.json);
  if (!reader.LoadASCIIFromString(&model, &errors, &warnings, text.data(), static_cast<unsigned>(text.size()), "")) {
    if (errors.find("bad_alloc") != std::string::npos) throw std::bad_alloc();  // which it has caught
    diagnostics.error({.file = document.name}, "cannot-read", "tinygltf cannot read the file: " + errors);
    return std::nullopt;
  }
  Scene scene;
  scene.name = document.name;
  Streams streams(document);
  add_meshes(scene, model, streams);
  if (const auto nodes = document.json.find("nodes"); nodes != document.json.end()) {
    scene.nodes.reserve(nodes->size());
    for (const Json& node : *nodes) scene.nodes.push_back(node_of(node));
  }
  find_shown_nodes(scene, document);
  add_instances(scene, document);
  for (const auto& skin : model.skins) scene.skins.push_back(skin_of(skin, streams));
  for (const auto& animation : model.animations) scene.animations.push_back(animation_of(animation, streams));
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    scene.materials.push_back(material_of(model.materials[m]));
    add_base_colour(scene.materials.back(), document.json["materials"][m], document.json);
    add_stamps(scene.materials.back(), document.json["materials"][m]);
  }
  find_kept_sides(scene, document.json);
  if (const auto images = document.json.find("images"); images != document.json.end()) {
    ViewBytes views;
    for (const Json& image : *images) scene.images.push_back(image_of(image, document, views));
  }
  find_traits(scene);
  find_extended(scene, document);
  return scene;
}

}  // namespace foredraw::gltf
