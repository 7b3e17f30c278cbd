#include "palette.h"

#include <algorithm>
#include <stdexcept>

namespace foredraw::bench {

namespace {

std::vector<Surface> all_surfaces() {
  return {
      {.name = "bark", .dark = {.16, .10, .06}, .light = {.48, .36, .25}, .pattern = bark_pattern(), .bump = 3},
      {.name = "leaves", .dark = {.08, .22, .05}, .light = {.38, .58, .18}, .pattern = leaf_pattern(), .bump = 2},
      {.name = "young leaves", .dark = {.24, .36, .06}, .light = {.62, .70, .24}, .pattern = leaf_pattern()},
      {.name = "grass",
       .dark = {.16, .34, .08},
       .light = {.50, .66, .22},
       .pattern = leaf_pattern(),
       .is_double_sided = true},
      {.name = "stone", .dark = {.26, .25, .24}, .light = {.70, .68, .63}, .pattern = stone_pattern(), .bump = 3},
      {.name = "marble",
       .dark = {.52, .52, .56},
       .light = {.94, .93, .90},
       .pattern = marble_pattern(),
       .bump = 0.5,
       .roughness = 0.3},
      {.name = "planks",
       .dark = {.20, .12, .07},
       .light = {.62, .42, .26},
       .pattern = plank_pattern(),
       .bump = 2,
       .roughness = 0.5},
      {.name = "plaster", .dark = {.62, .58, .50}, .light = {.96, .93, .86}, .pattern = plaster_pattern(), .bump = 4},
      {.name = "cloth", .dark = {.10, .14, .30}, .light = {.42, .50, .74}, .pattern = cloth_pattern(), .bump = 2},
      {.name = "red cloth", .dark = {.28, .06, .06}, .light = {.76, .28, .22}, .pattern = cloth_pattern(), .bump = 2},
      {.name = "paving", .dark = {.24, .22, .20}, .light = {.72, .66, .58}, .pattern = paving_pattern(), .bump = 3},
      {.name = "soil", .dark = {.16, .20, .07}, .light = {.46, .48, .22}, .pattern = soil_pattern(), .bump = 2},
      {.name = "iron", .light = {.22, .23, .25}, .roughness = 0.45, .metallic = 1},
      {.name = "brass", .light = {.80, .62, .30}, .roughness = 0.3, .metallic = 1},
      {.name = "red paint", .light = {.66, .08, .06}, .roughness = 0.35},
      {.name = "green paint", .light = {.10, .34, .22}, .roughness = 0.4},
      {.name = "white glaze", .light = {.90, .90, .86}, .roughness = 0.2},
      {.name = "blue glaze", .light = {.12, .24, .56}, .roughness = 0.2},
      {.name = "ceiling", .light = {.92, .92, .90}, .roughness = 0.9},
  };
}

}  // namespace

std::size_t Palette::operator[](std::string_view name) {
  if (const auto known = added_.find(name); known != added_.end()) return known->second;
  const std::vector<Surface> surfaces = all_surfaces();
  const auto found = std::ranges::find(surfaces, name, &Surface::name);
  if (found == surfaces.end()) throw std::runtime_error("there is no material '" + std::string(name) + "'");
  return added_[std::string(name)] = add_surface(to_, *found);
}

KitDocument::Model add_model(GltfDocument& to, Palette& palette, std::string name, std::vector<ModelPart> parts) {
  GltfDocument::Json primitives = GltfDocument::Json::array();
  for (ModelPart& part : parts) {
    finish(part.mesh);
    primitives.push_back(add_primitive(to, part.mesh, palette[part.material]));
  }
  const std::size_t mesh = to.add("meshes", {{"name", name}, {"primitives", std::move(primitives)}});
  KitDocument::Model model{std::move(name), {}};
  model.nodes.emplace_back().mesh = mesh;
  return model;
}

}  // namespace foredraw::bench
