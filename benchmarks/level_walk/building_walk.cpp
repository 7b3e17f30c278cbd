#include "building_plan.h"
#include "camera_path.h"
#include "gpu_instancing.h"
#include "indoor_models.h"
#include "layout.h"
#include "outdoor_models.h"
#include "walk_scene.h"

#include <array>

namespace foredraw::bench {

namespace {

using Numbers = std::vector<std::size_t>;

struct BuildingModels {
  std::vector<KitDocument::Model> all;
  std::size_t whole_wall, half_wall, lintel, post, floor, ceiling, table, pedestal, lamp;
  Numbers chairs, sofas, shelves, statues, busts, vases, plants, chandeliers, rugs;
  std::vector<float> bust_sizes,
      bust_feet;  ///< how much smaller a bust is placed, and how far its model reaches below 0
};

BuildingModels add_building_models(GltfDocument& to, const WalkOptions& options) {
  BuildingModels models{};
  Palette palette(to);
  const auto add = [&](const std::string& name, std::vector<ModelPart> parts) {
    models.all.push_back(add_model(to, palette, name, std::move(parts)));
    return models.all.size() - 1;
  };
  const auto some = [&](const char* name, std::uint64_t count, const auto& make) {
    Numbers numbers;
    for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(add(name + (' ' + std::to_string(i + 1)), make(i)));
    return numbers;
  };
  models.whole_wall = add("wall", slab({room - wall, room_height, wall}, "plaster"));
  models.half_wall = add("wall beside a door", slab({(room - wall - door) / 2, room_height, wall}, "plaster"));
  models.lintel = add("wall above a door", slab({door, room_height - door_height, wall}, "plaster"));
  models.post = add("corner", slab({wall, room_height, wall}, "plaster"));
  models.floor = add("floor", slab({room, .05, room}, "planks"));
  models.ceiling = add("ceiling", slab({room, .05, room}, "ceiling"));
  models.table = add("table", table());
  models.pedestal = add("pedestal", pedestal());
  models.lamp = add("floor lamp", floor_lamp());
  models.chairs = some("chair", 2, chair);
  models.sofas = some("sofa", 2, sofa);
  models.shelves = some("shelf", 4, shelf);
  models.statues = some("statue", 6, [](std::uint64_t i) { return statue(.95, 600 + i, 96 + 16 * i, 140); });
  models.vases = some("vase", 8, vase);
  models.plants = some("pot plant", 4, [](std::uint64_t i) { return pot_plant(700 + i); });
  models.chandeliers = some("chandelier", 3, chandelier);
  models.rugs = some("rug", 2, rug);
  KitDocument corpus(to);
  for (const char* name : {"spot", "head"}) {
    models.busts.push_back(models.all.size());
    models.all.push_back(corpus.add(options.corpus / "static" / (std::string(name) + ".glb")));
  }
  models.bust_sizes = {.32f, .07f};
  models.bust_feet = {.737f, 3.973f};
  to.json["asset"]["copyright"] =
      "'Infinite, 3D Head Scan' by Lee Perry-Smith, Infinite-Realities, CC-BY 3.0; 'Spot' by Keenan Crane";
  return models;
}

/// Places of one building, room by room.
class Building {
 public:
  Building(const Kit& kit, const BuildingModels& models, const BuildingPlan& plan, std::uint64_t seed)
      : layout_(kit, {.instances = ~std::uint64_t{0}, .seed = seed}), models_(models), plan_(plan) {}

  std::vector<Placement> placements() {
    for (std::uint64_t j = 0; j <= plan_.side(); ++j) {
      for (std::uint64_t i = 0; i <= plan_.side(); ++i) {
        random_ = layout_.random_of(i, j);
        const glm::dvec2 corner(static_cast<double>(i) * room, static_cast<double>(j) * room);
        add(models_.post, corner, 0, 0);
        if (i < plan_.side()) add_wall(corner + glm::dvec2(room / 2, 0), {1, 0}, plan_.has_door_front(i, j));
        if (j < plan_.side()) add_wall(corner + glm::dvec2(0, room / 2), {0, 1}, plan_.has_door_left(i, j));
        if (i < plan_.side() && j < plan_.side()) add_room(corner + room / 2);
      }
    }
    return layout_.take();
  }

 private:
  void add(std::size_t model, const glm::dvec2& place, double height, std::uint64_t quarters, float size = 1) {
    layout_.add(model, place, height, quarter_turn(quarters), glm::vec3(size), random_);
  }

  std::size_t one_of(const Numbers& models) { return models[random_.below(models.size())]; }

  void add_wall(const glm::dvec2& middle, const glm::dvec2& along, bool has_door) {
    const std::uint64_t quarters = along.x == 0 ? 1 : 0;
    if (!has_door) return add(models_.whole_wall, middle, 0, quarters);
    const double aside = (door + (room - wall - door) / 2) / 2;
    add(models_.half_wall, middle - aside * along, 0, quarters);
    add(models_.half_wall, middle + aside * along, 0, quarters);
    add(models_.lintel, middle, door_height, quarters);
  }

  /// Furniture keeps to the four quarters of a room, so that there is a way from door to door.
  void add_room(const glm::dvec2& middle) {
    add(models_.floor, middle, -.05, 0);
    add(models_.ceiling, middle, room_height, 0);
    add(one_of(models_.chandeliers), middle, room_height, 0);
    for (std::uint64_t quarters = 0; quarters < 4; ++quarters) {
      const std::uint64_t kind = random_.below(5);
      if (kind == 0) add_meal(middle, quarters);
      if (kind == 1) add_seats(middle, quarters);
      if (kind == 2) add_books(middle, quarters);
      if (kind == 3) add_gallery(middle, quarters);
      if (kind == 4) add_garden(middle, quarters);
    }
  }

  /// A place in a quarter of the room: x and z from .8 to 2.9 in the first one, turned with it.
  static glm::dvec2 in_quarter(const glm::dvec2& middle, std::uint64_t quarters, double x, double z) {
    for (std::uint64_t i = 0; i < quarters; ++i) {
      const double before = x;
      x = z;
      z = -before;
    }
    return middle + glm::dvec2(x, z);
  }

  void add_meal(const glm::dvec2& middle, std::uint64_t q) {
    add(one_of(models_.rugs), in_quarter(middle, q, 1.85, 1.85), 0, q);
    add(models_.table, in_quarter(middle, q, 1.85, 1.85), 0, q);
    add(one_of(models_.vases), in_quarter(middle, q, 1.7, 1.85), .8, q);
    add(one_of(models_.vases), in_quarter(middle, q, 2.2, 1.9), .8, q);
    const std::size_t chair = one_of(models_.chairs);
    for (const double x : {1.5, 2.2}) {
      add(chair, in_quarter(middle, q, x, 1.3), 0, q);
      add(chair, in_quarter(middle, q, x, 2.4), 0, q + 2);
    }
  }

  void add_seats(const glm::dvec2& middle, std::uint64_t q) {
    add(one_of(models_.sofas), in_quarter(middle, q, 1.8, 2.4), 0, q + 2);
    add(one_of(models_.rugs), in_quarter(middle, q, 1.8, 1.5), 0, q);
    add(models_.lamp, in_quarter(middle, q, 2.7, 1.1), 0, q);
    add(one_of(models_.plants), in_quarter(middle, q, 1.15, 1.15), 0, q);
  }

  void add_books(const glm::dvec2& middle, std::uint64_t q) {
    add(one_of(models_.shelves), in_quarter(middle, q, 2.15, 2.7), 0, q + 2);
    add(one_of(models_.shelves), in_quarter(middle, q, 2.7, 1.65), 0, q + 3);
    add(one_of(models_.vases), in_quarter(middle, q, 2.15, 2.7), 1.82, q);
    add(one_of(models_.chairs), in_quarter(middle, q, 1.4, 1.6), 0, q);
    add_bust(in_quarter(middle, q, 1.15, 2.5), q + 2);
  }

  void add_gallery(const glm::dvec2& middle, std::uint64_t q) {
    for (const double x : {1.2, 2.5}) {
      for (const double z : {1.2, 2.5}) {
        const glm::dvec2 place = in_quarter(middle, q, x, z);
        if (x != z) {
          add_bust(place, q + random_.below(4));
        } else {
          add(models_.pedestal, place, 0, q);
          const std::size_t statue = one_of(models_.statues);
          add(statue, place, 1, q + random_.below(4));
        }
      }
    }
  }

  void add_garden(const glm::dvec2& middle, std::uint64_t q) {
    for (const double x : {1.3, 1.95, 2.6}) add(one_of(models_.plants), in_quarter(middle, q, x, 2.5), 0, q);
    for (const double z : {1.2, 1.8}) add(one_of(models_.plants), in_quarter(middle, q, 2.6, z), 0, q);
    for (int i = 0; i < 3; ++i) add(one_of(models_.vases), in_quarter(middle, q, 1.2 + .4 * i, 1.7), 0, q);
  }

  void add_bust(const glm::dvec2& place, std::uint64_t quarters) {
    const std::size_t bust = random_.below(models_.busts.size());
    add(models_.pedestal, place, 0, quarters);
    const auto size = models_.bust_sizes[bust];
    add(models_.busts[bust], place, 1 + static_cast<double>(size * models_.bust_feet[bust]), quarters, size);
  }

  Layout layout_;
  const BuildingModels& models_;
  const BuildingPlan& plan_;
  Random random_{0};
};

std::uint64_t primitives(const Kit& kit, const std::vector<Placement>& placements) {
  std::uint64_t sum = 0;
  for (const Placement& placement : placements) sum += kit.models[placement.model].primitives;
  return sum;
}

/// At eye height through the middles of the rooms.
CameraPath path_through(const BuildingPlan& plan) {
  CameraPath path{.corners = {}, .rounding = 1.5, .ahead = 1.5};
  for (const auto& [i, j] : plan.walk()) {
    path.corners.emplace_back((static_cast<double>(i) + 0.5) * room, 1.6, (static_cast<double>(j) + 0.5) * room);
  }
  return path;
}

}  // namespace

Scene building_walk(const WalkOptions& options) {
  GltfDocument document;
  const BuildingModels models = add_building_models(document, options);
  const Kit models_alone = kit_of(document, models.all, "building");
  const std::uint64_t wanted = options.instances == 0 ? 4000 : options.instances;
  for (std::uint64_t side = 3;; ++side) {
    const BuildingPlan plan(side, options.seed);
    const std::vector<Placement> placements = Building(models_alone, models, plan, options.seed).placements();
    if (primitives(models_alone, placements) < wanted) continue;
    add_walk(document, path_through(plan));
    const Kit kit = kit_of(document, models.all, "building");
    const Scene scene = placed_scene(kit, placements, "building");
    return options.gpu_instancing ? with_gpu_instancing(scene, kit.scene.nodes.size()) : scene;
  }
}

}  // namespace foredraw::bench
