#include "pack_scene.h"

#include "packed_boxes.h"
#include "relief.h"
#include "vertex_pack.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <limits>
#include <map>
#include <sstream>
#include <stdexcept>

namespace foredraw::processors::vertex_pack {

namespace {

constexpr std::array<std::string_view, 4> packed_semantics = {"POSITION", "NORMAL", "TANGENT", "TEXCOORD_0"};
constexpr double texels = 4096;

const VertexStream* stream_of(const VertexStreams& vertices, std::string_view semantic, std::uint8_t components) {
  const VertexStream* stream = vertices.find(semantic);
  return stream != nullptr && stream->format.components >= components && stream->count() >= vertices.count ? stream
                                                                                                           : nullptr;
}

/// What there is to pack of a draw, over all its levels.
struct Content {
  bool normals = false, tangents = false, uvs = false;
  glm::dvec2 least_uv{std::numeric_limits<double>::infinity()}, most_uv{-std::numeric_limits<double>::infinity()};
  double uv_widths = 1;  ///< of the texture, for 1 of uv
  std::optional<Relief> relief = {};
  std::string why_not;  ///< empty: it can be packed

  /// In widths of the texture.
  glm::dvec2 uv_extent() const { return uvs ? (most_uv - least_uv) * uv_widths : glm::dvec2(0); }
};

bool has_finite_values(const VertexStream& stream, std::size_t count, std::size_t components) {
  for (std::size_t v = 0; v < count; ++v) {
    for (std::size_t c = 0; c < components; ++c) {
      if (!std::isfinite(decode_component(stream, v, c))) return false;
    }
  }
  return true;
}

void add_level(Content& content, const VertexStreams& vertices) {
  const VertexStream* positions = stream_of(vertices, "POSITION", 3);
  const VertexStream* uvs = stream_of(vertices, "TEXCOORD_0", 2);
  if (positions == nullptr) {
    content.why_not = "it has no positions";
  } else if (!has_finite_values(*positions, vertices.count, 3)) {
    content.why_not = "it has a position that is not finite";
  } else if (uvs != nullptr && !has_finite_values(*uvs, vertices.count, 2)) {
    content.why_not = "it has a texture coordinate that is not finite";
  }
  if (!content.why_not.empty()) return;
  content.normals |= stream_of(vertices, "NORMAL", 3) != nullptr;
  content.tangents |= content.normals && stream_of(vertices, "TANGENT", 4) != nullptr;
  if (uvs == nullptr) return;
  for (std::size_t v = 0; v < vertices.count; ++v) {
    const glm::dvec2 uv(decode_component(*uvs, v, 0), decode_component(*uvs, v, 1));
    content.least_uv = glm::min(content.least_uv, uv);
    content.most_uv = glm::max(content.most_uv, uv);
    content.uvs = true;
  }
}

std::vector<Content> contents_of(const Scene& scene, Analyses& analyses) {
  std::vector<Content> contents(scene.draws.size());
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    for (const Level& level : scene.draws[id].levels) add_level(contents[id], *level.vertices);
    contents[id].relief = relief_of(scene, id, analyses);
    contents[id].uv_widths = packed_uv_widths(scene, id);
    if (scene.draws[id].full().vertices->count == 0) contents[id].why_not = "it has no vertices";
  }
  return contents;
}

/// Layouts of draws that share a lattice, each with the uv lattice of its own.
class Layouts {
 public:
  Layouts(std::vector<Content>& contents, const PackOptions& options) : contents_(contents), options_(options) {}

  /// `scales`: how many units of the box one of the draw's is; 1 where it is not named. Draws that can not be packed
  /// after all are told so in their content.
  std::map<DrawId, PackedLayout> of(std::vector<DrawId> draws, const Box<glm::dvec3>& box,
                                    const std::map<DrawId, double>& scales = {}) {
    for (;;) {
      for (const DrawId id : draws) {
        if (contents_[id].why_not.empty()) contents_[id].why_not = why_never(contents_[id]);
      }
      std::erase_if(draws, [&](DrawId id) { return !contents_[id].why_not.empty(); });
      const std::size_t count = draws.size();
      std::map<DrawId, PackedLayout> layouts = all(draws, box, scales);
      std::erase_if(draws, [&](DrawId id) { return !contents_[id].why_not.empty(); });
      if (draws.size() == count) return layouts;
    }
  }

 private:
  std::map<DrawId, PackedLayout> all(const std::vector<DrawId>& draws, const Box<glm::dvec3>& box,
                                     const std::map<DrawId, double>& scales) {
    std::map<DrawId, PackedLayout> layouts;
    if (draws.empty()) return layouts;
    if (box.is_empty()) {
      for (const DrawId id : draws) contents_[id].why_not = "in no pose is any of its positions finite";
      return layouts;
    }
    const auto shared = best_layout(demand_of(draws, box, scales));
    for (const DrawId id : draws) {
      if (!shared) {
        contents_[id].why_not =
            "no layout of 128 bits holds its box and keeps directions and texture coordinates within their limits";
        continue;
      }
      PackedLayout layout = *shared;
      if (contents_[id].why_not = why_no_uvs(layout, contents_[id]); contents_[id].why_not.empty()) {
        layouts.emplace(id, layout);
      }
    }
    return layouts;
  }

  Demand demand_of(const std::vector<DrawId>& draws, const Box<glm::dvec3>& box,
                   const std::map<DrawId, double>& scales) const {
    std::optional<double> displacement, slope;
    for (const DrawId id : draws) {
      const std::optional<Relief>& relief = contents_[id].relief;
      if (!relief) continue;
      const auto scale = scales.find(id);
      const double units = scale == scales.end() ? 1 : scale->second;
      displacement = std::max(displacement.value_or(0), units * relief->displacement);
      if (relief->slope) slope = std::max(slope.value_or(0), units * *relief->slope / contents_[id].uv_widths);
    }
    const auto chosen = [&](const std::optional<double>& option, const std::optional<double>& said, double usual) {
      return option || !said ? option.value_or(usual) * box.diagonal() : *said;
    };
    Demand demand{.box = box,
                  .displacement = chosen(options_.displacement, displacement, usual_displacement),
                  .slope = chosen(options_.slope, slope, usual_slope),
                  .most_angle_error = options_.most_angle_error,
                  .most_uv_error = options_.most_uv_error / texels,
                  .is_spherical = options_.method == NormalMethod::spherical};
    for (const DrawId id : draws) {
      demand.normals |= contents_[id].normals;
      demand.tangents |= contents_[id].tangents;
      demand.uvs |= contents_[id].uvs;
      demand.uv_extent = glm::max(demand.uv_extent, contents_[id].uv_extent());
    }
    return demand;
  }

  /// Of texture coordinates for which no number of bits is enough.
  std::string why_never(const Content& content) const {
    PackedLayout finest{};
    finest.field[FOREDRAW_PACKED_U].bits = finest.field[FOREDRAW_PACKED_V].bits = most_uv_bits;
    return why_no_uvs(finest, content);
  }

  /// Gives the layout the draw's uv lattice.
  std::string why_no_uvs(PackedLayout& layout, const Content& content) const {
    if (layout.field[FOREDRAW_PACKED_U].bits == 0) return {};
    if (!content.uvs) return set_uv_lattice(layout, glm::dvec2(0), glm::dvec2(1)), std::string();
    if (!set_uv_lattice(layout, content.least_uv, content.most_uv)) return "its texture coordinates are too large";
    const double error = packed_bounds(layout).uv() * content.uv_widths * texels;
    if (error <= options_.most_uv_error) return {};
    std::ostringstream why;
    why << "its texture coordinates are too far apart: they would be off by up to " << std::setprecision(3) << error
        << " texels of 4096; bring them into 0 to 1, or raise most-uv-error";
    return why.str();
  }

  std::vector<Content>& contents_;
  const PackOptions& options_;
};

Box<glm::dvec3> with_margin(Box<glm::dvec3> box, double margin) {
  const glm::dvec3 around = box.extent() * margin;
  box.min -= around;
  box.max += around;
  return box;
}

std::string plain_streams(const Draw& draw) {
  std::string names;
  for (const VertexStream& stream : draw.full().vertices->base) {
    if (std::ranges::find(packed_semantics, stream.semantic) == packed_semantics.end()) {
      names += (names.empty() ? "" : ", ") + stream.semantic;
    }
  }
  if (!draw.full().vertices->morph_targets.empty()) names += names.empty() ? "morph targets" : ", morph targets";
  return names;
}

void pack_levels(PackedDraw& made, const Draw& draw) {
  double skew = 0;
  for (std::size_t l = 0; l < draw.levels.size(); ++l) {
    const VertexStreams& vertices = *draw.levels[l].vertices;
    if (l > 0 && draw.levels[l].vertices == draw.levels[l - 1].vertices) {
      made.packed.rows.push_back(made.packed.rows.back());
      continue;
    }
    PackedStreams packed = pack_streams(made.packed.layout, vertices);
    const std::string broken = broken_promise(vertices, made.packed.layout, packed.rows);
    const bool is_outside = (packed.told & (FOREDRAW_PACKED_POSITION_OUTSIDE | FOREDRAW_PACKED_UV_OUTSIDE)) != 0;
    if (!broken.empty() || is_outside) {
      throw std::logic_error("a packed vertex of " + draw.name + ' ' +
                             (broken.empty() ? "lies outside of its lattice" : broken));
    }
    const PackedErrors errors = packed_errors(vertices, made.packed.layout, packed.rows);
    skew = std::max(skew, errors.skew);
    made.no_direction += errors.no_direction;
    made.packed.rows.emplace_back(std::move(packed.rows));
  }
  made.bounds = packed_bounds(made.packed.layout, skew);
  made.plain = plain_streams(draw);
}

}  // namespace

PackedScene pack_scene(const Scene& scene, std::span<const DrawId> draws, SubjectUnit unit, const Poses& poses,
                       const PackOptions& options, Analyses& analyses, const Executor& executor) {
  std::vector<Content> contents = contents_of(scene, analyses);
  const std::vector<Subject> subjects = subjects_of(scene, unit);
  std::vector<PackedDraw> all(scene.draws.size());
  Layouts layouts(contents, options);
  for (const std::vector<DrawId>& group : stored_groups(scene, subjects)) {
    const Box<glm::dvec3> box = stored_box(scene, group);
    for (const auto& [id, layout] : layouts.of(group, box)) {
      all[id].packed = {.draw = id, .layout = layout};
      all[id].diagonal = box.diagonal();
    }
  }
  const std::vector<std::vector<SubjectPart>> moved = posed_groups(scene, subjects);
  const std::vector<Box<glm::dvec3>> boxes = posed_boxes(scene, moved, poses, executor);
  for (std::size_t g = 0; g < moved.size(); ++g) {
    std::vector<DrawId> group;
    std::map<DrawId, double> scales;
    for (const SubjectPart& part : moved[g]) {
      group.push_back(part.draw);
      double& scale = scales[part.draw];
      scale = std::max(scale, rest_scale(scene, part));
    }
    std::ranges::sort(group);
    group.erase(std::unique(group.begin(), group.end()), group.end());
    for (const auto& [id, layout] : layouts.of(group, with_margin(boxes[g], options.margin), scales)) {
      all[id].packed.posed = layout;
      all[id].posed_diagonal = boxes[g].diagonal();
    }
  }
  PackedScene result;
  for (const DrawId id : draws) {
    if (contents[id].why_not.empty()) {
      result.draws.push_back(std::move(all[id]));
    } else {
      result.left_out.push_back({id, contents[id].why_not});
    }
  }
  executor.for_each(result.draws.size(),
                    [&](std::size_t i) { pack_levels(result.draws[i], scene.draws[result.draws[i].packed.draw]); });
  return result;
}

}  // namespace foredraw::processors::vertex_pack
