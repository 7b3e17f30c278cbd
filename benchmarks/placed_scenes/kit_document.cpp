#include "kit_document.h"

#include "gltf_copier.h"

namespace foredraw::bench {

namespace {

namespace fs = std::filesystem;
using Json = KitDocument::Json;
using Model = KitDocument::Model;

/// The model of one file.
class Addition {
 public:
  Addition(GltfDocument& to, const fs::path& file)
      : name_(file.stem().string()), from_(GltfDocument::opened(file)), copier_(to, from_, file.parent_path()) {}

  Model model() {
    Model model{name_, {}};
    const Json& scene = from_.json.at("scenes").at(from_.json.value("scene", std::size_t{0}));
    add_node(scene.at("nodes").at(0).get<std::size_t>(), model);
    model.nodes[0].placement = Json::object();
    copier_.list_extensions();
    return model;
  }

 private:
  std::size_t add_node(std::size_t number, Model& model) {
    const Json& from = from_.json.at("nodes").at(number);
    const std::size_t made = model.nodes.size();
    model.nodes.emplace_back();
    for (const char* key : {"translation", "rotation", "scale"}) {
      if (from.contains(key)) model.nodes[made].placement[key] = from[key];
    }
    const std::string own = from.value("name", std::string("part"));
    const std::string name = own == model.name ? own : model.name + '/' + own;
    if (from.contains("mesh")) model.nodes[made].mesh = copier_.mesh(from["mesh"].get<std::size_t>(), name);
    if (!from.contains("children")) return made;
    for (const Json& child : from["children"]) {
      const std::size_t added = add_node(child.get<std::size_t>(), model);
      model.nodes[made].children.push_back(added);
    }
    return made;
  }

  const std::string name_;
  const GltfDocument::Opened from_;
  GltfCopier copier_;
};

}  // namespace

KitDocument::Model KitDocument::add(const fs::path& file) { return Addition(to_, file).model(); }

}  // namespace foredraw::bench
