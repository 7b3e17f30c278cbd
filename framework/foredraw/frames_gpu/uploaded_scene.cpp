#include <foredraw/frames_gpu/private/uploaded_scene.h>

#include <foredraw/geometry/finite.h>

#include <algorithm>
#include <limits>
#include <stdexcept>

namespace foredraw {

namespace {

constexpr std::uint32_t textures_of_a_surface = 2;

/// Values one behind the other, on their way to the device.
struct Bytes {
  std::vector<std::byte> all;

  template <class T>
  VkDeviceSize append(std::span<const T> values) {
    const VkDeviceSize at = all.size();
    const auto bytes = std::as_bytes(values);
    all.insert(all.end(), bytes.begin(), bytes.end());
    return at;
  }
};

/// Of surfaces with an image, zeros where the level has no places; of others nothing is read.
VkDeviceSize append_places(Bytes& to, const std::vector<glm::vec2>& places, bool has_image, const FrameLevel& level,
                           VkDeviceSize anywhere) {
  if (!has_image) return anywhere;
  if (!places.empty()) return to.append(std::span(places).first(level.vertices));
  return to.append(std::span<const glm::vec2>(std::vector<glm::vec2>(level.vertices)));
}

UploadedLevel uploaded_level(const FrameLevel& level, const FrameSurface& surface, Bytes& vertices, Bytes& indices) {
  UploadedLevel made;
  const std::span<const glm::vec3> positions = level.positions->values;
  const VkDeviceSize anywhere = vertices.append(positions.first(level.vertices));
  made.has_normals = !level.normals.empty();
  made.vertices_at[positions_input] = anywhere;
  made.vertices_at[normals_input] =
      made.has_normals ? vertices.append(std::span(level.normals).first(level.vertices)) : anywhere;
  made.vertices_at[base_places_input] =
      append_places(vertices, level.base_places, surface.base != nullptr, level, anywhere);
  made.vertices_at[normal_map_places_input] =
      append_places(vertices, level.normal_map_places, surface.normal_map != nullptr, level, anywhere);

  std::vector<std::uint32_t> finite;
  for (std::size_t i = 0; i + 2 < level.indices.size(); i += 3) {
    const std::span<const std::uint32_t> triangle = level.indices.subspan(i, 3);
    const auto is_there = [&](std::uint32_t v) { return is_finite(positions[v]); };
    if (std::ranges::all_of(triangle, is_there)) finite.insert(finite.end(), triangle.begin(), triangle.end());
  }
  if (finite.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw std::runtime_error("frames are drawn by Vulkan with fewer than 2^32 indices at once; split the mesh");
  }
  made.indices_at = indices.append(std::span<const std::uint32_t>(finite));
  made.index_count = static_cast<std::uint32_t>(finite.size());
  return made;
}

std::size_t draws_in(const FrameScene& scene) {
  std::map<MeshId, std::size_t> draws;
  for (std::size_t i = 0; i < scene.objects().size(); ++i) {
    draws[scene.objects()[i].mesh] = scene.mesh_of(i).draws.size();
  }
  std::size_t sum = 0;
  for (const auto& [mesh, count] : draws) sum += count;
  return sum;
}

gpu::Texture uploaded_image(gpu::Device& device, const MippedImage& image) {
  std::vector<gpu::TextureLevel> levels;
  for (const MippedImage::MipLevel& level : image.levels) {
    levels.push_back({static_cast<std::uint32_t>(level.width), static_cast<std::uint32_t>(level.height),
                      std::as_bytes(std::span(level.texels))});
  }
  return {device, levels};
}

VkSamplerAddressMode address_mode(Wrap wrap) {
  switch (wrap) {
    case Wrap::repeat: return VK_SAMPLER_ADDRESS_MODE_REPEAT;
    case Wrap::mirrored: return VK_SAMPLER_ADDRESS_MODE_MIRRORED_REPEAT;
    case Wrap::clamped: break;
  }
  return VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
}

}  // namespace

UploadedScene::UploadedScene(gpu::Device& device, const FrameScene& scene, VkDescriptorSetLayout texture_layout)
    : sets_(device, texture_layout, textures_of_a_surface, draws_in(scene)), meshes_(scene.scene().meshes.size()) {
  Bytes vertices, indices;
  for (std::size_t i = 0; i < scene.objects().size(); ++i) {
    std::vector<UploadedDraw>& draws = meshes_[scene.objects()[i].mesh];
    if (!draws.empty()) continue;
    for (const FrameDraw& draw : scene.mesh_of(i).draws) {
      draws.push_back({{}, uploaded(device, draw.surface)});
      for (const FrameLevel& level : draw.levels) {
        draws.back().levels.push_back(uploaded_level(level, draw.surface, vertices, indices));
      }
    }
  }
  vertices_ = gpu::DeviceBuffer(device, vertices.all, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  indices_ = gpu::DeviceBuffer(device, indices.all, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
}

VkDescriptorSet UploadedScene::uploaded(gpu::Device& device, const FrameSurface& surface) {
  const VkDescriptorSet set = sets_.add();
  sets_.write(set, std::array{sampled_texture(device, surface.base.get(), surface.base_sampling),
                              sampled_texture(device, surface.normal_map.get(), surface.normal_map_sampling)});
  return set;
}

gpu::SampledTexture UploadedScene::sampled_texture(gpu::Device& device, const MippedImage* image,
                                                   const Sampling& sampling) {
  auto texture = textures_.find(image);
  if (texture == textures_.end()) {
    const MippedImage white{{{1, 1, {{255, 255, 255, 255}}}}};
    texture = textures_.emplace(image, uploaded_image(device, image != nullptr ? *image : white)).first;
  }
  gpu::OwnedSampler& sampler = samplers_[{sampling.wrap[0], sampling.wrap[1], sampling.is_nearest}];
  if (sampler.get() == VK_NULL_HANDLE) {
    sampler = gpu::make_sampler(device, sampling.is_nearest ? VK_FILTER_NEAREST : VK_FILTER_LINEAR,
                                address_mode(sampling.wrap[0]), address_mode(sampling.wrap[1]));
  }
  return {texture->second.view(), sampler.get()};
}

}  // namespace foredraw
