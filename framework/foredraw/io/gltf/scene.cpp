// A sound document to a scene.
#include <foredraw/image/found_traits.h>
#include <foredraw/io/gltf/private/base_colour.h>
#include <foredraw/io/gltf/private/displacement.h>
#include <foredraw/io/gltf/private/instances.h>
#include <foredraw/io/gltf/private/kept_sides.h>
#include <foredraw/io/gltf/private/kept_spaces.h>
#include <foredraw/io/gltf/private/material_stamps.h>
#include <foredraw/io/gltf/private/source.h>
#include <foredraw/io/gltf/private/streams.h>
#include <foredraw/io/gltf/private/thickness.h>
#include <foredraw/io/gltf/private/vertex_needs.h>
#include <foredraw/io/image/images.h>
#include <foredraw/io/text/private/uri.h>

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

Topology topology_of(Mode mode) {
  switch (mode) {
    case Mode::points: return Topology::points;
    case Mode::lines:
    case Mode::line_loop:
    case Mode::line_strip: return Topology::lines;
    default: return Topology::triangles;
  }
}

/// Names are free text, and may be of any type in a careless file.
std::string text_in(const Json& holder, const char* key) {
  const auto found = holder.find(key);
  return found != holder.end() && found->is_string() ? found->get<std::string>() : std::string();
}

std::optional<std::uint32_t> id_in(const Json& holder, const char* key) {
  const auto found = holder.find(key);
  return found == holder.end() ? std::nullopt : std::optional(found->get<std::uint32_t>());
}

/// The numbers of an array, or none.
template <class T>
std::vector<T> numbers_in(const Json& holder, const char* key) {
  const auto found = holder.find(key);
  return found == holder.end() ? std::vector<T>() : found->get<std::vector<T>>();
}

Draw draw_of(const Json& json, Streams& streams) {
  const Primitive primitive(json);
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
  draw.material = id_in(json, "material");
  return draw;
}

void add_mesh(Scene& scene, const Json& from, Streams& streams) {
  const auto number = static_cast<std::uint32_t>(scene.meshes.size());
  Mesh mesh;
  mesh.name = text_in(from, "name");
  mesh.weights = numbers_in<float>(from, "weights");
  const std::string name = mesh.name.empty() ? "mesh" + std::to_string(number) : mesh.name;
  const Json& primitives = from["primitives"];
  for (std::uint32_t p = 0; p < primitives.size(); ++p) {
    Draw draw = draw_of(primitives[p], streams);
    draw.name = primitives.size() == 1 ? name : name + '/' + std::to_string(p);
    draw.origin = DrawOrigin{number, p};
    mesh.draws.push_back(static_cast<DrawId>(scene.draws.size()));
    scene.draws.push_back(std::move(draw));
  }
  scene.meshes.push_back(std::move(mesh));
}

/// The members of a top-level array; none where there is no such array.
const Json& all(const Document& document, const char* kind) {
  static const Json none = Json::array();
  const auto found = document.json.find(kind);
  return found == document.json.end() ? none : *found;
}

/// Of the node's camera, if it is a perspective one with an angle that can be.
std::optional<float> camera_angle_of(const Json& node, const Document& document) {
  const auto number = id_in(node, "camera");
  const Json& cameras = all(document, "cameras");
  if (!number || *number >= cameras.size() || !cameras[*number].is_object()) return std::nullopt;
  const auto perspective = cameras[*number].find("perspective");
  if (perspective == cameras[*number].end() || !perspective->is_object()) return std::nullopt;
  const auto angle = perspective->find("yfov");
  if (angle == perspective->end() || !angle->is_number()) return std::nullopt;
  const float radians = angle->get<float>();
  return radians > 0 && radians < 3.1f ? std::optional(radians) : std::nullopt;
}

Node node_of(const Json& from, const Document& document) {
  Node node;
  node.name = text_in(from, "name");
  node.mesh = id_in(from, "mesh");
  node.skin = id_in(from, "skin");
  node.has_camera = from.contains("camera");
  node.camera_angle = camera_angle_of(from, document);
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

Skin skin_of(const Json& from, Streams& streams) {
  Skin skin;
  skin.name = text_in(from, "name");
  skin.joints = numbers_in<NodeId>(from, "joints");
  skin.inverse_bind_matrices.assign(skin.joints.size(), glm::mat4(1));
  const auto matrices = id_in(from, "inverseBindMatrices");
  if (!matrices) return skin;
  const Shared<float> values = streams.decoded(*matrices);
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

Animation animation_of(const Json& from, Streams& streams) {
  static const std::map<std::string, AnimatedPath> paths = {{"translation", AnimatedPath::translation},
                                                            {"rotation", AnimatedPath::rotation},
                                                            {"scale", AnimatedPath::scale},
                                                            {"weights", AnimatedPath::weights}};
  Animation animation;
  animation.name = text_in(from, "name");
  for (const Json& channel : from["channels"]) {
    if (!moves_a_node(channel)) continue;
    const Json& sampler = from["samplers"][channel["sampler"].get<std::size_t>()];
    const std::string between = text_in(sampler, "interpolation");
    AnimationChannel made;
    made.node = channel["target"]["node"].get<NodeId>();
    made.path = paths.at(channel["target"]["path"].get<std::string>());
    made.interpolation = between == "STEP"          ? Interpolation::step
                         : between == "CUBICSPLINE" ? Interpolation::cubic_spline
                                                    : Interpolation::linear;
    made.times = never_falling(streams.decoded(sampler["input"].get<std::size_t>()));
    made.values = streams.decoded(sampler["output"].get<std::size_t>());
    animation.channels.push_back(std::move(made));
  }
  return animation;
}

Material material_of(const Json& from, const Json& document) {
  const std::string alpha_mode = text_in(from, "alphaMode");
  Material material;
  material.name = text_in(from, "name");
  material.alpha_mode = alpha_mode == "BLEND"  ? AlphaMode::blend
                        : alpha_mode == "MASK" ? AlphaMode::mask
                                               : AlphaMode::opaque;
  material.alpha_cutoff = from.value("alphaCutoff", 0.5f);
  material.double_sided = from.value("doubleSided", false);
  add_base_colour(material, from, document);
  add_displacement(material, from, document);
  add_thickness(material, from);
  add_stamps(material, from);
  return material;
}

using ViewBytes = std::map<std::size_t, Shared<std::byte>>;

/// Images in the same buffer view share its bytes.
Image image_of(const Json& from, const Document& document, ViewBytes& views) {
  Image image;
  image.name = text_in(from, "name");
  image.media_type = text_in(from, "mimeType");
  image.uri = text_in(from, "uri");
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

bool moves_a_node(const Json& channel) {
  const Json& target = channel["target"];
  return target.contains("node") && target["path"] != "pointer";
}

Scene scene_of(const Document& document) {
  Scene scene;
  scene.name = document.name;
  Streams streams(document);
  for (const Json& mesh : all(document, "meshes")) add_mesh(scene, mesh, streams);
  scene.nodes.reserve(all(document, "nodes").size());
  for (const Json& node : all(document, "nodes")) scene.nodes.push_back(node_of(node, document));
  find_shown_nodes(scene, document);
  add_instances(scene, document);
  for (const Json& skin : all(document, "skins")) scene.skins.push_back(skin_of(skin, streams));
  for (const Json& animation : all(document, "animations"))
    scene.animations.push_back(animation_of(animation, streams));
  for (const Json& material : all(document, "materials"))
    scene.materials.push_back(material_of(material, document.json));
  find_kept_sides(scene, document.json);
  find_vertex_needs(scene, document);
  find_kept_spaces(scene, document);
  ViewBytes views;
  for (const Json& image : all(document, "images")) scene.images.push_back(image_of(image, document, views));
  find_traits(scene);
  find_extended(scene, document);
  return scene;
}

}  // namespace foredraw::gltf
