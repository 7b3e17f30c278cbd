#pragma once
// What the structs of a scene hold.

#include <foredraw/cache/private/archive.h>
#include <foredraw/scene/product_row.h>

namespace foredraw::archive {

template <class Handles>
void fields(Out<Handles>& to, const Traits& traits) {
  to(std::vector<std::string>(traits.begin(), traits.end()));
}

template <class Handles>
void fields(In<Handles>& from, Traits& traits) {
  std::vector<std::string> names;
  from(names);
  traits = {};
  for (const std::string& name : names) traits.add(Trait(name));
}

template <class A, Is<Format> T>
void fields(A& archive, T& value) {
  auto& [component, components, normalized, bytes] = value;
  archive(component, components, normalized, bytes);
}

template <class A, Is<VertexStream> T>
void fields(A& archive, T& value) {
  auto& [semantic, format, bytes] = value;
  archive(semantic, format, bytes);
}

template <class A, Is<VertexStreams> T>
void fields(A& archive, T& value) {
  auto& [base, morph_targets, count] = value;
  archive(base, morph_targets, count);
}

template <class A, Is<Clusters> T>
void fields(A& archive, T& value) {
  auto& [offsets] = value;
  archive(offsets);
}

template <class A, Is<IndexStream> T>
void fields(A& archive, T& value) {
  auto& [indices, clusters, cache_size, triangle_origin] = value;
  archive(indices, clusters, cache_size, triangle_origin);
}

template <class A, Is<DrawOrigin> T>
void fields(A& archive, T& value) {
  auto& [mesh, primitive] = value;
  archive(mesh, primitive);
}

template <class A, Is<Level> T>
void fields(A& archive, T& value) {
  auto& [vertices, orders, error, vertex_destination, made, origin] = value;
  archive(vertices, orders, error, vertex_destination, made, origin);
}

template <class A, Is<SpriteFrame> T>
void fields(A& archive, T& value) {
  auto& [x, y, width, height] = value;
  archive(x, y, width, height);
}

template <class A, Is<DrawSpace> T>
void fields(A& archive, T& value) {
  auto& [offset, scale] = value;
  archive(offset, scale);
}

template <class A, Is<Draw> T>
void fields(A& archive, T& value) {
  auto& [name, levels, topology, material, traits, origin, frame, space] = value;
  archive(name, levels, topology, material, traits, origin, frame, space);
}

template <class A, Is<Mesh> T>
void fields(A& archive, T& value) {
  auto& [name, draws, weights] = value;
  archive(name, draws, weights);
}

template <class A, Is<Transform> T>
void fields(A& archive, T& value) {
  auto& [translation, rotation, scale] = value;
  archive(translation, rotation, scale);
}

template <class A, Is<Node> T>
void fields(A& archive, T& value) {
  auto& [name, transform, matrix, mesh, skin, weights, children, has_camera, camera_angle, is_shown, instances,
         keeps_mesh] = value;
  archive(name, transform, matrix, mesh, skin, weights, children, has_camera, camera_angle, is_shown, instances,
          keeps_mesh);
}

template <class A, Is<Skin> T>
void fields(A& archive, T& value) {
  auto& [name, joints, inverse_bind_matrices] = value;
  archive(name, joints, inverse_bind_matrices);
}

template <class A, Is<AnimationChannel> T>
void fields(A& archive, T& value) {
  auto& [node, path, interpolation, times, values] = value;
  archive(node, path, interpolation, times, values);
}

template <class A, Is<Animation> T>
void fields(A& archive, T& value) {
  auto& [name, channels] = value;
  archive(name, channels);
}

template <class A, Is<Texture> T>
void fields(A& archive, T& value) {
  auto& [image, texcoord, wrap, is_nearest, scale, rotation, offset] = value;
  archive(image, texcoord, wrap, is_nearest, scale, rotation, offset);
}

template <class A, Is<ScaledTexcoords> T>
void fields(A& archive, T& value) {
  auto& [set, offset, scale] = value;
  archive(set, offset, scale);
}

template <class A, Is<Displacement> T>
void fields(A& archive, T& value) {
  auto& [texture, factor, offset] = value;
  archive(texture, factor, offset);
}

template <class A, Is<VertexNeeds> T>
void fields(A& archive, T& value) {
  auto& [texcoords, has_tangents] = value;
  archive(texcoords, has_tangents);
}

template <class A, Is<Material> T>
void fields(A& archive, T& value) {
  auto& [name, alpha_mode, alpha_cutoff, double_sided, alpha, colour, base_colour, normal_map, normal_scale,
         displacement, thickness, look, kind, keeps_sides, keeps_spaces, copy_of, needs, scaled_texcoords] = value;
  archive(name, alpha_mode, alpha_cutoff, double_sided, alpha, colour, base_colour, normal_map, normal_scale,
          displacement, thickness, look, kind, keeps_sides, keeps_spaces, copy_of, needs, scaled_texcoords);
}

template <class A, Is<ImageFacts> T>
void fields(A& archive, T& value) {
  auto& [width, height, channels, bits, is_float] = value;
  archive(width, height, channels, bits, is_float);
}

template <class A, Is<Image> T>
void fields(A& archive, T& value) {
  auto& [name, media_type, uri, bytes, is_texels, facts] = value;
  archive(name, media_type, uri, bytes, is_texels, facts);
}

template <class A, Is<ListCare> T>
void fields(A& archive, T& value) {
  auto& [leaves_out_unnamed, joins_equal, keeps_names] = value;
  archive(leaves_out_unnamed, joins_equal, keeps_names);
}

/// All but the name and the source, which are the input's, and the products, which have a form of their own.
template <class A, Is<Scene> T>
void fields(A& archive, T& value) {
  auto& [name, draws, meshes, nodes, roots, skins, animations, materials, images, products, source, lists] = value;
  archive(draws, meshes, nodes, roots, skins, animations, materials, images, lists);
}

}  // namespace foredraw::archive
