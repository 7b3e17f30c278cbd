#include "baked_heights_product.h"

#include "moved_heights.h"
#include "schemas.h"

#include <foredraw/displaced/displaced_mesh.h>
#include <foredraw/displaced/stored_levels.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

std::optional<float> number_of(const ExtensionValue& value, const char* key) {
  const ExtensionValue* member = value.member(key);
  const auto number = member == nullptr ? std::nullopt : member->number();
  if (!number || !(std::abs(*number) <= std::numeric_limits<float>::max())) return std::nullopt;
  return static_cast<float>(*number);
}

class BakedHeightsRow final : public ProductRow {
 public:
  BakedHeightsRow()
      : ProductRow({.name = std::string(BakedHeights::product),
                    .title = "baked heights",
                    .extension = "FOREDRAW_baked_heights",
                    .remedy = "bake the draw again",
                    .accessors_of_draw = {"levels", "heights"},
                    .schemas = schemas()}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    BakedHeights all;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      const auto levels = rows_of<std::uint8_t>(from, value->member("levels"), Component::uint8);
      const auto heights = rows_of<std::uint16_t>(from, value->member("heights"), Component::uint16);
      const ExtensionValue* bits = value->member("bits");
      const auto factor = number_of(*value, "factor"), offset = number_of(*value, "offset");
      if (!levels || !heights) return "an accessor is missing, or of another type";
      if (!bits || !bits->whole() || !factor || !offset)
        return "'bits', 'factor' or 'offset' is missing, or not a number";
      all.draws.push_back({id, *levels, *heights, *bits->whole(), *factor, *offset});
      scene.draws[id].traits.add(traits::displaced);
    }
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const DrawHeights& draw : scene.products.find<BakedHeights>()->draws) {
      to.put_on_draw(draw.draw,
                     Members{{"levels", to.accessor(accessor_data(draw.levels.view(), Component::uint8, 1))},
                             {"heights", to.accessor(accessor_data(draw.heights.view(), Component::uint16, 1))},
                             {"bits", draw.bits},
                             {"factor", draw.factor},
                             {"offset", draw.offset}});
    }
  }

  std::string difference(const Scene& scene) const override {
    for (const DrawHeights& draw : scene.products.find<BakedHeights>()->draws) {
      if (draw.draw >= scene.draws.size()) return "a draw of theirs is gone";
      if (std::string why = difference(draw, scene.draws[draw.draw]); !why.empty())
        return scene.draws[draw.draw].name + ' ' + why;
    }
    return {};
  }

  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    BakedHeights left;
    std::vector<std::string> told;
    const BakedHeights* was = before.products.find<BakedHeights>();
    for (const DrawHeights& draw : after.products.find<BakedHeights>()->draws) {
      std::optional<DrawHeights> now = draw;
      const bool is_new = was == nullptr || std::ranges::find(was->draws, draw) == was->draws.end();
      if (!is_new) {
        const bool is_there = draw.draw < after.draws.size() && after.draws[draw.draw].levels.size() == 1;
        now = is_there ? processors::displacement_bake::moved(draw, before.draws[draw.draw].full(),
                                                              after.draws[draw.draw].full())
                       : std::nullopt;
      }
      if (now && difference(*now, after.draws[now->draw]).empty()) {
        left.draws.push_back(std::move(*now));
        continue;
      }
      told.push_back("the baked heights of " + before.draws[draw.draw].name +
                     " are left out: its triangles were replaced");
      if (draw.draw < after.draws.size()) after.draws[draw.draw].traits.remove(traits::displaced);
    }
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  void leave_out(Scene& scene) const override {
    for (const DrawHeights& draw : scene.products.find<BakedHeights>()->draws) {
      if (draw.draw < scene.draws.size()) scene.draws[draw.draw].traits.remove(traits::displaced);
    }
    scene.products.erase(BakedHeights::product);
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "baked heights (a tessellator shows the surface by them)",
                     .value = ExtensionValue::List()};
    for (const DrawHeights& draw : scene.products.find<BakedHeights>()->draws) {
      text.lines.push_back(scene.draws[draw.draw].name + ": " + std::to_string(draw.heights.size()) + " heights of " +
                           std::to_string(draw.bits) + " bits");
      text.value.push(
          Members{{"draw", scene.draws[draw.draw].name}, {"heights", draw.heights.size()}, {"bits", draw.bits}});
    }
    return text;
  }

 private:
  static std::string difference(const DrawHeights& heights, const Draw& draw) {
    if (draw.topology != Topology::triangles || draw.full().vertices->find("POSITION") == nullptr)
      return "has no triangles";
    if (draw.levels.size() != 1) return "has several levels of detail";
    const auto levels = heights.levels.view();
    const auto values = heights.heights.view();
    if (levels.size() != draw.full().stream().triangle_count()) return "does not have one level for each triangle";
    if (std::ranges::any_of(levels, [](std::uint8_t log) { return log > most_log_level; }))
      return "has a level above 64";
    if (heights.bits < 1 || heights.bits > 16) return "has heights of no bits, or of more than 16";
    if (std::ranges::any_of(values, [&](std::uint16_t height) { return height >> heights.bits != 0; }))
      return "has a height that needs more bits than it says";
    const auto indices = draw.full().stream().indices.view();
    const auto all = baked_levels(levels, indices, decode_vec3(*draw.full().vertices->find("POSITION")));
    // Counted before anything is made of it: 64 parts everywhere make six thousand triangles of one.
    std::uint64_t at_least = 0;
    for (const TessellationLevels& of : all) at_least += tessellation_counts(of, TessellationSpacing::equal).points;
    if (at_least > 6 * (values.size() + std::uint64_t{1})) return "does not have one height for each vertex";
    return tessellated_mesh(heights, draw.full()).vertices() == values.size()
               ? std::string()
               : "does not have one height for each vertex";
  }
};

}  // namespace

std::shared_ptr<const ProductRow> baked_heights_product() { return std::make_shared<const BakedHeightsRow>(); }

}  // namespace foredraw
