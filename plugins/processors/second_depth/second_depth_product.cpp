#include "second_depth_product.h"

#include "schemas.h"
#include "second_depth.h"
#include "second_depth_shader.h"

#include <foredraw/scene/moves.h>
#include <foredraw/shells/second_depth.h>

#include <algorithm>

namespace foredraw {

namespace {

using Members = ExtensionValue::Members;

class SecondDepthRow final : public ProductRow {
 public:
  SecondDepthRow()
      : ProductRow({.name = std::string(SecondDepth::product),
                    .title = "second depth",
                    .extension = "FOREDRAW_second_depth",
                    .remedy = "run second-depth again",
                    .schemas = schemas(),
                    .side_files = {{".glsl"}, {".hlsl"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    SecondDepth all;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      const ExtensionValue* triangles = value->member("triangles");
      if (triangles == nullptr || !triangles->whole() || *triangles->whole() == 0) {
        return scene.draws[id].name + " has no whole number above 0 in 'triangles'";
      }
      all.draws.push_back({id, *triangles->whole()});
    }
    scene.products.set(std::move(all));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const SecondDepth::OfDraw& of : scene.products.find<SecondDepth>()->draws) {
      to.put_on_draw(of.draw, Members{{"triangles", of.triangles}});
    }
  }

  std::string difference(const Scene& scene) const override {
    const SecondDepth& all = *scene.products.find<SecondDepth>();
    for (const SecondDepth::OfDraw& of : all.draws) {
      if (of.draw >= scene.draws.size()) return "a draw of it is gone";
    }
    for (const std::vector<SecondDepth::OfDraw>& mesh : by_mesh(scene, all.draws)) {
      if (std::string why = why_not(scene, mesh); !why.empty()) return why;
    }
    return {};
  }

  std::vector<std::uint32_t> bounds(const Scene& scene, DrawLevel at) const override {
    const std::uint32_t triangles = scene.products.find<SecondDepth>()->triangles_of(at.draw);
    if (at.level > 0 || triangles == 0) return {};
    return {triangles};
  }

  /// What is left in front of each draw, if that is still closed.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    SecondDepth now, left;
    for (const SecondDepth::OfDraw& of : before.products.find<SecondDepth>()->draws) {
      if (of.draw >= after.draws.size()) continue;
      const std::uint32_t kept =
          kept_first(of.triangles, before.draws[of.draw].full().stream(), after.draws[of.draw].full().stream());
      if (kept > 0) now.draws.push_back({of.draw, kept});
    }
    std::vector<std::string> told;
    for (const std::vector<SecondDepth::OfDraw>& mesh : by_mesh(after, now.draws)) {
      const std::string why = why_not(after, mesh);
      if (why.empty()) {
        left.draws.insert(left.draws.end(), mesh.begin(), mesh.end());
      } else {
        told.push_back("second depth is left out: " + why + "; " + card().remedy);
      }
    }
    for (const SecondDepth::OfDraw& of : before.products.find<SecondDepth>()->draws) {
      if (now.triangles_of(of.draw) > 0) continue;
      told.push_back("second depth of " + before.draws[of.draw].name + " is left out: its triangles were replaced; " +
                     card().remedy);
    }
    std::ranges::sort(left.draws, {}, &SecondDepth::OfDraw::draw);
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  SideFile side_file(const Scene&, std::string_view extension, const std::string&) const override {
    return {.content = second_depth_shader_text(extension == ".hlsl" ? ShaderLanguage::hlsl : ShaderLanguage::glsl)};
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "second depth (closed shells come first, for a pass with front faces culled)",
                     .value = ExtensionValue::List()};
    for (const SecondDepth::OfDraw& of : scene.products.find<SecondDepth>()->draws) {
      const Draw& draw = scene.draws[of.draw];
      text.lines.push_back(draw.name + ": the first " + std::to_string(of.triangles) + " of " +
                           std::to_string(draw.full().stream().triangle_count()) + " triangles are closed");
      text.value.push(Members{{"draw", draw.name}, {"triangles", of.triangles}});
    }
    return text;
  }

 private:
  /// Draws that no mesh holds stand by themselves.
  static std::vector<std::vector<SecondDepth::OfDraw>> by_mesh(const Scene& scene,
                                                               std::vector<SecondDepth::OfDraw> draws) {
    std::vector<std::vector<SecondDepth::OfDraw>> meshes;
    for (const Mesh& mesh : scene.meshes) {
      std::vector<SecondDepth::OfDraw> of_mesh;
      std::erase_if(draws, [&](const SecondDepth::OfDraw& of) {
        const bool is_its = std::ranges::find(mesh.draws, of.draw) != mesh.draws.end();
        if (is_its) of_mesh.push_back(of);
        return is_its;
      });
      if (!of_mesh.empty()) meshes.push_back(std::move(of_mesh));
    }
    for (const SecondDepth::OfDraw& of : draws) meshes.push_back({of});
    return meshes;
  }

  static std::string why_not(const Scene& scene, const std::vector<SecondDepth::OfDraw>& mesh) {
    std::vector<DrawId> draws;
    std::vector<std::uint32_t> triangles;
    for (const SecondDepth::OfDraw& of : mesh) {
      const Draw& draw = scene.draws[of.draw];
      if (of.triangles > draw.full().stream().triangle_count()) {
        return draw.name + " has " + std::to_string(draw.full().stream().triangle_count()) + " triangles, not " +
               std::to_string(of.triangles);
      }
      if (std::string why = why_not_in_second_depth(scene, of.draw); !why.empty()) return draw.name + ' ' + why;
      draws.push_back(of.draw);
      triangles.push_back(of.triangles);
    }
    Analyses analyses;
    for (const DrawShells& draw : shells_of(scene, draws, triangles, analyses)) {
      const bool is_closed = std::ranges::all_of(draw.kinds, [](processors::second_depth::Kind kind) {
        return kind == processors::second_depth::Kind::closed;
      });
      if (!is_closed) return "the first triangles of " + scene.draws[draw.draw].name + " are not closed shells";
    }
    return {};
  }
};

}  // namespace

std::shared_ptr<const ProductRow> second_depth_product() { return std::make_shared<const SecondDepthRow>(); }

}  // namespace foredraw
