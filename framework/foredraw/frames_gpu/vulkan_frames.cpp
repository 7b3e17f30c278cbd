#include <foredraw/frames_gpu/vulkan_frames.h>

#include <foredraw/frames/frame_moment.h>
#include <foredraw/frames/surface_shading.h>
#include <foredraw/frames_gpu/private/frame_target.h>
#include <foredraw/frames_gpu/private/surface_pipelines.h>
#include <foredraw/frames_gpu/private/uploaded_scene.h>
#include <foredraw/gpu/stopwatch.h>
#include <foredraw/viewing/posed_positions.h>

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

namespace foredraw {

namespace {

/// shaders/surface.vert, Object.
struct ObjectConstants {
  glm::vec4 x, y, w, eye_x, eye_y, eye_z, along_x, along_y, along_z;
};

/// shaders/surface.frag, Light.
struct LightConstants {
  glm::vec3 to_sun = frame_light.to_sun;
  float highlight = frame_light.highlight;
  glm::vec3 sun = frame_light.sun;
  float unlit = frame_light.unlit;
  glm::vec4 from_sky{frame_light.from_sky, 0}, from_ground{frame_light.from_ground, 0};
};

/// Where the camera sees what `world` places: in doubles until it is from the eye on.
ObjectConstants object_constants(const FrameCamera& camera, FrameSize size, const glm::dmat4& world) {
  const auto row = [&](const glm::dvec3& along) {
    glm::vec4 made;
    for (int c = 0; c < 3; ++c) made[c] = static_cast<float>(glm::dot(along, glm::dvec3(world[c])));
    made[3] = static_cast<float>(glm::dot(along, glm::dvec3(world[3]) - camera.eye));
    return made;
  };
  const double half_width = camera.half_height * size.width / size.height;
  const glm::dmat3 turn(world);
  glm::dmat3 cofactors(glm::cross(turn[1], turn[2]), glm::cross(turn[2], turn[0]), glm::cross(turn[0], turn[1]));
  if (glm::determinant(turn) < 0) cofactors = -cofactors;
  return {row(camera.right / half_width),
          row(-camera.up / camera.half_height),  // a framebuffer's y runs downwards
          row(camera.ahead),
          row({1, 0, 0}),
          row({0, 1, 0}),
          row({0, 0, 1}),
          glm::vec4(cofactors[0], 0),
          glm::vec4(cofactors[1], 0),
          glm::vec4(cofactors[2], 0)};
}

/// A draw at a level.
struct DrawCall {
  const UploadedDraw* draw;
  const UploadedLevel* level;
  const FrameSurface* surface;
  std::uint32_t number;  ///< of the object's constants
  SurfaceKind kind;
  std::array<VkDeviceSize, 2> posed_at{};  ///< positions and normals, where the object is posed
  bool is_posed = false;
};

/// What a frame needs on the device beside the scene.
struct FrameContents {
  std::vector<ObjectConstants> objects;
  std::vector<glm::vec3> posed;
  std::vector<DrawCall> calls;
};

/// Has room for so many bytes from here on.
void make_room(const gpu::Device& device, gpu::VisibleBuffer& buffer, std::size_t bytes, VkBufferUsageFlags usage) {
  if (buffer.get() != VK_NULL_HANDLE && buffer.as<std::byte>().size() >= bytes) return;
  buffer = gpu::VisibleBuffer();  // before the next is made
  buffer = gpu::VisibleBuffer(device, std::max<std::size_t>(bytes, 1024), usage);
}

}  // namespace

class VulkanFrames::Device {
 public:
  Device(const gpu::DeviceChoice& choice, const FrameScene& scene, FrameSize size, int samples)
      : scene_(scene),
        size_(size),
        device_(choice),
        target_(device_, size, samples),
        pipelines_(device_, target_.render_pass()),
        uploaded_(device_, scene, pipelines_.texture_layout()),
        sets_(device_, pipelines_.frame_layout(), 2, 1),
        set_(sets_.add()),
        light_(device_, std::as_bytes(std::span<const LightConstants>(std::array{LightConstants{}})),
               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT) {
    if (device_.timestamp_mask() == 0) {
      throw std::runtime_error(device_.name() + " has no clock to take times of frames by; choose another device");
    }
    run(FrameContents{}, 0);  // so that there is a picture
  }

  const gpu::Device& device() const { return device_; }
  FramePicture picture() { return target_.picture(device_); }

  double draw(const FrameMoment& moment, const FrameCamera& camera, std::span<const DrawnObject> objects) {
    FrameContents frame;
    for (const DrawnObject& object : objects) add_object(frame, moment, camera, object);
    for (std::size_t i = 0; i < objects.size(); ++i) add_calls(frame, moment, objects[i], i, false);
    for (std::size_t i = objects.size(); i-- > 0;) add_calls(frame, moment, objects[i], i, true);
    const std::size_t made = pipelines_.made();
    const auto near = static_cast<float>(camera.near);
    const double took = run(frame, near);
    return pipelines_.made() == made ? took : run(frame, near);
  }

 private:
  void add_object(FrameContents& frame, const FrameMoment& moment, const FrameCamera& camera,
                  const DrawnObject& drawn) const {
    const bool is_posed = scene_.objects()[drawn.object].is_posed;
    frame.objects.push_back(
        object_constants(camera, size_, is_posed ? glm::dmat4(1) : glm::dmat4(moment.world[drawn.object])));
  }

  void add_calls(FrameContents& frame, const FrameMoment& moment, const DrawnObject& drawn, std::size_t number,
                 bool is_blended) const {
    const PlacedObject& object = scene_.objects()[drawn.object];
    const FrameMesh& mesh = scene_.mesh_of(drawn.object);
    for (std::size_t d = 0; d < mesh.draws.size(); ++d) {
      const FrameDraw& draw = mesh.draws[d];
      const FrameSurface& surface = draw.surface;
      if ((surface.alpha_mode == AlphaMode::blend) != is_blended) continue;
      const UploadedDraw& uploaded = uploaded_.draws_of(object.mesh)[d];
      const std::size_t at = std::min<std::size_t>(drawn.level, draw.levels.size() - 1);
      const UploadedLevel& level = uploaded.levels[at];
      if (level.index_count == 0) continue;
      DrawCall call{&uploaded, &level, &surface, static_cast<std::uint32_t>(number)};
      call.kind = {drawn.rendering,
                   surface.alpha_mode,
                   surface.base != nullptr,
                   surface.normal_map != nullptr,
                   level.has_normals,
                   surface.is_double_sided,
                   is_mirrored(scene_, moment, drawn.object)};
      if (object.is_posed) {
        const Level& posed = scene_.scene().draws[draw.draw].levels[at];
        const VerticesInPose vertices = vertices_in_pose(scene_.scene(), *posed.vertices, object.node, moment.nodes);
        call.is_posed = true;
        call.posed_at = {append(frame.posed, vertices.positions), append(frame.posed, vertices.normals)};
      }
      frame.calls.push_back(call);
    }
  }

  static VkDeviceSize append(std::vector<glm::vec3>& to, const std::vector<glm::vec3>& values) {
    const std::size_t at = to.size() * sizeof(glm::vec3);
    to.insert(to.end(), values.begin(), values.end());
    return at;
  }

  /// Draws and gives nanoseconds.
  double run(const FrameContents& frame, float near) {
    put(frame);
    return gpu::nanoseconds(device_, [&](VkCommandBuffer commands) {
      target_.begin(commands);
      vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 0, 1, &set_, 0, nullptr);
      VkPipeline bound = VK_NULL_HANDLE;
      for (const DrawCall& call : frame.calls) {
        if (const VkPipeline pipeline = pipelines_.get(call.kind); pipeline != bound) {
          vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline);
          bound = pipeline;
        }
        record(commands, call, near);
      }
      vkCmdEndRenderPass(commands);
    });
  }

  void put(const FrameContents& frame) {
    const auto objects = std::as_bytes(std::span(frame.objects)), posed = std::as_bytes(std::span(frame.posed));
    if (objects.size() > device_.limits().maxStorageBufferRange) {
      throw std::runtime_error(device_.name() + " does not draw " + std::to_string(frame.objects.size()) +
                               " objects at once; choose another device");
    }
    make_room(device_, objects_, objects.size(), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
    make_room(device_, posed_, posed.size(), VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
    std::ranges::copy(objects, objects_.as<std::byte>().begin());
    std::ranges::copy(posed, posed_.as<std::byte>().begin());
    sets_.write(set_, std::array{objects_.get(), light_.get()});
  }

  void record(VkCommandBuffer commands, const DrawCall& call, float near) const {
    const FrameSurface& surface = *call.surface;
    const SurfaceConstants constants{surface.colour, surface.normal_scale, surface.alpha_cutoff, near};
    std::array<VkBuffer, inputs> buffers;
    buffers.fill(uploaded_.vertices());
    std::array<VkDeviceSize, inputs> offsets = call.level->vertices_at;
    if (call.is_posed) {
      buffers[positions_input] = buffers[normals_input] = posed_.get();
      offsets[positions_input] = call.posed_at[0];
      offsets[normals_input] = call.posed_at[call.kind.has_normals ? 1 : 0];
    }
    vkCmdPushConstants(commands, pipelines_.layout(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(constants), &constants);
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 1, 1, &call.draw->textures,
                            0, nullptr);
    vkCmdBindVertexBuffers(commands, 0, inputs, buffers.data(), offsets.data());
    vkCmdBindIndexBuffer(commands, uploaded_.indices(), call.level->indices_at, VK_INDEX_TYPE_UINT32);
    vkCmdDrawIndexed(commands, call.level->index_count, 1, 0, 0, call.number);
  }

  const FrameScene& scene_;
  FrameSize size_;
  gpu::Device device_;
  FrameTarget target_;
  SurfacePipelines pipelines_;
  UploadedScene uploaded_;
  gpu::StorageSets sets_;
  VkDescriptorSet set_;
  gpu::DeviceBuffer light_;
  gpu::VisibleBuffer objects_, posed_;
};

VulkanFrames::VulkanFrames(const gpu::DeviceChoice& choice, const FrameScene& scene, FrameSize size, int samples)
    : device_(std::make_unique<Device>(choice, scene, size, samples)) {}
VulkanFrames::VulkanFrames(VulkanFrames&&) noexcept = default;
VulkanFrames& VulkanFrames::operator=(VulkanFrames&&) noexcept = default;
VulkanFrames::~VulkanFrames() = default;

const std::string& VulkanFrames::device_name() const { return device_->device().name(); }

bool VulkanFrames::is_processor() const { return device_->device().is_processor(); }

double VulkanFrames::draw(const FrameMoment& moment, const FrameCamera& camera, std::span<const DrawnObject> objects) {
  return device_->draw(moment, camera, objects);
}

FramePicture VulkanFrames::picture() const { return device_->picture(); }

}  // namespace foredraw
