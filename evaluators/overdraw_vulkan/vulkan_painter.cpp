#include "vulkan_painter.h"

#include "clip_space.h"

namespace foredraw {

Pictures& VulkanPainter::pictures(int size) {
  if (pictures_ && pictures_->size() != static_cast<std::uint32_t>(size))
    pictures_.reset();  // before the next are made
  if (!pictures_) pictures_ = std::make_unique<Pictures>(device_, pipelines_.render_pass(), size);
  return *pictures_;
}

void VulkanPainter::draw(VkCommandBuffer commands, const UploadedParts& parts, const View& view,
                         const DrawManner& manner) {
  DrawConstants constants{clip_from_position(view), 0, manner.first_counter};
  for (std::uint32_t i = 0; i < parts.drawn.size(); ++i) {
    const UploadedParts::Part& part = parts.drawn[i];
    constants.owner = part.number;
    constants.counter = manner.first_counter + i;
    const VkBuffer vertices = parts.vertices.get();
    vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS,
                      pipelines_.get(manner.shading, manner.passing, part.culled));
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
