#include "seam_heights_product.h"

#include "schemas.h"

#include <foredraw/displaced/stored_seams.h>
#include <foredraw/scene/moves.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

/// What is wrong, as the rest of a sentence; empty: nothing.
std::string read_seams(ExtensionReader& from, const ExtensionValue& value, DrawSeams& to) {
  const auto parts = rows_of<std::uint8_t>(from, value.member("parts"), Component::uint8);
  if (!parts) return "has no accessor 'parts' of unsigned bytes";
  const auto sides = rows_of<foredraw_seam_side>(from, value.member("sides"), Component::uint32);
  if (!sides) return "has no accessor 'sides' of two unsigned ints";
  to.parts_log2 = *parts;
  to.sides = *sides;
  if (value.member("heights") == nullptr) return {};
  const auto heights = rows_of<std::uint16_t>(from, value.member("heights"), Component::uint16);
  if (!heights) return "has no accessor 'heights' of unsigned shorts";
  to.heights = *heights;
  return {};
}

const Displacement* displacement_of(const Scene& scene, DrawId draw) {
  if (draw >= scene.draws.size()) return nullptr;
  const Material* material = scene.material_of(scene.draws[draw]);
  return material != nullptr && material->displacement ? &*material->displacement : nullptr;
}

/// How they differ from their draw; the same.
std::string difference_of(const DrawSeams& of, const Scene& scene) {
  if (displacement_of(scene, of.draw) == nullptr) return "are of a draw that no map displaces";
  const Draw& draw = scene.draws[of.draw];
  if (draw.topology != Topology::triangles) return "are of a draw without triangles";
  if (!StoredSeams(of).is_sound(draw.full().stream().triangle_count()))
    return "name triangles, edges or heights that are not there";
  return {};
}

/// With the triangles where they are now.
std::optional<DrawSeams> moved(const DrawSeams& of, const IndexStream& before, const IndexStream& after) {
  if (after.indices.is(before.indices)) return of;
  const auto moves = triangle_moves(before, after);
  if (!moves) return std::nullopt;
  std::vector<foredraw_seam_side> sides(of.sides.view().begin(), of.sides.view().end());
  for (foredraw_seam_side& side : sides) side.side = 3 * (*moves)[side.side / 3] + side.side % 3;
  std::ranges::sort(sides, {}, &foredraw_seam_side::side);
  DrawSeams now = of;
  now.sides = Shared(std::move(sides));
  return now;
}

class SeamHeightsRow final : public ProductRow {
 public:
  SeamHeightsRow()
      : ProductRow({.name = std::string(SeamHeights::product),
                    .title = "heights of seams",
                    .extension = "FOREDRAW_seam_heights",
                    .remedy = "run displacement-seams(table=true) again",
                    .accessors_of_draw = {"parts", "heights", "sides"},
                    .schemas = schemas()}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    SeamHeights all;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      DrawSeams of{.draw = id};
      std::string why = from.is_list(id) ? read_seams(from, *value, of) : "is not a list of triangles with indices";
      if (!why.empty()) return scene.draws[id].name + ' ' + why;
      all.draws.push_back(std::move(of));
    }
    if (all.draws.empty()) return "no primitive has heights of seams";
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const DrawSeams& of : scene.products.find<SeamHeights>()->draws) {
      const auto bytes = std::as_bytes(of.sides.view());
      const AccessorData sides{
          {Component::uint32, 2, false, 8}, of.sides.size(), Shared<std::byte>({bytes.begin(), bytes.end()})};
      Members members{{"parts", to.accessor(accessor_data(of.parts_log2.view(), Component::uint8, 1))}};
      if (!of.heights.empty())
        members.push_back({"heights", to.accessor(accessor_data(of.heights.view(), Component::uint16, 1))});
      members.push_back({"sides", to.accessor(sides)});
      to.put_on_draw(of.draw, std::move(members));
    }
  }

  std::string difference(const Scene& scene) const override {
    for (const DrawSeams& of : scene.products.find<SeamHeights>()->draws) {
      if (of.draw >= scene.draws.size()) return "a draw of theirs is gone";
      if (std::string why = difference_of(of, scene); !why.empty())
        return "those of " + scene.draws[of.draw].name + ' ' + why;
    }
    return {};
  }

  /// Heights are parts of the map's range, so factor and offset may change.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    const SeamHeights* stood = before.products.find<SeamHeights>();
    SeamHeights left;
    std::vector<std::string> told;
    for (const DrawSeams& of : after.products.find<SeamHeights>()->draws) {
      if (stood == nullptr || std::ranges::find(stood->draws, of) == stood->draws.end()) {  // the stage made it
        left.draws.push_back(of);
        continue;
      }
      const Displacement *was = displacement_of(before, of.draw), *is = displacement_of(after, of.draw);
      std::optional<DrawSeams> now;
      std::string why = "no map displaces it, or another one does";
      if (was != nullptr && is != nullptr && was->texture == is->texture) {
        now = moved(of, before.draws[of.draw].full().stream(), after.draws[of.draw].full().stream());
        why = now ? difference_of(*now, after) : "its triangles were replaced";
        if (!why.empty()) now.reset();
      }
      if (now) {
        left.draws.push_back(std::move(*now));
      } else {
        const std::string name = of.draw < before.draws.size() ? before.draws[of.draw].name : "a draw";
        told.push_back("the heights of seams of " + name + " are left out: " + why);
      }
    }
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "heights of seams (for both sides, at any level of a tessellator)", .value = List()};
    for (const DrawSeams& of : scene.products.find<SeamHeights>()->draws) {
      const std::string& name = scene.draws[of.draw].name;
      text.lines.push_back(fmt::format("{}: edges {}, heights {}, sides {}", name, of.parts_log2.size(),
                                       of.heights.size(), of.sides.size()));
      text.value.push(Members{
          {"draw", name}, {"edges", of.parts_log2.size()}, {"heights", of.heights.size()}, {"sides", of.sides.size()}});
    }
    return text;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> seam_heights_product() { return std::make_shared<const SeamHeightsRow>(); }

}  // namespace foredraw
