#include <foredraw/viewing/draw_mask.h>

#include <foredraw/image/texture_uv.h>

#include <algorithm>

namespace foredraw {

namespace {

/// The base colour's, times the vertices' colour's.
std::vector<double> alphas_of(const VertexStreams& vertices, double factor) {
  std::vector<double> alphas(vertices.count, factor);
  const VertexStream* colours = vertices.find("COLOR_0");
  if (colours == nullptr || colours->format.components < 4) return alphas;
  for (std::size_t v = 0; v < alphas.size(); ++v) alphas[v] *= decode_component(*colours, v, 3);
  return alphas;
}

}  // namespace

std::variant<std::shared_ptr<const Mask>, std::string> mask_of(Analyses& analyses, const Scene& scene,
                                                               const Draw& draw) {
  const Material* material = scene.material_of(draw);
  if (material == nullptr || material->alpha_mode != AlphaMode::mask || draw.levels.empty())
    return std::shared_ptr<const Mask>();
  const VertexStreams& vertices = *draw.full().vertices;
  auto mask = std::make_shared<Mask>();
  mask->cutoff = material->alpha_cutoff;
  mask->alphas = alphas_of(vertices, material->alpha);
  if (const auto& texture = material->base_colour) {
    if (!texture->image || *texture->image >= scene.images.size()) return "its texture has no image of a known kind";
    const VertexStream* texcoords = vertices.find("TEXCOORD_" + std::to_string(texture->texcoord));
    if (texcoords == nullptr || texcoords->count() < vertices.count) {
      return "it has no TEXCOORD_" + std::to_string(texture->texcoord);
    }
    auto decoded = alpha_image_of(analyses, scene.images[*texture->image]);
    if (std::string* why = std::get_if<std::string>(&decoded)) return std::move(*why);
    mask->image = std::move(std::get<std::shared_ptr<const AlphaImage>>(decoded));
    mask->sampling = {texture->wrap, texture->is_nearest};
    mask->uv = texture_uv(*texcoords, *texture);
  }
  const auto is_full = [](std::uint16_t alpha) { return alpha == 65535; };
  const bool has_holes = (mask->image && !std::ranges::all_of(mask->image->alpha, is_full)) ||
                         std::ranges::any_of(mask->alphas, [&](double alpha) { return !(alpha >= mask->cutoff); });
  if (!has_holes) return std::shared_ptr<const Mask>();
  return std::shared_ptr<const Mask>(std::move(mask));
}

}  // namespace foredraw
