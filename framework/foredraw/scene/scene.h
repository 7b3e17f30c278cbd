#pragma once
// A scene is a value: a copy is a copy of handles. Images alone are a scene too.

#include <foredraw/scene/draw.h>
#include <foredraw/scene/image.h>
#include <foredraw/scene/products.h>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>

#include <optional>
#include <span>

namespace foredraw {

using MeshId = std::uint32_t;
using NodeId = std::uint32_t;
using SkinId = std::uint32_t;
using AnimationId = std::uint32_t;

struct Mesh {
  std::string name;
  std::vector<DrawId> draws;
  std::vector<float> weights;  ///< of the morph targets, at rest
};

struct Transform {
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};

  glm::mat4 matrix() const;
};

struct Node {
  std::string name;
  Transform transform;
  std::optional<glm::mat4> matrix;  ///< stands for the transform where the file gives one
  std::optional<MeshId> mesh;
  std::optional<SkinId> skin;
  std::vector<float> weights;
  std::vector<NodeId> children;
  bool has_camera = false;
  std::optional<float> camera_angle;  ///< of a perspective one: from the lower to the upper edge, radians
  bool is_shown = true;               ///< false where the scene that the file shows does not hold it, or it is hidden
  /// EXT_mesh_gpu_instancing: the node's mesh is drawn once for each, placed by it within the node's space. Children
  /// are not. Empty: drawn once, as the node stands.
  Shared<Transform> instances;
  /// Its mesh can not be drawn by anything else in its place: the file says more of it than stands here, as an
  /// extension or a further scene that shows it, or no scene shows it. Found by the reader.
  bool keeps_mesh = false;

  glm::mat4 local() const;
};

struct Skin {
  std::string name;
  std::vector<NodeId> joints;
  std::vector<glm::mat4> inverse_bind_matrices;  ///< as many as joints; identity where the file gives none
};

enum class AnimatedPath : std::uint8_t { translation, rotation, scale, weights };
enum class Interpolation : std::uint8_t { linear, step, cubic_spline };

struct AnimationChannel {
  NodeId node = 0;
  AnimatedPath path = AnimatedPath::translation;
  Interpolation interpolation = Interpolation::linear;
  Shared<float> times;   ///< seconds
  Shared<float> values;  ///< decoded; for cubic splines in-tangent, value, out-tangent a key
};

struct Animation {
  std::string name;
  std::vector<AnimationChannel> channels;
};

/// The file that a scene came from, kept by the reader for the writer, so that what no stage touched comes out as it
/// was.
class SceneSource {
 public:
  virtual ~SceneSource() = default;

  /// Of the file and those beside it that a writer may write again; 0: not known.
  virtual std::uint64_t bytes() const { return 0; }
};

/// What a writer does with what a file lists: materials, textures, samplers, images, nodes and others. Stages ask for
/// it; who writes the list knows what names what.
struct ListCare {
  bool leaves_out_unnamed = false;  ///< what nothing refers to, and nodes that show and move nothing
  bool joins_equal = false;         ///< who refers to one of several equal ones refers to the first
  bool keeps_names = true;          ///< a node or material with a name stays, unless an equal one has that name
  friend bool operator==(const ListCare&, const ListCare&) = default;
};

struct Scene {
  std::string name;  ///< the file's, for messages
  std::vector<Draw> draws;
  std::vector<Mesh> meshes;
  std::vector<Node> nodes;
  std::vector<NodeId> roots;  ///< in which sequence the scene that is shown names its roots; empty: by number
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<Material> materials;
  std::vector<Image> images;
  Products products;  ///< what techniques made beside triangles and vertices
  std::shared_ptr<const SceneSource> source;
  ListCare lists = {};

  const Material* material_of(const Draw& draw) const {
    return draw.material && *draw.material < materials.size() ? &materials[*draw.material] : nullptr;
  }
};

/// Each node's transform to the world, from its transform to its parent. Nodes without a parent are roots.
std::vector<glm::mat4> world_transforms(const Scene& scene, std::span<const glm::mat4> locals);
std::vector<glm::mat4> world_transforms(const Scene& scene);  ///< as the nodes stand

}  // namespace foredraw
