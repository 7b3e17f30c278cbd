#include "camera_path.h"
#include "characters.h"
#include "gpu_instancing.h"
#include "layout.h"
#include "outdoor_models.h"
#include "shapes.h"
#include "solid_noise.h"
#include "walk_scene.h"

#include <foredraw/scene/turn.h>

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

constexpr double pitch = 4;         // from character to character
constexpr double way_width = 2.2;   // of what the camera's way is kept free of on either side
constexpr std::size_t patches = 8;  // of the ground, along each side
constexpr std::size_t patch_cells = 32;

/// How high the ground is. Hills are some fifty metres apart.
double ground(double x, double z) {
  return 3 * noise({x / 48, 0.5, z / 48}, 900) + .6 * noise({x / 11, 0.5, z / 11}, 901) +
         .05 * noise({x / 1.5, 0.5, z / 1.5}, 902);
}

/// One patch of a square ground; its places are those of the scene.
std::vector<ModelPart> ground_patch(double side, std::size_t column, std::size_t row) {
  SurfaceMesh soil;
  const double size = side / patches, step = size / patch_cells;
  const auto along = [&](std::size_t patch, std::size_t cell) {
    return static_cast<double>(patch * patch_cells + cell) * step - side / 2;
  };
  add_grid(
      soil, patch_cells, patch_cells,
      [&](std::size_t i, std::size_t j) {
        const double x = along(column, i), z = along(row, patch_cells - j);
        return glm::dvec3(x, ground(x, z), z);
      },
      glm::dvec2(std::floor(size / 4)));
  return {{std::move(soil), "soil"}};
}

/// From one side to the other, in bends.
CameraPath path_through(double side) {
  CameraPath path{.corners = {}, .rounding = 6, .ahead = 6};
  const double reach = std::min(.45 * side, 20.0);
  for (const auto& [x, z] : {std::pair{-1.0, -.8}, {-.45, .3}, {.1, -.45}, {.5, .5}, {1.0, .1}}) {
    path.corners.emplace_back(reach * x, 0, reach * z);
  }
  return path;
}

class Field {
 public:
  Field(const WalkOptions& options, double side) : options_(options), side_(side), path_(path_through(side)) {
    for (const glm::dvec3& place : places_on(path_, 400)) way_.emplace_back(place.x, place.z);
  }

  const CameraPath& path() const { return path_; }

  bool is_free(const glm::dvec2& at, double distance) const {
    return std::ranges::none_of(way_, [&](const glm::dvec2& place) {
      const glm::dvec2 away = place - at;
      return away.x * away.x + away.y * away.y < distance * distance;
    });
  }

  /// In rings of squares from the middle outwards, each anywhere in its cell, and a phase of its clip of its own.
  void add_characters(GltfDocument& to) const {
    std::vector<Character> kinds = all_kinds(to);
    Random random(derive_seed(options_.seed, 0x63686172, 0));
    std::uint64_t count = 0;
    for (std::int64_t ring = 0; count < options_.characters; ++ring) {
      for (std::int64_t i = -ring; i <= ring; ++i) {
        for (std::int64_t j = -ring; j <= ring; ++j) {
          if (std::max(std::abs(i), std::abs(j)) != ring || count == options_.characters) continue;
          const double x = pitch * static_cast<double>(i) + within(random, -1, 1);
          const double z = pitch * static_cast<double>(j) + within(random, -1, 1);
          if (!is_free({x, z}, way_width)) continue;
          Character& kind = kinds[random.below(kinds.size())];
          const glm::quat turn = turned(circle * random.unit());
          const std::size_t clip = random.below(kind.clips()), phase = random.below(Character::phases);
          for (const std::size_t root : kind.place({x, ground(x, z), z}, turn, clip, phase)) {
            to.json["scenes"][0]["nodes"].push_back(root);
          }
          ++count;
        }
      }
    }
  }

  /// Anywhere but on the way; each in a cell of its own kind of random numbers.
  std::vector<Placement> placements(const Kit& kit, std::size_t grounds,
                                    const std::vector<std::vector<std::size_t>>& kinds) const {
    const std::uint64_t wanted = options_.instances == 0 ? 6000 : options_.instances;
    Layout layout(kit, {.instances = std::max<std::uint64_t>(wanted, grounds), .seed = options_.seed});
    Random random = layout.random_of(0x6669656c64, 0);
    for (std::size_t patch = 0; patch < grounds; ++patch) {
      layout.add(patch, {0, 0}, 0, quarter_turn(0), glm::vec3(1), random);
    }
    while (!layout.is_full()) {
      const double what = random.unit();
      const std::size_t kind = what < .55 ? 0 : what < .85 ? 1 : what < .95 ? 2 : 3;  // grass, rocks, bushes, trees
      const double x = within(random, -.5, .5) * side_, z = within(random, -.5, .5) * side_;
      const std::size_t model = kinds[kind][random.below(kinds[kind].size())];
      const auto size = static_cast<float>(40 + random.below(49)) / 64;
      const glm::quat turn = turned(circle * random.unit());
      if (!is_free({x, z}, kind == 3 ? 6 : kind == 0 ? 1 : 2.2)) continue;
      layout.add(model, {x, z}, ground(x, z), turn, glm::vec3(size), random);
    }
    return layout.take();
  }

 private:
  std::vector<Character> all_kinds(GltfDocument& to) const {
    const auto folder = options_.corpus / "animated";
    std::vector<Character> kinds;
    kinds.emplace_back(
        to, Character::Kind{folder / "kaykit_knight.glb",
                            {"Walking_A", "Idle", "Cheer"},
                            .7f,
                            {"1H_Sword_Offhand", "Badge_Shield", "Rectangle_Shield", "Spike_Shield", "2H_Sword"}});
    kinds.emplace_back(
        to,
        Character::Kind{folder / "mannequiny.glb", {"run_root.001", "idle_root.001", "fight_idle_root.001"}, 1, {}});
    kinds.emplace_back(
        to, Character::Kind{folder / "quaternius_smooth_female_dress.glb",
                            {"HumanArmature|Female_Walk", "HumanArmature|Female_Clapping", "HumanArmature|Female_Idle"},
                            .36f,
                            {}});
    kinds.emplace_back(to, Character::Kind{folder / "fox.glb", {"Walk", "Survey", "Run"}, .01f, {}});
    return kinds;
  }

  const WalkOptions& options_;
  const double side_;
  const CameraPath path_;
  std::vector<glm::dvec2> way_;
};

}  // namespace

Scene field_walk(const WalkOptions& options) {
  GltfDocument document;
  document.json["asset"]["copyright"] =
      "'Mannequiny' by GDQuest, CC-BY 4.0; 'Fox' by PixelMannen, rig and motion by @tomkranis, conversion by "
      "@AsoboStudio and "
      "@scurest, CC-BY 4.0; 'Knight' by Kay Lousberg, CC0; 'Smooth Female Dress' by Quaternius, CC0";
  const double side = std::max(64.0, 1.3 * pitch * std::sqrt(static_cast<double>(options.characters)));
  const Field field(options, side);
  add_walk(document, field.path(), [](const glm::dvec3& at) { return ground(at.x, at.z) + 1.6; });
  field.add_characters(document);

  Palette palette(document);
  std::vector<KitDocument::Model> models;
  for (std::size_t row = 0; row < patches; ++row) {
    for (std::size_t column = 0; column < patches; ++column) {
      const std::string name = "ground " + std::to_string(row * patches + column + 1);
      models.push_back(add_model(document, palette, name, ground_patch(side, column, row)));
    }
  }
  const std::size_t grounds = models.size();
  std::vector<std::vector<std::size_t>> kinds;
  const auto add = [&](const char* name, int count, const auto& make) {
    auto& kind = kinds.emplace_back();
    for (int i = 0; i < count; ++i) {
      kind.push_back(models.size());
      const auto seed = static_cast<std::uint64_t>(i);
      models.push_back(add_model(document, palette, std::string(name) + ' ' + std::to_string(i + 1), make(seed)));
    }
  };
  add("grass", 10, [](std::uint64_t i) { return tuft(.5 + .03 * static_cast<double>(i), 1100 + i); });
  add("rock", 12, [](std::uint64_t i) { return rock(.3 + .12 * static_cast<double>(i), 1200 + i); });
  add("bush", 6, [](std::uint64_t i) { return bush(.8 + .1 * static_cast<double>(i), 1300 + i); });
  add("tree", 6, [](std::uint64_t i) { return tree(5 + .6 * static_cast<double>(i), 1400 + i); });
  const Kit kit = kit_of(document, models, "field");
  const Scene scene = placed_scene(kit, field.placements(kit, grounds, kinds), "field");
  return options.gpu_instancing ? with_gpu_instancing(scene, kit.scene.nodes.size()) : scene;
}

}  // namespace foredraw::bench
