#include "character.h"

#include <foredraw/draw_orders/draw_orders_product.h>
#include <foredraw/io/scene_file.h>
#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/drawn_orders.h>
#include <foredraw/viewing/order_lookup.h>
#include <foredraw/viewing/pose_set.h>

#include <evaluators/overdraw_raster/overdraw_raster.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <utility>

namespace {

constexpr int picture_size = 256;

using foredraw::Subject;
using foredraw::SubjectPart;

bool chooses_for(const foredraw::OrderTable& table, const SubjectPart& part) {
  return std::ranges::find(table.draws, part.draw) != table.draws.end();
}

/// The first that the table chooses for.
Subject subject_of(const foredraw::Scene& scene, const foredraw::OrderTable& table) {
  for (Subject& subject : subjects_of(scene)) {
    const auto is_chosen = [&](const SubjectPart& part) { return chooses_for(table, part); };
    if (std::ranges::any_of(subject.parts, is_chosen)) return std::move(subject);
  }
  throw std::runtime_error("nothing shows what its table of draw orders chooses for");
}

/// The first table, in a scene that stays where it is.
const foredraw::OrderTable& table_of(const foredraw::Scene& scene) {
  if (order_tables(scene).empty()) throw std::runtime_error("no table of draw orders: optimise it with @character");
  return order_tables(scene).front();
}

/// No exception passes into C.
template <class Work>
auto said(Work work) -> decltype(work()) {
  try {
    return work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "character_orders: %s\n", error.what());
  }
  return {};
}

}  // namespace

struct character {
  foredraw::Scene scene;
  const foredraw::OrderTable& table = table_of(scene);
  Subject subject = subject_of(scene, table);
  std::vector<std::string> clips = clip_names(scene);
  foredraw::OrderLookup lookup = {table, clips};
  foredraw::Analyses analyses = {};
  foredraw::SubjectGeometry posed = {};
};

character* character_load(const char* path) {
  return said([&]() -> character* {
    foredraw::Diagnostics diagnostics;
    std::optional<foredraw::SceneFile> file =
        foredraw::read_scene(path, diagnostics, {.products = {foredraw::draw_orders_product()}});
    std::fprintf(stderr, "%s", foredraw::to_text(diagnostics).c_str());
    if (!file) return nullptr;
    character* hero = new character{std::move(file->scene)};
    if (hero->table.clips.empty()) character_pose(hero, FOREDRAW_NO_CLIP, 0);
    return hero;
  });
}

void character_free(character* hero) { delete hero; }

const foredraw_order_table* character_table(const character* hero) { return &hero->lookup.table(); }

int character_pose(character* hero, uint32_t clip, float time) {
  return said([&] {
    foredraw::Pose pose;
    if (clip < hero->table.clips.size()) {
      const auto known = std::ranges::find(hero->clips, hero->table.clips[clip].name);
      if (known == hero->clips.end()) throw std::runtime_error("the scene has no clip that its table names");
      pose = {static_cast<foredraw::AnimationId>(known - hero->clips.begin()), time};
    }
    hero->posed = subject_geometry(hero->scene, hero->subject, foredraw::Faces::material,
                                   posed_nodes(hero->scene, pose), hero->analyses);
    return 1;
  });
}

int character_draw(character* hero, const float towards_camera[3], uint32_t order, const uint16_t* sequence,
                   character_fragments* fragments) {
  return said([&] {
    foredraw::ViewsOfOrders as;
    for (const SubjectPart& part : hero->subject.parts) as.orders.push_back(chooses_for(hero->table, part) ? order : 0);
    const std::size_t parts = sequence == nullptr ? 0 : hero->table.parts.size();
    as.sequence = parts_in_sequence(hero->subject, hero->table, {sequence, parts});
    const auto drawn = parts_as_drawn(hero->posed, hero->scene, hero->subject, as);
    const glm::dvec3 direction(towards_camera[0], towards_camera[1], towards_camera[2]);
    const foredraw::Views views{{{normalize(direction)}}, picture_size};
    *fragments = {0, 0};
    for (const auto& part : foredraw::overdraw_raster(drawn, views)) {
      fragments->drawn += static_cast<double>(part.front().shaded);
      fragments->visible += static_cast<double>(part.front().visible);
    }
    return 1;
  });
}
