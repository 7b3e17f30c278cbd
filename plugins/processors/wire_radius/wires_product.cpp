#include "wires_product.h"

#include "schemas.h"
#include "wire_streams.h"

#include <foredraw/base/counted.h>
#include <foredraw/scene/moves.h>
#include <foredraw/wires/wire_shader.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

constexpr std::uint32_t most_texcoords = 1000;

std::optional<WireKind> kind_of(const ExtensionValue* value) {
  for (const WireKind kind : {WireKind::tube, WireKind::ribbon, WireKind::net}) {
    if (value != nullptr && value->text() != nullptr && *value->text() == text_of(kind)) return kind;
  }
  return std::nullopt;
}

/// Above 0, and a float.
std::optional<float> size_of(const ExtensionValue* value) {
  const auto number = value == nullptr ? std::nullopt : value->number();
  if (!number || !(static_cast<float>(*number) > 0) || !std::isfinite(static_cast<float>(*number))) return std::nullopt;
  return static_cast<float>(*number);
}

std::optional<Wire> wire_of(const ExtensionValue& value) {
  const ExtensionValue* triangles = value.member("triangles");
  const ExtensionValue* closed = value.member("closed");
  const std::uint32_t count = triangles == nullptr ? 0 : triangles->whole().value_or(0);
  const auto kind = kind_of(value.member("kind"));
  const auto length = size_of(value.member("length")), radius = size_of(value.member("radius"));
  const bool* is_closed = closed == nullptr ? nullptr : std::get_if<bool>(&closed->any());
  if (count == 0 || !kind || !length || !radius || (closed != nullptr && is_closed == nullptr)) {
    return std::nullopt;
  }
  return Wire{count, *kind, *length, *radius, is_closed != nullptr && *is_closed};
}

ExtensionValue value_of(const Wire& wire) {
  Members members{{"triangles", wire.triangles},
                  {"kind", std::string(text_of(wire.kind))},
                  {"length", wire.length},
                  {"radius", wire.radius}};
  if (wire.closed) members.emplace_back("closed", true);
  return members;
}

std::string difference_of(const DrawWires& of, const Scene& scene) {
  if (of.draw >= scene.draws.size()) return "a draw of theirs is gone";
  const Level& level = scene.draws[of.draw].full();
  const std::string& name = scene.draws[of.draw].name;
  const std::size_t triangles = level.stream().triangle_count();
  std::uint64_t sum = of.first_triangle;
  for (const Wire& wire : of.wires) sum += wire.triangles;
  if (of.wires.empty() || sum != triangles) return name + " has a different number of triangles";
  const auto rows = processors::wire_radius::wire_rows(*level.vertices, of.texcoords);
  if (!rows) return name + " lacks one of their streams, or it has another type";
  const auto indices = level.stream().indices.view();
  for (std::size_t t = 0; t < triangles; ++t) {
    bool all = true, moves = false;
    for (std::size_t i = 3 * t; i < 3 * t + 3; ++i) {
      all &= (*rows)[indices[i]].w != 0;
      moves |= (*rows)[indices[i]].w > 0;
    }
    if (t < of.first_triangle ? moves : !all || !moves) {
      return fmt::format(
          "triangle {} of {} is {}", t, name,
          t < of.first_triangle ? "not in a wire, but one of its vertices is" : "in a wire, but its vertices are not");
    }
  }
  return {};
}

/// Takes the streams of these draws away, except where another draw with wires has the same.
void take_streams(const std::vector<DrawWires>& lost, const std::vector<DrawWires>& kept, Scene& scene) {
  std::map<const VertexStreams*, std::shared_ptr<const VertexStreams>> without;
  const auto is_kept = [&](const VertexStreams* streams) {
    return std::ranges::any_of(
        kept, [&](const DrawWires& of) { return scene.draws[of.draw].full().vertices.get() == streams; });
  };
  for (const DrawWires& of : lost) {
    const VertexStreams* streams = of.draw < scene.draws.size() ? scene.draws[of.draw].full().vertices.get() : nullptr;
    if (streams == nullptr || is_kept(streams)) continue;
    const bool has_any =
        of.texcoords || streams->find(wire_semantic) != nullptr || streams->find(wire_axis_semantic) != nullptr;
    if (has_any) without.try_emplace(streams, processors::wire_radius::without_wire_streams(*streams, of.texcoords));
  }
  for (Draw& draw : scene.draws) {
    for (Level& level : draw.levels) {
      const auto now = without.find(level.vertices.get());
      if (now != without.end()) level.vertices = now->second;
    }
  }
}

class WiresRow final : public ProductRow {
 public:
  WiresRow()
      : ProductRow({.name = std::string(Wires::product),
                    .title = "wires",
                    .extension = "FOREDRAW_wires",
                    .remedy = "run wire-radius again",
                    .schemas = schemas(),
                    .side_files = {{".glsl"}, {".hlsl"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    Wires wires;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      const std::string& name = scene.draws[id].name;
      if (!from.is_list(id)) return name + " is not a list of triangles";
      const ExtensionValue *first = value->member("firstTriangle"), *list = value->member("wires");
      const auto number = first == nullptr ? std::nullopt : first->whole();
      if (!number) return name + " has no 'firstTriangle', a whole number";
      if (list == nullptr || list->list() == nullptr) return name + " has no array 'wires'";
      const ExtensionValue* texcoords = value->member("texcoords");
      if (texcoords != nullptr && (!texcoords->whole() || *texcoords->whole() > most_texcoords))
        return name + " has 'texcoords' that are no set's number";
      DrawWires of{id, *number, {}, texcoords == nullptr ? std::nullopt : texcoords->whole()};
      for (const ExtensionValue& one : *list->list()) {
        const auto wire = wire_of(one);
        if (!wire)
          return fmt::format(
              "wire {} of {} lacks 'triangles', 'kind', 'length' or 'radius', or one of them is out of range",
              of.wires.size(), name);
        of.wires.push_back(*wire);
      }
      wires.draws.push_back(std::move(of));
    }
    if (wires.draws.empty()) return "no primitive has wires";
    scene.products.set(std::move(wires));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const DrawWires& of : scene.products.find<Wires>()->draws) {
      Members members{{"firstTriangle", of.first_triangle}, {"wires", listed(of.wires, value_of)}};
      if (of.texcoords) members.emplace_back("texcoords", *of.texcoords);
      to.put_on_draw(of.draw, std::move(members));
    }
  }

  std::string difference(const Scene& scene) const override {
    for (const DrawWires& of : scene.products.find<Wires>()->draws) {
      if (std::string why = difference_of(of, scene); !why.empty()) return why;
    }
    return {};
  }

  std::vector<std::uint32_t> bounds(const Scene& scene, DrawLevel at) const override {
    if (at.level != 0) return {};
    for (const DrawWires& of : scene.products.find<Wires>()->draws) {
      if (of.draw == at.draw) return {of.first_triangle};
    }
    return {};
  }

  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    const Wires& wires = *after.products.find<Wires>();
    const Wires* was = before.products.find<Wires>();
    Wires left;
    std::vector<DrawWires> lost;
    std::vector<std::string> told;
    for (const DrawWires& of : wires.draws) {
      const bool is_new = was == nullptr || std::ranges::find(was->draws, of) == was->draws.end();
      std::optional<DrawWires> now = is_new ? of : moved(of, before, after);
      std::string why = now ? difference_of(*now, after) : "its triangles were replaced";
      if (why.empty()) {
        left.draws.push_back(std::move(*now));
        continue;
      }
      lost.push_back(of);
      told.push_back("the wires of " + (of.draw < before.draws.size() ? before.draws[of.draw].name : "a draw") +
                     " are left out: " + why);
    }
    take_streams(lost, left.draws, after);
    if (left.draws.empty()) {
      after.products.erase(Wires::product);
    } else {
      after.products.set(std::move(left));
    }
    return told;
  }

  void leave_out(Scene& scene) const override {
    take_streams(scene.products.find<Wires>()->draws, {}, scene);
    scene.products.erase(Wires::product);
  }

  /// The same for every scene: what it draws comes with the vertices.
  SideFile side_file(const Scene&, std::string_view extension, const std::string&) const override {
    return {.content = wire_shader_text(extension == ".hlsl" ? ShaderLanguage::hlsl : ShaderLanguage::glsl)};
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{
        .heading = "wires (the last triangles of their draws, with centre line and half width in each vertex)",
        .value = List()};
    for (const DrawWires& of : scene.products.find<Wires>()->draws) {
      std::size_t kinds[3] = {0, 0, 0};
      double length = 0, least = of.wires.front().radius, most = least;
      for (const Wire& wire : of.wires) {
        ++kinds[static_cast<std::size_t>(wire.kind)];
        length += wire.length;
        least = std::min(least, double{wire.radius});
        most = std::max(most, double{wire.radius});
      }
      const std::string& name = scene.draws[of.draw].name;
      const std::size_t triangles = scene.draws[of.draw].full().stream().triangle_count();
      text.lines.push_back(
          fmt::format("{}: {}, {} and {}, together {:.4g} units long, radius {:.4g} to {:.4g}; {} of {} triangles",
                      name, counted(kinds[0], "tube"), counted(kinds[1], "ribbon"), counted(kinds[2], "net"), length,
                      least, most, triangles - of.first_triangle, triangles));
      if (of.texcoords) {
        text.lines.back() += fmt::format("; in TEXCOORD_{} to TEXCOORD_{}", *of.texcoords, *of.texcoords + 3);
      }
      text.value.push(Members{{"draw", name},
                              {"firstTriangle", of.first_triangle},
                              {"tubes", kinds[0]},
                              {"ribbons", kinds[1]},
                              {"nets", kinds[2]},
                              {"length", length}});
    }
    return text;
  }

 private:
  static std::optional<DrawWires> moved(const DrawWires& of, const Scene& before, const Scene& after) {
    if (of.draw >= before.draws.size() || of.draw >= after.draws.size()) return std::nullopt;
    const IndexStream &was = before.draws[of.draw].full().stream(), &is = after.draws[of.draw].full().stream();
    if (was.triangle_count() != is.triangle_count()) return std::nullopt;
    const std::uint32_t bound[] = {of.first_triangle};
    const auto bounds = moved_bounds(bound, was, is);
    if (!bounds) return std::nullopt;
    DrawWires now = of;
    now.first_triangle = bounds->front();
    return now;
  }
};

}  // namespace

std::shared_ptr<const ProductRow> wires_product() { return std::make_shared<const WiresRow>(); }

}  // namespace foredraw
