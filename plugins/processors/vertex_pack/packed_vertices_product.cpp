#include "packed_vertices_product.h"

#include "schemas.h"

#include <foredraw/packing/packed_precision.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/moves.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

/// As the rest of a sentence; empty: the rows are those of the draw's vertices.
std::string wrong_with(const PackedVertices::OfDraw& packed, const Scene& scene) {
  if (packed.draw >= scene.draws.size()) return "a draw of theirs is gone";
  const Draw& draw = scene.draws[packed.draw];
  if (packed.rows.size() != draw.levels.size()) return draw.name + " has another number of levels";
  for (std::size_t l = 0; l < draw.levels.size(); ++l) {
    const std::string broken = broken_promise(*draw.levels[l].vertices, packed.layout, packed.rows[l].view());
    if (!broken.empty()) return name_of(draw, l) + ' ' + broken;
  }
  return {};
}

/// With rows where their vertices are now; with none where vertices are not known from before.
PackedVertices::OfDraw moved(const PackedVertices::OfDraw& packed, const Scene& before, const Scene& after) {
  PackedVertices::OfDraw now = packed;
  now.rows.clear();
  if (packed.draw >= before.draws.size() || packed.draw >= after.draws.size()) return now;
  const Draw &was = before.draws[packed.draw], &is = after.draws[packed.draw];
  if (was.levels.size() != is.levels.size() || packed.rows.size() != is.levels.size()) return now;
  for (std::size_t l = 0; l < is.levels.size(); ++l) {
    if (was.levels[l].vertices == is.levels[l].vertices) {
      now.rows.push_back(packed.rows[l]);
      continue;
    }
    const auto moves = vertex_moves(was.levels[l], is.levels[l]);
    const auto old = packed.rows[l].view();
    if (!moves || old.size() != 4 * moves->size()) return now;
    std::vector<std::uint32_t> rows(std::size_t{4} * is.levels[l].vertices->count);
    for (std::size_t v = 0; v < moves->size(); ++v) {
      if ((*moves)[v] != no_vertex) std::copy_n(old.begin() + 4 * v, 4, rows.begin() + std::size_t{4} * (*moves)[v]);
    }
    now.rows.emplace_back(std::move(rows));
  }
  return now;
}

bool has_same_vertices(const Draw& a, const Draw& b) {
  return std::ranges::equal(a.levels, b.levels,
                            [](const Level& x, const Level& y) { return x.vertices == y.vertices; });
}

std::string bits_text(const PackedLayout& layout) {
  const auto bits = [&](int field) { return layout.field[field].bits; };
  std::string text =
      fmt::format("{} + {} + {}", bits(FOREDRAW_PACKED_X), bits(FOREDRAW_PACKED_Y), bits(FOREDRAW_PACKED_Z));
  if (bits(FOREDRAW_PACKED_NORMAL_0) > 0) text += fmt::format(", normal 2 x {}", bits(FOREDRAW_PACKED_NORMAL_0));
  if (bits(FOREDRAW_PACKED_TANGENT) > 0) text += fmt::format(", tangent {} + 1", bits(FOREDRAW_PACKED_TANGENT));
  if (bits(FOREDRAW_PACKED_U) > 0)
    text += fmt::format(", uv {} + {}", bits(FOREDRAW_PACKED_U), bits(FOREDRAW_PACKED_V));
  return text;
}

Members told_bounds(const PackedBounds& bounds) {
  return {{"position", bounds.position}, {"normal", bounds.normal}, {"tangent", bounds.tangent}, {"uv", bounds.uv()}};
}

class PackedVerticesRow final : public ProductRow {
 public:
  PackedVerticesRow()
      : ProductRow({.name = std::string(PackedVertices::product),
                    .title = "packed vertices",
                    .extension = "FOREDRAW_packed_vertices",
                    .remedy = "run vertex-pack again",
                    .accessors_of_draw = {"rows/*"},
                    .schemas = schemas(),
                    .side_files = {{".h"}, {".glsl"}, {".hlsl"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    auto all = read_packed_vertices(from, scene);
    if (auto* wrong = std::get_if<std::string>(&all)) return std::move(*wrong);
    scene.products.set(std::get<PackedVertices>(std::move(all)));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    write_packed_vertices(*scene.products.find<PackedVertices>(), to);
  }

  std::string difference(const Scene& scene) const override {
    for (const PackedVertices::OfDraw& packed : scene.products.find<PackedVertices>()->draws) {
      if (std::string wrong = wrong_with(packed, scene); !wrong.empty()) return wrong;
    }
    return {};
  }

  /// Rows move with their vertices.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    PackedVertices left;
    std::vector<std::string> told;
    const PackedVertices* was = before.products.find<PackedVertices>();
    for (const PackedVertices::OfDraw& packed : after.products.find<PackedVertices>()->draws) {
      const bool is_known = packed.draw < before.draws.size() && packed.draw < after.draws.size();
      if (is_known && has_same_vertices(before.draws[packed.draw], after.draws[packed.draw])) {
        left.draws.push_back(packed);
        continue;
      }
      const bool is_new = was == nullptr || std::ranges::find(was->draws, packed) == was->draws.end();
      PackedVertices::OfDraw now = is_new ? packed : moved(packed, before, after);
      if (wrong_with(now, after).empty()) {
        left.draws.push_back(std::move(now));
      } else {
        told.push_back("the packed vertices of " +
                       (packed.draw < before.draws.size() ? before.draws[packed.draw].name : "a draw") +
                       " are left out: its vertices or levels were replaced; pack them after that stage");
      }
    }
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  SideFile side_file(const Scene& scene, std::string_view extension, const std::string& beside) const override {
    const PackedVertices& all = *scene.products.find<PackedVertices>();
    if (extension == ".h") return {.content = packed_vertices_header(all, scene, beside.substr(0, beside.rfind('.')))};
    return {.content = packed_vertices_shader(all, scene, extension)};
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "packed vertices (16 bytes each, beside the plain streams)",
                     .value = ExtensionValue::List()};
    for (const PackedVertices::OfDraw& packed : scene.products.find<PackedVertices>()->draws) {
      const std::string& name = scene.draws[packed.draw].name;
      std::size_t vertices = 0;
      for (const Shared<std::uint32_t>& rows : packed.rows) vertices += rows.size() / 4;
      const PackedBounds bounds = packed_bounds(packed.layout);
      text.lines.push_back(
          fmt::format("{}: vertices {}, bits {}{}; off by at most {:.3g} units, normals {:.3g} degrees", name, vertices,
                      bits_text(packed.layout), packed.posed ? ", posed " + bits_text(*packed.posed) : "",
                      bounds.position, bounds.normal));
      Members value = {{"draw", name}, {"vertices", vertices}, {"bounds", told_bounds(bounds)}};
      if (packed.posed) value.emplace_back("posedBounds", told_bounds(packed_bounds(*packed.posed)));
      text.value.push(std::move(value));
    }
    return text;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> packed_vertices_product() { return std::make_shared<const PackedVerticesRow>(); }

}  // namespace foredraw
