#include "tessellation_levels_product.h"

#include "schemas.h"
#include "tessellation_levels.h"

#include <foredraw/scene/moves.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

constexpr std::uint32_t triangles_of_range = 128;

bool is_displaced_alike(const Scene& a, const Scene& b, DrawId draw) {
  const Material *x = a.material_of(a.draws[draw]), *y = b.material_of(b.draws[draw]);
  return x != nullptr && y != nullptr && x->displacement && y->displacement && *x->displacement == *y->displacement;
}

/// With the triangles where they are now; a range of displacements covers what those of its triangles did.
std::optional<DrawTessellation> moved(const DrawTessellation& of, const IndexStream& before, const IndexStream& after) {
  if (after.indices.is(before.indices)) return of;
  const auto moves = triangle_moves(before, after);
  if (!moves || moves->size() != of.levels.size()) return std::nullopt;
  DrawTessellation now{.draw = of.draw, .scales = of.scales};
  std::vector<LogLevels> levels(of.levels.size());
  for (std::size_t t = 0; t < levels.size(); ++t) levels[(*moves)[t]] = of.levels.view()[t];
  std::vector<std::uint32_t> begins = after.clusters ? range_begins(after) : std::vector<std::uint32_t>();
  if (begins.empty()) begins.assign(of.range_begins.view().begin(), of.range_begins.view().end());
  std::vector<DisplacementRange> ranges(begins.size(), {INFINITY, -INFINITY});
  const auto range_at = [](std::span<const std::uint32_t> all, std::uint32_t triangle) {
    return static_cast<std::size_t>(std::ranges::upper_bound(all, triangle) - all.begin()) - 1;
  };
  for (std::uint32_t t = 0; t < levels.size(); ++t) {
    const DisplacementRange& was = of.ranges.view()[range_at(of.range_begins.view(), t)];
    DisplacementRange& is = ranges[range_at(begins, (*moves)[t])];
    is = {std::min(is.least, was.least), std::max(is.most, was.most)};
  }
  now.levels = Shared(std::move(levels));
  now.range_begins = Shared(std::move(begins));
  now.ranges = Shared(std::move(ranges));
  return now;
}

class TessellationRow final : public ProductRow {
 public:
  TessellationRow()
      : ProductRow({.name = std::string(StoredTessellations::product),
                    .title = "tessellation levels",
                    .extension = "FOREDRAW_tessellation_levels",
                    .remedy = "run tessellation-levels again",
                    .accessors_of_draw = {"levels", "ranges/begins", "ranges/displacements"},
                    .schemas = schemas(),
                    .side_files = {{".json", ".bin"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override {
    StoredTessellations stored;
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      DrawTessellation of{.draw = id};
      std::string why =
          from.is_list(id) ? read_tessellation(from, *value, of) : "is not a list of triangles with indices";
      if (!why.empty()) return scene.draws[id].name + ' ' + why;
      stored.draws.push_back(std::move(of));
    }
    if (stored.draws.empty()) return "no primitive has levels";
    scene.products.set(std::move(stored));
    return {};
  }

  void write(const Scene& scene, ExtensionWriter& to) const override {
    for (const DrawTessellation& of : scene.products.find<StoredTessellations>()->draws) {
      const auto bytes = std::as_bytes(of.levels.view());
      const AccessorData levels{
          {Component::uint8, 4, false, 4}, of.levels.size(), Shared<std::byte>({bytes.begin(), bytes.end()})};
      const auto pairs = std::as_bytes(of.ranges.view());
      const AccessorData ranges{
          {Component::float32, 2, false, 8}, of.ranges.size(), Shared<std::byte>({pairs.begin(), pairs.end()})};
      to.put_on_draw(of.draw, Members{{"levels", to.accessor(levels)},
                                      {"scales", scales(of)},
                                      {"ranges", Members{{"begins", to.accessor(accessor_data(of.range_begins.view(),
                                                                                              Component::uint32, 1))},
                                                         {"displacements", to.accessor(ranges)}}}});
    }
  }

  std::string difference(const Scene& scene) const override {
    const StoredTessellations& stored = *scene.products.find<StoredTessellations>();
    for (const DrawTessellation& of : stored.draws) {
      if (of.draw >= scene.draws.size()) return "a draw of theirs is gone";
      if (std::string why = tessellation_difference(of, scene); !why.empty())
        return "those of " + scene.draws[of.draw].name + ' ' + why;
    }
    return tessellation_disagreement(stored, scene);
  }

  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    const StoredTessellations& stored = *after.products.find<StoredTessellations>();
    StoredTessellations left;
    std::vector<std::string> told;
    for (const DrawTessellation& of : stored.draws) {
      const std::string of_whom = of.draw < before.draws.size() ? before.draws[of.draw].name : "a draw";
      std::optional<DrawTessellation> now;
      std::string why = "it is gone";
      if (of.draw < before.draws.size() && of.draw < after.draws.size()) {
        why = "its displacement has changed";
        if (is_displaced_alike(before, after, of.draw)) {
          now = moved(of, before.draws[of.draw].full().stream(), after.draws[of.draw].full().stream());
          why = now ? tessellation_difference(*now, after) : "its triangles were replaced";
          if (!why.empty()) now.reset();
        }
      }
      if (now) {
        left.draws.push_back(std::move(*now));
      } else {
        told.push_back("the tessellation levels of " + of_whom + " are left out: " + why);
      }
    }
    const bool is_empty = left.draws.empty();
    put_left(after, std::move(left), is_empty);
    return told;
  }

  /// The rows lie in the file beside it: draw by draw the levels, 4 bytes each, and then pairs of floats.
  SideFile side_file(const Scene& scene, std::string_view, const std::string& beside) const override {
    SideFile file;
    const auto add = [&](std::span<const std::byte> bytes) {
      const std::size_t at = file.beside.size();
      file.beside.insert(file.beside.end(), bytes.begin(), bytes.end());
      return at;
    };
    List draws;
    for (const DrawTessellation& of : scene.products.find<StoredTessellations>()->draws) {
      const auto begins = of.range_begins.view();
      Members value{{"name", scene.draws[of.draw].name},
                    {"triangles", of.levels.size()},
                    {"levels", add(std::as_bytes(of.levels.view()))},
                    {"displacements", add(std::as_bytes(of.ranges.view()))},
                    {"begins", List(begins.begin(), begins.end())},
                    {"scales", scales(of)}};
      draws.push_back(std::move(value));
    }
    file.content = ExtensionValue(
        Members{{"tessellation-levels", 1}, {"file", scene.name}, {"buffer", beside}, {"draws", std::move(draws)}});
    return file;
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "tessellation levels (parts of edges by what the map of heights shows)",
                     .value = List()};
    for (const DrawTessellation& of : scene.products.find<StoredTessellations>()->draws) {
      const std::string& name = scene.draws[of.draw].name;
      const TessellationScale &finest = of.scales.front(), &undivided = of.scales.back();
      text.lines.push_back(fmt::format(
          "{}: {} triangles from {}, error rms {:.4g} (undivided {:.4g}), largest {:.4g} (undivided {:.4g}); "
          "scales {}, ranges {}",
          name, finest.triangles, of.levels.size(), finest.rms, undivided.rms, finest.largest, undivided.largest,
          of.scales.size(), of.ranges.size()));
      text.value.push(
          Members{{"draw", name}, {"source", of.levels.size()}, {"scales", scales(of)}, {"ranges", of.ranges.size()}});
    }
    return text;
  }

 private:
  static List scales(const DrawTessellation& of) {
    return listed(of.scales, [](const TessellationScale& scale) {
      return Members{{"triangles", scale.triangles}, {"rms", scale.rms}, {"largest", scale.largest}};
    });
  }
};

}  // namespace

std::shared_ptr<const ProductRow> tessellation_levels_product() { return std::make_shared<const TessellationRow>(); }

std::vector<std::uint32_t> range_begins(const IndexStream& stream) {
  std::vector<std::uint32_t> begins;
  if (stream.clusters) {
    begins.assign(stream.clusters->offsets.begin(), stream.clusters->offsets.end());
    if (!begins.empty()) begins.pop_back();
  } else {
    for (std::uint32_t t = 0; t < stream.triangle_count(); t += triangles_of_range) begins.push_back(t);
  }
  return begins;
}

}  // namespace foredraw
