#include "camera_path.h"
#include "gpu_instancing.h"
#include "layout.h"
#include "outdoor_models.h"
#include "shapes.h"
#include "walk_scene.h"

#include <algorithm>
#include <cmath>

namespace foredraw::bench {

namespace {

constexpr double street = static_cast<double>(city_period) * city_tile;  // from one to the next

struct CityModels {
  std::vector<KitDocument::Model> all;
  CityDressing dressing;
};

/// What lots stand on: paving from street to street, a little above 0, where buildings have their feet.
std::vector<ModelPart> block_ground() {
  constexpr double half = street / 2 - city_tile / 2;
  SurfaceMesh paving;
  add_box(paving, {-half, -.02, -half}, {half, .02, half});
  return {{std::move(paving), "paving"}};
}

CityModels add_city_models(GltfDocument& to, const WalkOptions& options) {
  CityModels models;
  KitDocument kit(to);
  const auto folder = options.corpus / "scenes/kaykit_city";
  for (const char* name : {"bench", "building_A", "building_D", "building_H", "car_police", "car_taxi", "road_junction",
                           "streetlight", "trafficlight_A", "watertower"}) {
    models.all.push_back(kit.add(folder / (std::string(name) + ".gltf")));
  }
  Palette palette(to);
  const auto add = [&](std::vector<std::size_t>& kind, const char* name, int count, const auto& make) {
    for (int i = 0; i < count; ++i) {
      kind.push_back(models.all.size());
      const auto seed = static_cast<std::uint64_t>(i);
      models.all.push_back(add_model(to, palette, std::string(name) + ' ' + std::to_string(i + 1), make(seed)));
    }
  };
  CityDressing& dressing = models.dressing;
  add(dressing.trees, "tree", 20, [](std::uint64_t i) { return tree(1.1 + .05 * static_cast<double>(i), 100 + i); });
  add(dressing.shrubs, "bush", 10, [](std::uint64_t i) { return bush(.4 + .02 * static_cast<double>(i), 200 + i); });
  add(dressing.rocks, "rock", 16, [](std::uint64_t i) { return rock(.2 + .02 * static_cast<double>(i), 300 + i); });
  add(dressing.furniture, "street furniture", 30, [](std::uint64_t i) { return street_piece(.16, 402 + i); });
  add(dressing.statues, "statue", 8, [](std::uint64_t i) { return statue(.9, 500 + i); });
  dressing.grounds.push_back(models.all.size());
  models.all.push_back(add_model(to, palette, "ground of a block", block_ground()));
  return models;
}

/// Along the middle of streets near the middle of the city: through it low, up, and down again.
CameraPath path_through(const std::vector<Placement>& placements) {
  float most = 0;
  for (const Placement& placement : placements) most = std::max(most, placement.transform.translation.x);
  const double blocks = std::floor(static_cast<double>(most) / street);
  const double x = street * std::floor(blocks / 2), z = x;
  return {.corners = {{x, .62, z - 1.9 * street},
                      {x, .62, z - .6 * street},
                      {x, .8, z},
                      {x + street, 2.2, z},
                      {x + street, 1.2, z + street},
                      {x + 1.6 * street, .62, z + street}},
          .rounding = 1.6,
          .ahead = 3};
}

}  // namespace

Scene city_walk(const WalkOptions& options) {
  GltfDocument document;
  const CityModels models = add_city_models(document, options);
  const LayoutOptions layout{.instances = options.instances == 0 ? 100'000 : options.instances, .seed = options.seed};
  // Where things stand is known from the models alone; the camera, which depends on it, joins the document then.
  const std::vector<Placement> placements = city_layout(kit_of(document, models.all, "city"), layout, models.dressing);
  add_walk(document, path_through(placements));
  const Kit kit = kit_of(document, models.all, "city");
  const Scene scene = placed_scene(kit, placements, "city");
  return options.gpu_instancing ? with_gpu_instancing(scene, kit.scene.nodes.size()) : scene;
}

}  // namespace foredraw::bench
