#include "vulkan_painter.h"

#include <foredraw/gpu/clip_space.h>

namespace foredraw {

gpu::Pictures& VulkanPainter::pictures(int size) {
  if (pictures_ && pictures_->size() != static_cast<std::uint32_t>(size))
    pictures_.reset();  // before the next are made
  if (!pictures_) pictures_ = std::make_unique<gpu::Pictures>(device_, pipelines_.render_pass(), size);
  return *pictures_;
}

UploadedParts VulkanPainter::uploaded(std::span<const RasterPart> parts) {
  UploadedParts made(device_, parts);
  if (made.texels.get() != VK_NULL_HANDLE) pipelines_.put_texels(made.texels.get());
  return made;
}

void VulkanPainter::draw(VkCommandBuffer commands, const UploadedParts& parts, const View& view,
                         const DrawManner& manner) {
  DrawConstants constants{};
  constants.clip_from_position = gpu::clip_from_position(view);
  if (parts.texels.get() != VK_NULL_HANDLE) {
    const VkDescriptorSet texels = pipelines_.texels();
    vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.layout(), 0, 1, &texels, 0, nullptr);
  }
  for (std::uint32_t i = 0; i < parts.drawn.size(); ++i) {
    const UploadedParts::Part& part = parts.drawn[i];
    constants.owner = part.number;
    if (const auto& holes = part.holes) {
      constants.holes = holes->constants;
      const VkBuffer places = parts.places.get();
      vkCmdBindVertexBuffers(commands, 1, 1, &places, &holes->places_at);
    }
    const VkBuffer vertices = parts.vertices.get();
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipelines_.get(manner.shading, manner.passing, part));
    vkCmdPushConstants(commands, pipelines_.layout(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0,
                       sizeof(constants), &constants);
    vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &part.vertices_at);
    vkCmdBindIndexBuffer(commands, parts.indices.get(), part.indices_at, VK_INDEX_TYPE_UINT32);
    manner.before(i);
    vkCmdDrawIndexed(commands, part.index_count, 1, 0, 0, 0);
    manner.after(i);
  }
}

}  // namespace foredraw
