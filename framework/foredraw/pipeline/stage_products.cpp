#include <foredraw/pipeline/stage_products.h>

#include <foredraw/pipeline/ranges.h>

#include <algorithm>
#include <stdexcept>

namespace foredraw {

void StageProducts::prove(const Scene& before, const Scene& changed) {
  for (const auto& row : rows_) {
    const ProductCard& card = row->card();
    if (!changed.products.has(card.name) || changed.products.same(card.name, before.products)) continue;
    const std::string difference = row->difference(changed);
    if (!difference.empty()) throw std::runtime_error("its " + card.title + " differ from the scene: " + difference);
    made(card.name);
  }
}

void StageProducts::settle(const Scene& before, Scene& scene) {
  tell(before.products, scene);
  leave_out_unknown(scene);
  for (const auto& row : rows_) {
    const std::string name = row->card().name;
    if (!before.products.has(name) || !scene.products.has(name) || made_.contains(name)) continue;
    for (std::string& why : row->follow(before, scene)) {
      record_.notes.push_back({"", name + "-left-out", std::move(why)});
    }
  }
  cut_clusters(scene, rows_);
  mark_held_draws(scene, rows_);
}

void StageProducts::tell(const Products& before, const Scene& scene) {
  for (const auto& row : rows_) {
    const std::string name = row->card().name;
    if (!scene.products.has(name) || scene.products.same(name, before)) continue;
    for (std::string& line : row->told(scene).lines) record_.notes.push_back({"", name, std::move(line)});
  }
}

void StageProducts::leave_out_unknown(Scene& scene) {
  std::vector<std::string> unknown;
  scene.products.each([&](const std::string& name) {
    const auto is_its = [&](const auto& row) { return row->card().name == name; };
    if (std::ranges::none_of(rows_, is_its)) unknown.push_back(name);
  });
  for (const std::string& name : unknown) {
    scene.products.erase(name);
    record_.notes.push_back(
        {"", "product-left-out", "'" + name + "' is left out: no plugin in this build can keep it up to date"});
  }
}

}  // namespace foredraw
