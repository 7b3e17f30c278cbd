#include <foredraw/analysis/draw_mask.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace foredraw {

namespace {

/// What alphas_of() keeps: an image's alpha, or why there is none.
struct DecodedAlpha {
  std::shared_ptr<const AlphaImage> image;
  std::string why_not;
};

template <class T>
T channel(const Texels& texels, std::size_t at) {
  T value;
  std::memcpy(&value, texels.bytes.data() + at * sizeof(T), sizeof(T));
  return value;
}

std::uint16_t alpha_of(const Texels& texels, std::size_t at) {
  if (texels.facts.bits == 8) return static_cast<std::uint16_t>(257 * channel<std::uint8_t>(texels, at));
  if (texels.facts.bits == 16) return channel<std::uint16_t>(texels, at);
  const float value = channel<float>(texels, at);
  return static_cast<std::uint16_t>(value > 0 ? std::min(1.0f, value) * 65535.0f + 0.5f : 0.0f);
}

AlphaImage alpha_image(const Texels& texels) {
  const ImageFacts& facts = texels.facts;
  AlphaImage image{facts.width, facts.height, {}};
  const auto channels = static_cast<std::size_t>(facts.channels);
  const std::size_t count = std::size_t{facts.width} * facts.height;
  if (channels % 2 == 1) {
    image.alpha.assign(count, 65535);
    return image;
  }
  image.alpha.reserve(count);
  for (std::size_t i = 0; i < count; ++i) image.alpha.push_back(alpha_of(texels, (i + 1) * channels - 1));
  return image;
}

/// By its bytes, or by where they lie.
std::shared_ptr<const DecodedAlpha> alphas_of(Analyses& analyses, const Image& image) {
  const Stamp parts[] = {image.bytes.stamp(), content_hash(std::span<const char>(image.uri))};
  return analyses.get<DecodedAlpha>(combine(parts), [&]() -> DecodedAlpha {
    const auto decoded = analyses.decode(image);
    if (const std::string* why = std::get_if<std::string>(&decoded)) return {nullptr, *why};
    return {std::make_shared<const AlphaImage>(alpha_image(std::get<Texels>(decoded))), {}};
  });
}

struct Turn {
  double sine, cosine;
};

/// By their series, because what a library says may depend on the processor in the last bit.
Turn turn_by(double angle) {
  constexpr double circle = 6.283185307179586;
  if (!std::isfinite(angle)) return {0, 1};
  const double x = angle - circle * std::floor(angle / circle + 0.5);
  Turn turn{0, 0};
  double term = 1;
  for (int n = 0; n < 40; ++n) {  // x is below 4
    double& sum = n % 2 == 0 ? turn.cosine : turn.sine;
    sum += n % 4 < 2 ? term : -term;
    term *= x / (n + 1);
  }
  return turn;
}

std::vector<glm::dvec2> places_of(const VertexStream& texcoords, const Texture& texture) {
  const Turn turn = turn_by(texture.rotation);
  std::vector<glm::dvec2> places;
  for (const glm::vec3& texcoord : decode_vec3(texcoords)) {
    const glm::dvec2 scaled = texture.scale * glm::dvec2(texcoord);
    places.push_back(texture.offset + glm::dvec2(turn.cosine * scaled.x + turn.sine * scaled.y,
                                                 turn.cosine * scaled.y - turn.sine * scaled.x));
  }
  return places;
}

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
  if (material == nullptr || material->alpha_mode != AlphaMode::mask || draw.levels.empty()) return std::shared_ptr<const Mask>();
  const VertexStreams& vertices = *draw.levels[0].vertices;
  auto mask = std::make_shared<Mask>();
  mask->cutoff = material->alpha_cutoff;
  mask->alphas = alphas_of(vertices, material->alpha);
  if (const auto& texture = material->base_colour) {
    if (!texture->image || *texture->image >= scene.images.size()) return "its texture is of an unknown kind";
    const VertexStream* texcoords = vertices.find("TEXCOORD_" + std::to_string(texture->texcoord));
    if (texcoords == nullptr || texcoords->count() < vertices.count) {
      return "it has no TEXCOORD_" + std::to_string(texture->texcoord);
    }
    const auto decoded = alphas_of(analyses, scene.images[*texture->image]);
    if (!decoded->image) return decoded->why_not;
    mask->image = decoded->image;
    mask->wrap = texture->wrap;
    mask->is_nearest = texture->is_nearest;
    mask->places = places_of(*texcoords, *texture);
  }
  const auto is_full = [](std::uint16_t alpha) { return alpha == 65535; };
  const bool has_holes = (mask->image && !std::ranges::all_of(mask->image->alpha, is_full)) ||
                         std::ranges::any_of(mask->alphas, [&](double alpha) { return !(alpha >= mask->cutoff); });
  if (!has_holes) return std::shared_ptr<const Mask>();
  return std::shared_ptr<const Mask>(std::move(mask));
}

}  // namespace foredraw
