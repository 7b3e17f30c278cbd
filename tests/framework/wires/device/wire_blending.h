#pragma once
// Wires blended into a picture as an engine blends them: opaque fragments first, and what is faded behind them without
// writing depth. On the device by the shaders' own fragments, and the same by wire_radius.h.

#include "wire_drawing.h"

#include <glm/vec3.hpp>

namespace foredraw::testing {

/// Where nothing is drawn; a wire is white where all of its own light is shown, and black where none is.
inline constexpr glm::vec3 wire_ground{0.2f, 0.4f, 0.8f};

/// Pictures of eight bits a channel, three of them a pixel, rows from the top.
class BlendedWires {
 public:
  BlendedWires(gpu::Device& device, int samples)
      : device_(device),
        samples_(samples),
        pass_(device.get(), PassOf(device, samples).info, "vkCreateRenderPass"),
        pixels_(device, samples, format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, VK_IMAGE_ASPECT_COLOR_BIT),
        resolved_(device, 1, format, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT,
                  VK_IMAGE_ASPECT_COLOR_BIT),
        depths_(device, samples, device.depth_format(), VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT,
                VK_IMAGE_ASPECT_DEPTH_BIT) {
    const std::array several = {pixels_.view.get(), depths_.view.get(), resolved_.view.get()};
    const std::array one = {resolved_.view.get(), depths_.view.get()};
    const std::span<const VkImageView> views =
        samples > 1 ? std::span<const VkImageView>(several) : std::span<const VkImageView>(one);
    const VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO,
                                       .renderPass = pass_.get(),
                                       .attachmentCount = static_cast<std::uint32_t>(views.size()),
                                       .pAttachments = views.data(),
                                       .width = wire_picture,
                                       .height = wire_picture,
                                       .layers = 1};
    framebuffer_ = gpu::OwnedFramebuffer(device.get(), info, "vkCreateFramebuffer");
    layout_ = pipeline_layout(device, {}, stages, sizeof(WireFrame));
  }

  std::vector<std::uint8_t> drawn(const ThinMesh& mesh, const WireFrame& frame, bool covers, ShaderLanguage language) {
    const gpu::OwnedPipeline opaque = pipeline(covers, language, false), faded = pipeline(covers, language, true);
    const auto positions = filled(mesh.positions), wires = filled(mesh.wires), axes = filled(mesh.axes);
    const gpu::VisibleBuffer indices = filled(mesh.indices, VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
    const std::size_t count = std::size_t{wire_picture} * wire_picture;
    const gpu::VisibleBuffer result(device_, 4 * count, VK_BUFFER_USAGE_TRANSFER_DST_BIT);
    device_.run([&](VkCommandBuffer commands) {
      const VkRect2D whole{{0, 0}, {wire_picture, wire_picture}};
      std::array<VkClearValue, 2> empty{};
      for (int c = 0; c < 3; ++c) empty[0].color.float32[c] = wire_ground[c];
      empty[1].depthStencil.depth = 1;
      const VkRenderPassBeginInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO,
                                       .renderPass = pass_.get(),
                                       .framebuffer = framebuffer_.get(),
                                       .renderArea = whole,
                                       .clearValueCount = empty.size(),
                                       .pClearValues = empty.data()};
      vkCmdBeginRenderPass(commands, &info, VK_SUBPASS_CONTENTS_INLINE);
      const VkViewport viewport{0, 0, wire_picture, wire_picture, 0, 1};
      vkCmdSetViewport(commands, 0, 1, &viewport);
      vkCmdSetScissor(commands, 0, 1, &whole);
      vkCmdPushConstants(commands, layout_.get(), stages, 0, sizeof(frame), &frame);
      const std::array buffers = {positions.get(), wires.get(), axes.get()};
      const std::array<VkDeviceSize, 3> offsets{};
      vkCmdBindVertexBuffers(commands, 0, buffers.size(), buffers.data(), offsets.data());
      vkCmdBindIndexBuffer(commands, indices.get(), 0, VK_INDEX_TYPE_UINT32);
      for (const VkPipeline now : {opaque.get(), faded.get()}) {
        vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, now);
        vkCmdDrawIndexed(commands, static_cast<std::uint32_t>(mesh.indices.size()), 1, 0, 0, 0);
      }
      vkCmdEndRenderPass(commands);
      VkBufferImageCopy copy{};
      copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
      copy.imageExtent = {wire_picture, wire_picture, 1};
      vkCmdCopyImageToBuffer(commands, resolved_.image.get(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, result.get(), 1,
                             &copy);
      gpu::let_see(commands, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                   VK_ACCESS_HOST_READ_BIT);
    });
    const auto bytes = result.as<std::uint8_t>();
    std::vector<std::uint8_t> picture;
    for (std::size_t i = 0; i < 4 * count; ++i) {
      if (i % 4 != 3) picture.push_back(bytes[i]);
    }
    return picture;
  }

 private:
  static constexpr VkFormat format = VK_FORMAT_R8G8B8A8_UNORM;
  static constexpr VkShaderStageFlags stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

  /// What stays is at the end: the resolved pixels, or with one sample a pixel the pixels themselves.
  struct PassOf {
    std::array<VkAttachmentDescription, 3> attachments;
    VkAttachmentReference pixels{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkAttachmentReference depths{1, VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
    VkAttachmentReference resolved{2, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass{};
    VkSubpassDependency copied{};
    VkRenderPassCreateInfo info{};

    PassOf(const gpu::Device& device, int samples) {
      const auto count = static_cast<VkSampleCountFlagBits>(samples);
      attachments[0] = {
          .format = format,
          .samples = count,
          .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
          .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
          .finalLayout = samples > 1 ? VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL : VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
      attachments[1] = {.format = device.depth_format(),
                        .samples = count,
                        .loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR,
                        .storeOp = VK_ATTACHMENT_STORE_OP_DONT_CARE,
                        .finalLayout = VK_IMAGE_LAYOUT_DEPTH_STENCIL_ATTACHMENT_OPTIMAL};
      attachments[2] = {.format = format,
                        .samples = VK_SAMPLE_COUNT_1_BIT,
                        .loadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE,
                        .storeOp = VK_ATTACHMENT_STORE_OP_STORE,
                        .finalLayout = VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};
      subpass = {.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS,
                 .colorAttachmentCount = 1,
                 .pColorAttachments = &pixels,
                 .pResolveAttachments = samples > 1 ? &resolved : nullptr,
                 .pDepthStencilAttachment = &depths};
      copied = {.srcSubpass = 0,
                .dstSubpass = VK_SUBPASS_EXTERNAL,
                .srcStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT,
                .dstStageMask = VK_PIPELINE_STAGE_TRANSFER_BIT,
                .srcAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT,
                .dstAccessMask = VK_ACCESS_TRANSFER_READ_BIT};
      info = {.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO,
              .attachmentCount = samples > 1 ? 3u : 2u,
              .pAttachments = attachments.data(),
              .subpassCount = 1,
              .pSubpasses = &subpass,
              .dependencyCount = 1,
              .pDependencies = &copied};
    }
    PassOf(const PassOf&) = delete;
    PassOf& operator=(const PassOf&) = delete;
  };

  struct Attachment {
    gpu::OwnedMemory memory;
    gpu::OwnedImage image;
    gpu::OwnedImageView view;

    Attachment(const gpu::Device& device, int samples, VkFormat format, VkImageUsageFlags usage,
               VkImageAspectFlags aspect) {
      const VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO,
                                   .imageType = VK_IMAGE_TYPE_2D,
                                   .format = format,
                                   .extent = {wire_picture, wire_picture, 1},
                                   .mipLevels = 1,
                                   .arrayLayers = 1,
                                   .samples = static_cast<VkSampleCountFlagBits>(samples),
                                   .tiling = VK_IMAGE_TILING_OPTIMAL,
                                   .usage = usage};
      image = gpu::OwnedImage(device.get(), info, "vkCreateImage");
      VkMemoryRequirements wants;
      vkGetImageMemoryRequirements(device.get(), image.get(), &wants);
      memory = device.allocated(wants, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
      gpu::check(vkBindImageMemory(device.get(), image.get(), memory.get(), 0), "vkBindImageMemory");
      const VkImageViewCreateInfo seen{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO,
                                       .image = image.get(),
                                       .viewType = VK_IMAGE_VIEW_TYPE_2D,
                                       .format = format,
                                       .subresourceRange = {aspect, 0, 1, 0, 1}};
      view = gpu::OwnedImageView(device.get(), seen, "vkCreateImageView");
    }
  };

  /// Both stages in one language.
  gpu::OwnedPipeline pipeline(bool covers, ShaderLanguage language, bool is_faded) const {
    const std::string text = std::string(covers ? "#define WIRE_COVERAGE\n" : "") + "#define WIRE_SAMPLES " +
                             std::to_string(samples_) + "\n#define WIRE_VULKAN\n" +
                             (is_faded ? "#define WIRE_FADED\n" : "#define WIRE_OPAQUE\n") + wire_shader_text(language);
    const gpu::OwnedShader vertices =
        make_shader(device_, compiled_shader("#define WIRE_VERTEX\n" + text, language, "vert"));
    const gpu::OwnedShader fragments =
        make_shader(device_, compiled_shader("#define WIRE_FRAGMENT\n" + text, language, "frag"));
    const std::array inputs = {gpu::VertexInput{0, 0, sizeof(glm::vec3), VK_FORMAT_R32G32B32_SFLOAT},
                               gpu::VertexInput{1, 1, sizeof(glm::vec4), VK_FORMAT_R32G32B32A32_SFLOAT},
                               gpu::VertexInput{2, 2, sizeof(glm::vec4), VK_FORMAT_R32G32B32A32_SFLOAT}};
    gpu::PipelineState state;
    state.layout = layout_.get();
    state.render_pass = pass_.get();
    state.vertex_shader = vertices.get();
    state.fragment_shader = fragments.get();
    state.inputs = inputs;
    state.samples = static_cast<VkSampleCountFlagBits>(samples_);
    state.culled = VK_CULL_MODE_NONE;
    state.writes_depth = !is_faded;
    state.blends = is_faded;
    state.written = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT;
    return graphics_pipeline(device_, state);
  }

  template <class T>
  gpu::VisibleBuffer filled(const std::vector<T>& content,
                            VkBufferUsageFlags usage = VK_BUFFER_USAGE_VERTEX_BUFFER_BIT) const {
    gpu::VisibleBuffer buffer(device_, content.size() * sizeof(T), usage);
    std::ranges::copy(content, buffer.as<T>().begin());
    return buffer;
  }

  gpu::Device& device_;
  int samples_;
  gpu::OwnedRenderPass pass_;
  Attachment pixels_, resolved_, depths_;
  gpu::OwnedFramebuffer framebuffer_;
  gpu::OwnedPipelineLayout layout_;
};

/// The same by the C arithmetic; the mean of samples is not rounded.
inline std::vector<float> blended(const ThinMesh& mesh, const WireFrame& frame, bool covers, int samples) {
  const std::size_t pixels = std::size_t{wire_picture} * wire_picture;
  std::vector<glm::vec3> colours(pixels * static_cast<std::size_t>(samples), wire_ground);
  std::vector<double> depths(colours.size(), 1);
  for (const bool is_faded : {false, true}) {
    for_each_covered_sample(mesh, frame, covers, samples, [&](std::size_t sample, const WireFragment& fragment) {
      if ((fragment.alpha < 1) != is_faded || !(fragment.depth < depths[sample])) return;
      colours[sample] = colours[sample] * (1 - fragment.alpha) + glm::vec3(fragment.lit) * fragment.alpha;
      if (!is_faded) depths[sample] = fragment.depth;
    });
  }
  std::vector<float> picture(3 * pixels, 0);
  for (std::size_t i = 0; i < colours.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      picture[3 * (i / static_cast<std::size_t>(samples)) + c] +=
          255 * colours[i][static_cast<int>(c)] / static_cast<float>(samples);
    }
  }
  return picture;
}

}  // namespace foredraw::testing
