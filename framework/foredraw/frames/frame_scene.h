#pragma once
// A scene as frames show it: placed objects, the triangles of their levels, and what surfaces look like.

#include <foredraw/analysis/analyses.h>
#include <foredraw/base/parallel.h>
#include <foredraw/frames/mipped_image.h>
#include <foredraw/scene/scene.h>
#include <foredraw/viewing/bounding_sphere.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace foredraw {

/// What a level is chosen for: a mesh where a node, or one of the node's instances, shows it.
struct PlacedObject {
  NodeId node = 0;
  std::size_t instance = 0;
  MeshId mesh = 0;
  bool is_posed = false;  ///< joints or morph targets move its vertices
};

/// A level of a draw, decoded. Normals and places in images are there where the level has them, one for each vertex.
struct FrameLevel {
  std::shared_ptr<const Positions> positions;
  std::vector<glm::vec3> normals;
  std::vector<glm::vec2> base_places, normal_map_places;
  std::vector<glm::vec4> wires;      ///< _FOREDRAW_WIRE, as wire_radius.h has it; empty where it or the axis is missing
  std::vector<glm::vec4> wire_axes;  ///< _FOREDRAW_WIRE_AXIS
  std::span<const std::uint32_t> indices;
  std::size_t vertices = 0;  ///< the first so many, which the triangles use
  double error = 0;          ///< largest distance from full detail, in the draw's units
};

/// What a draw's surface looks like.
struct FrameSurface {
  glm::vec4 colour{1};  ///< linear; alpha last
  std::shared_ptr<const MippedImage> base, normal_map;
  Sampling base_sampling, normal_map_sampling;
  float normal_scale = 1;
  AlphaMode alpha_mode = AlphaMode::opaque;
  float alpha_cutoff = 0.5f;
  bool is_double_sided = false;
};

struct FrameDraw {
  DrawId draw = 0;
  std::vector<FrameLevel> levels;
  FrameSurface surface;
};

/// A mesh of triangles; draws of lines and points are left out.
struct FrameMesh {
  std::vector<FrameDraw> draws;
  std::size_t levels = 0;  ///< of the draw that has most; a draw with fewer is at its coarsest from there on
  BoundingSphere sphere;   ///< of full detail, in the mesh's space
  glm::dvec3 half_box{0};  ///< around the sphere's centre, half as large as the box of full detail
  double fill = 1;         ///< how much of the sphere's outline the mesh covers in the mean, if nothing hides anything
  std::vector<BoundingSphere> of_joints;  ///< [joint] of the vertices that it moves; radius -1: of none
};

class FrameScene {
 public:
  /// Decodes all levels of all meshes that nodes show, displaced draws as shown_scene() has them. The scene and the
  /// analyses must outlive this.
  FrameScene(const Scene& scene, Analyses& analyses, const Executor& executor);

  /// As it is shown.
  const Scene& scene() const { return shown_ ? *shown_ : scene_; }
  std::span<const PlacedObject> objects() const { return objects_; }
  const FrameMesh& mesh_of(std::size_t object) const { return meshes_[objects_[object].mesh]; }

 private:
  const Scene& scene_;
  std::unique_ptr<const Scene> shown_;  // null: it is the scene
  std::vector<FrameMesh> meshes_;       // [mesh]
  std::vector<PlacedObject> objects_;
};

}  // namespace foredraw
