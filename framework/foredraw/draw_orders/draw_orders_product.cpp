#include <foredraw/draw_orders/draw_orders_product.h>

#include <foredraw/base/counted.h>
#include <foredraw/draw_orders/order_memory.h>
#include <foredraw/viewing/pose_set.h>

#include "schemas.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace foredraw {

namespace {

/// Takes tables out, and with each the orders of its draws, which are of no use without it.
std::vector<std::string> forget_tables(Scene& scene, const std::function<std::string(const OrderTable&)>& why_not) {
  std::vector<std::string> told;
  DrawOrders left;
  for (const OrderTable& table : order_tables(scene)) {
    const std::string why = why_not(table);
    if (why.empty()) {
      left.tables.push_back(table);
      continue;
    }
    told.push_back("the orders and their table are left out: " + why);
    for (const DrawId id : table.draws) {
      if (id < scene.draws.size()) scene.draws[id].levels[0].orders.resize(1);
    }
  }
  if (told.empty()) return told;
  if (left.tables.empty()) {
    scene.products.erase(DrawOrders::product);
  } else {
    scene.products.set(std::move(left));
  }
  return told;
}

class DrawOrdersRow final : public ProductRow {
 public:
  DrawOrdersRow()
      : ProductRow({.name = std::string(DrawOrders::product),
                    .title = "orders and their tables",
                    .extension = "FOREDRAW_draw_orders",
                    .remedy = "make them again as the last step, after all other changes of the file",
                    .accessors_of_file = {"tables/*/order", "tables/*/clips/*/times", "tables/*/sequences"},
                    .accessors_of_draw = {"orders/*"},
                    .schemas = schemas(),
                    .side_files = {{".json"}}}) {}

  std::string read(ExtensionReader& from, Scene& scene) const override { return read_draw_orders(from, scene); }
  void write(const Scene& scene, ExtensionWriter& to) const override { write_draw_orders(scene, to); }

  bool is_written_alike(const Scene& now, const Scene& was) const override {
    const auto orders_of = [](const Draw& draw) {
      return draw.levels[0].orders.size() > 1 ? std::span(draw.levels[0].orders) : std::span<const IndexStream>();
    };
    return std::ranges::equal(now.draws, was.draws, [&](const Draw& a, const Draw& b) {
      return std::ranges::equal(orders_of(a), orders_of(b), {}, &IndexStream::indices, &IndexStream::indices);
    });
  }

  std::string difference(const Scene& scene) const override {
    const std::vector<std::string> clips = clip_names(scene);
    for (const OrderTable& table : order_tables(scene)) {
      if (const std::string why = why_not(scene, table); !why.empty()) return why;
      for (const OrderTable::Clip& clip : table.clips) {
        if (std::ranges::find(clips, clip.name) == clips.end())
          return "clip '" + clip.name + "' is not an animation of the scene";
      }
    }
    return {};
  }

  /// Vertices that were renumbered are so in all orders. Triangles that were ordered anew are so in one.
  std::vector<std::string> follow(const Scene& before, Scene& after) const override {
    const bool same_tables = before.products.same(DrawOrders::product, after.products);
    return forget_tables(after, [&](const OrderTable& table) {
      if (const std::string why = why_not(after, table); !why.empty()) return why;
      for (const DrawId id : table.draws) {
        if (!same_tables || id >= before.draws.size()) continue;
        const IndexStream& now = after.draws[id].levels[0].orders[0];
        const IndexStream& was = before.draws[id].levels[0].orders[0];
        if (!now.triangle_origin.is(was.triangle_origin)) return after.draws[id].name + " was reordered";
      }
      return std::string();
    });
  }

  void leave_out(Scene& scene) const override {
    forget_tables(scene, [](const OrderTable&) { return "they are left out"; });
    scene.products.erase(DrawOrders::product);
    for (Draw& draw : scene.draws) draw.levels[0].orders.resize(1);
  }

  SideFile side_file(const Scene& scene, std::string_view, const std::string&) const override {
    return {.content = draw_orders_value(scene), .indent = -1};
  }

  ProductText told(const Scene& scene) const override {
    ProductText text{.heading = "orders (chosen by direction, and by clip and keyframe)",
                     .value = ExtensionValue::List()};
    for (const OrderTable& table : order_tables(scene)) {
      const OrderMemory memory = memory_of(scene, table);
      std::vector<std::string> names;
      for (const DrawId id : table.draws) names.push_back(scene.draws[id].name);
      std::string line =
          fmt::format("{}: {} x {} directions", fmt::join(names, ", "), table.theta_steps, table.phi_steps);
      if (!table.clips.empty())
        line += ", " + counted(table.keyframes(), "keyframe") + " of " + counted(table.clips.size(), "clip");
      line += "; " + memory_text(memory, table.keyframes());
      if (!table.parts.empty()) line += fmt::format("; {} draws in a sequence for each order", table.parts.size());
      text.lines.push_back(std::move(line));
      ExtensionValue::Members members{
          {"draws", ExtensionValue::List(names.begin(), names.end())},
          {"orders", memory.orders},
          {"theta-steps", table.theta_steps},
          {"phi-steps", table.phi_steps},
          {"clips", listed(table.clips,
                           [](const OrderTable::Clip& clip) {
                             return ExtensionValue::Members{{"name", clip.name}, {"keyframes", clip.times.size()}};
                           })},
          {"bytes", memory.bytes},
          {"bytes-for-each-keyframe", memory.bytes_for_each_keyframe}};
      if (!table.parts.empty()) members.emplace_back("parts-in-sequence", table.parts.size());
      text.value.push(std::move(members));
    }
    return text;
  }

 private:
  static bool is_there(const Scene& scene, const SubjectPart& part) {
    const auto holds = [&](MeshId mesh) {
      return std::ranges::find(scene.meshes[mesh].draws, part.draw) != scene.meshes[mesh].draws.end();
    };
    if (!part.node) {
      for (MeshId mesh = 0; mesh < scene.meshes.size(); ++mesh) {
        if (holds(mesh)) return true;
      }
      return false;
    }
    return *part.node < scene.nodes.size() && scene.nodes[*part.node].mesh && holds(*scene.nodes[*part.node].mesh);
  }

  static std::string why_not(const Scene& scene, const OrderTable& table) {
    const std::size_t most = table.order.empty() ? 0 : *std::ranges::max_element(table.order);
    for (const DrawId id : table.draws) {
      if (id >= scene.draws.size()) return "one of their draws is gone";
      if (scene.draws[id].levels[0].orders.size() <= most)
        return scene.draws[id].name + " has fewer orders than the table uses";
    }
    for (const SubjectPart& part : table.parts) {
      if (!is_there(scene, part)) return "one of the draws that their sequences name is not where it was";
    }
    return {};
  }
};

}  // namespace

std::shared_ptr<const ProductRow> draw_orders_product() { return std::make_shared<const DrawOrdersRow>(); }

}  // namespace foredraw
