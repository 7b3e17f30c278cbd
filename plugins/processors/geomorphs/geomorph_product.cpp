#include "geomorph_product.h"

#include "schemas.h"

#include <foredraw/analysis/analyses.h>
#include <foredraw/analysis/welded_positions.h>
#include <foredraw/scene/moves.h>

#include <algorithm>
#include <array>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;
using Triangle = std::array<std::uint32_t, 3>;

/// Begun at its smallest corner, so that equal ones are equal.
Triangle turned(Triangle t) {
  std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  return t;
}

/// As the rest of a sentence; empty: the finer level's triangles end as the coarser one's.
std::string why_not(const Level& fine, const Level& coarse, std::span<const std::uint32_t> ancestors,
                    Analyses& analyses) {
  if (ancestors.size() != fine.vertices->count) return "does not have one ancestor for each vertex";
  const auto is_there = [&](std::uint32_t ancestor) { return ancestor < coarse.vertices->count; };
  if (!std::ranges::all_of(ancestors, is_there)) return "names an ancestor that is not there";
  const std::vector<std::uint32_t> point = welded(positions_of(analyses, *coarse.vertices)->values);
  std::vector<Triangle> ended, wanted;
  const auto collect = [&](std::span<const std::uint32_t> indices, const auto& corner, std::vector<Triangle>& all) {
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
      const Triangle t{corner(indices[i]), corner(indices[i + 1]), corner(indices[i + 2])};
      const bool is_line = point[t[0]] == point[t[1]] || point[t[1]] == point[t[2]] || point[t[2]] == point[t[0]];
      if (!is_line) all.push_back(turned(t));
    }
    std::ranges::sort(all);
  };
  collect(
      fine.stream().indices.view(), [&](std::uint32_t v) { return ancestors[v]; }, ended);
  collect(
      coarse.stream().indices.view(), [](std::uint32_t v) { return v; }, wanted);
  return ended == wanted ? std::string() : "does not end as the next level";
}

class GeomorphRow final : public ProductRow {
 public:
  GeomorphRow()
      : ProductRow({.name = std::string(Geomorphs::product),
                    .title = "geomorphs",
                    .extension = "FOREDRAW_geomorph",
                    .remedy = "make the levels again",
                    .accessors_of_draw = {"ancestors/*"},
                    .schemas = schemas()}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    Geomorphs all;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      const ExtensionValue* list = value->member("ancestors");
      if (list == nullptr || list->list() == nullptr) return "it has no array 'ancestors'";
      DrawGeomorph draw{id, {}};
      for (const ExtensionValue& one : *list->list()) {
        auto ancestors = rows_of<std::uint32_t>(from, &one, Component::uint32);
        if (!ancestors) {
          return name_of_level(scene.draws[id], draw.ancestors.size()) + " has no ancestors of type SCALAR and 5125";
        }
        draw.ancestors.push_back(std::move(*ancestors));
      }
      all.draws.push_back(std::move(draw));
    }
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const DrawGeomorph& draw : scene.products.find<Geomorphs>()->draws) {
      to.put_on_draw(draw.draw, Members{{"ancestors", listed(draw.ancestors, [&](const Shared<std::uint32_t>& level) {
                                           return to.accessor(accessor_data(level.view(), Component::uint32, 1));
                                         })}});
    }
  }

  std::string difference(const Scene& scene) const override {
    Analyses analyses;
    for (const DrawGeomorph& draw : scene.products.find<Geomorphs>()->draws) {
      if (std::string why = difference(draw, scene, analyses); !why.empty()) return why;
    }
    return {};
  }

  /// Rows move with the vertices of their level, and what they name with those of the next one.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    Geomorphs left;
    std::vector<std::string> told;
    Analyses analyses;
    const Geomorphs* was = before.products.find<Geomorphs>();
    for (const DrawGeomorph& draw : after.products.find<Geomorphs>()->draws) {
      const bool is_new = was == nullptr || std::ranges::find(was->draws, draw) == was->draws.end();
      DrawGeomorph now = is_new ? draw : moved(draw, before, after);
      if (difference(now, after, analyses).empty()) {
        left.draws.push_back(std::move(now));
      } else {
        told.push_back("the geomorphs of " + before.draws[draw.draw].name + " are left out: its levels were replaced");
      }
    }
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "geomorphs (ancestors of vertices in the next coarser level)",
                     .value = ExtensionValue::List()};
    for (const DrawGeomorph& draw : scene.products.find<Geomorphs>()->draws) {
      std::size_t vertices = 0;
      for (const Shared<std::uint32_t>& level : draw.ancestors) vertices += level.size();
      text.lines.push_back(scene.draws[draw.draw].name + ": levels " + std::to_string(draw.ancestors.size()) +
                           ", vertices " + std::to_string(vertices));
      text.value.push(
          Members{{"draw", scene.draws[draw.draw].name}, {"levels", draw.ancestors.size()}, {"vertices", vertices}});
    }
    return text;
  }

 private:
  static std::string difference(const DrawGeomorph& draw, const Scene& scene, Analyses& analyses) {
    if (draw.draw >= scene.draws.size()) return "a draw of theirs is gone";
    const Draw& of = scene.draws[draw.draw];
    if (draw.ancestors.size() + 1 != of.levels.size()) return of.name + " has another number of levels";
    for (std::size_t l = 0; l < draw.ancestors.size(); ++l) {
      const std::string why = why_not(of.levels[l], of.levels[l + 1], draw.ancestors[l].view(), analyses);
      if (!why.empty()) return name_of_level(of, l) + ' ' + why;
    }
    return {};
  }

  static std::string name_of_level(const Draw& draw, std::size_t level) {
    return draw.name + ", level " + std::to_string(level) + ',';
  }

  /// With no ancestors where vertices of a level are not known from before.
  static DrawGeomorph moved(const DrawGeomorph& draw, const Scene& before, const Scene& after) {
    DrawGeomorph now{draw.draw, {}};
    if (draw.draw >= after.draws.size()) return now;
    const Draw &was = before.draws[draw.draw], &is = after.draws[draw.draw];
    if (was.levels.size() != is.levels.size()) return now;
    std::vector<std::vector<std::uint32_t>> moves;
    for (std::size_t l = 0; l < is.levels.size(); ++l) {
      auto of_level = vertex_moves(was.levels[l], is.levels[l]);
      if (!of_level) return now;
      moves.push_back(std::move(*of_level));
    }
    for (std::size_t l = 0; l < draw.ancestors.size(); ++l) {
      const auto old = draw.ancestors[l].view();
      std::vector<std::uint32_t> ancestors(is.levels[l].vertices->count, 0);
      for (std::size_t v = 0; v < old.size(); ++v) {
        if (moves[l][v] != no_vertex) ancestors[moves[l][v]] = moves[l + 1][old[v]];
      }
      now.ancestors.emplace_back(std::move(ancestors));
    }
    return now;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> geomorph_product() { return std::make_shared<const GeomorphRow>(); }

}  // namespace foredraw
