#include "landmarks.h"

#include <foredraw/scene/moves.h>

#include "schemas.h"

namespace foredraw::testing {

namespace {

using Members = ExtensionValue::Members;

class LandmarksRow final : public ProductRow {
 public:
  LandmarksRow()
      : ProductRow({.name = std::string(Landmarks::product),
                    .title = "landmarks",
                    .extension = "EXAMPLE_landmarks",
                    .remedy = "set them again",
                    .accessors_of_file = {"draws/*/vertices", "draws/*/triangles", "draws/*/parts"},
                    .schemas = schemas(),
                    .side_files = {{".csv"}, {".json", ".bin"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    const ExtensionValue* file = from.of_file();
    const ExtensionValue* draws = file == nullptr ? nullptr : file->member("draws");
    if (draws == nullptr || draws->list() == nullptr) return "it has no array 'draws'";
    Landmarks landmarks;
    for (const ExtensionValue& one : *draws->list()) {
      const auto numbers = [&](const char* name, std::vector<std::uint32_t>& to) {
        const ExtensionValue* value = one.member(name);
        const auto data = value != nullptr && value->whole() ? from.accessor(*value->whole()) : std::nullopt;
        if (!data || data->format.component != Component::uint32) return false;
        to.resize(data->count);
        std::memcpy(to.data(), data->bytes.view().data(), data->bytes.size());
        return true;
      };
      const ExtensionValue* draw = one.member("draw");
      Landmarks::OfDraw of;
      if (draw == nullptr || !draw->whole() || !numbers("vertices", of.vertices) ||
          !numbers("triangles", of.triangles)) {
        return "a draw of it is no draw";
      }
      if (one.member("parts") != nullptr && !numbers("parts", of.parts)) return "its parts are no numbers";
      of.draw = *draw->whole();
      landmarks.draws.push_back(std::move(of));
    }
    scene.products.set(std::move(landmarks));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    to.put_on_file(Members{
        {"draws", listed(scene.products.find<Landmarks>()->draws, [&](const Landmarks::OfDraw& of) {
           const auto numbers = [&](const std::vector<std::uint32_t>& values) {
             return to.accessor(accessor_data(std::span(values), Component::uint32, 1));
           };
           Members members{{"draw", of.draw}, {"vertices", numbers(of.vertices)}, {"triangles", numbers(of.triangles)}};
           if (!of.parts.empty()) members.emplace_back("parts", numbers(of.parts));
           return members;
         })}});
  }

  std::string difference(const Scene& scene) const override {
    for (const Landmarks::OfDraw& of : scene.products.find<Landmarks>()->draws) {
      if (of.draw >= scene.draws.size()) return "a draw of them is gone";
      const Level& level = scene.draws[of.draw].levels[0];
      for (const std::uint32_t v : of.vertices) {
        if (v >= level.vertices->count) return scene.draws[of.draw].name + " has no vertex " + std::to_string(v);
      }
      for (const std::uint32_t t : of.triangles) {
        if (t >= level.orders[0].triangle_count())
          return scene.draws[of.draw].name + " has no triangle " + std::to_string(t);
      }
    }
    return {};
  }

  std::vector<std::uint32_t> bounds(const Scene& scene, DrawLevel at) const override {
    for (const Landmarks::OfDraw& of : scene.products.find<Landmarks>()->draws) {
      if (of.draw != at.draw || of.parts.empty()) continue;
      if (at.level == 0) return of.parts;
      return {static_cast<std::uint32_t>(scene.draws[at.draw].levels[at.level].stream().triangle_count() / 2)};
    }
    return {};
  }

  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    Landmarks landmarks = *after.products.find<Landmarks>();
    for (Landmarks::OfDraw& of : landmarks.draws) {
      const bool is_there = of.draw < before.draws.size() && of.draw < after.draws.size();
      const auto vertices =
          is_there ? vertex_moves(before.draws[of.draw].levels[0], after.draws[of.draw].levels[0]) : std::nullopt;
      const auto triangles =
          is_there ? triangle_moves(before.draws[of.draw].levels[0].orders[0], after.draws[of.draw].levels[0].orders[0])
                   : std::nullopt;
      if (!vertices || !triangles) {
        leave_out(after);
        return {"the landmarks are left out: draw " + std::to_string(of.draw) + " was made anew"};
      }
      auto parts =
          moved_bounds(of.parts, before.draws[of.draw].levels[0].orders[0], after.draws[of.draw].levels[0].orders[0]);
      if (!parts) {
        leave_out(after);
        return {"the landmarks are left out: a triangle went from part to part"};
      }
      of.parts = std::move(*parts);
      for (std::uint32_t& v : of.vertices) v = (*vertices)[v];
      for (std::uint32_t& t : of.triangles) t = (*triangles)[t];
      std::erase(of.vertices, no_vertex);
    }
    after.products.set(std::move(landmarks));
    return {};
  }

  SideFile side_file(const Scene& scene, std::string_view extension, const std::string& beside) const override {
    std::string csv = "draw,vertices\n";
    for (const Landmarks::OfDraw& of : scene.products.find<Landmarks>()->draws) {
      csv += std::to_string(of.draw) + ',' + std::to_string(of.vertices.size()) + '\n';
    }
    if (extension == ".csv") return {.content = csv};
    return {.content = ExtensionValue(Members{{"buffer", beside}}), .beside = std::vector<std::byte>(4)};
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "landmarks (known places)", .value = ExtensionValue::List()};
    for (const Landmarks::OfDraw& of : scene.products.find<Landmarks>()->draws) {
      text.lines.push_back(scene.draws[of.draw].name + ": " + std::to_string(of.vertices.size()) + " vertices");
      text.value.push(Members{{"draw", scene.draws[of.draw].name}});
    }
    return text;
  }
};

struct LandmarksOptions {
  bool wrong = false;
  bool parts = false;
};

class MakeLandmarks final : public Processor {
 public:
  explicit MakeLandmarks(LandmarksOptions options) : options_(options) {}

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run&) const override {
    Landmarks landmarks;
    for (const DrawId id : draws) {
      const Level& level = scene.draws[id].levels[0];
      const auto last = static_cast<std::uint32_t>(level.orders[0].triangle_count() - 1);
      landmarks.draws.push_back(
          {id, {level.vertices->count / 3, level.vertices->count - (options_.wrong ? 0 : 1)}, {0, last}});
      if (options_.parts) landmarks.draws.back().parts = {(last + 1) / 3};
    }
    scene.products.set(std::move(landmarks));
    return draws;
  }

 private:
  LandmarksOptions options_;
};

}  // namespace

Plugin landmarks_plugin() {
  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "landmarks", .summary = "Remembers places", .reference = "own", .acts_on = {traits::triangles}};
  plugin.card.lossless = true;
  plugin.products = {std::make_shared<const LandmarksRow>()};
  OptionTable<LandmarksOptions> table;
  table.row(&LandmarksOptions::wrong, "wrong", "Name a vertex that there is not");
  table.row(&LandmarksOptions::parts, "parts", "Part the triangles");
  bind_options(plugin, table, [](const LandmarksOptions& options) { return std::make_unique<MakeLandmarks>(options); });
  return plugin;
}

}  // namespace foredraw::testing
