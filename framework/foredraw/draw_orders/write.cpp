// FOREDRAW_draw_orders, written; and the tables for engines that read no extension.
#include <foredraw/draw_orders/draw_orders_product.h>

#include <foredraw/scene/reorder.h>
#include <foredraw/viewing/pose_set.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

/// Every place where the scene's meshes hold the draw.
std::vector<std::pair<std::size_t, std::size_t>> primitives_of(const Scene& scene, DrawId id) {
  std::vector<std::pair<std::size_t, std::size_t>> places;
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    const auto& draws = scene.meshes[m].draws;
    const auto found = std::ranges::find(draws, id);
    if (found != draws.end()) places.emplace_back(m, found - draws.begin());
  }
  return places;
}

/// Where a part stands: the node that shows it, else its mesh, and the number of its primitive there.
Members place_of(const Scene& scene, const SubjectPart& part) {
  const auto places = primitives_of(scene, part.draw);
  const auto mesh = part.node ? scene.nodes[*part.node].mesh : std::nullopt;
  for (const auto& [m, primitive] : places) {
    if (part.node && mesh == m) return {{"node", *part.node}, {"primitive", primitive}};
    if (!part.node) return {{"mesh", m}, {"primitive", primitive}};
  }
  throw Refusal("no-mesh", scene.draws[part.draw].name + " is not where its table of orders says",
                "run the orderer again");
}

ExtensionValue value_of(const Scene& scene, const OrderTable& table, ExtensionWriter& to) {
  const std::vector<std::string> names = clip_names(scene);
  List primitives, clips;
  for (const DrawId id : table.draws) {
    for (const auto& [mesh, primitive] : primitives_of(scene, id)) primitives.push_back(List{mesh, primitive});
  }
  for (const OrderTable::Clip& clip : table.clips) {
    if (clip.times.empty()) continue;
    clips.push_back(Members{{"animation", std::ranges::find(names, clip.name) - names.begin()},
                            {"times", to.accessor(accessor_data(std::span(clip.times), Component::float32, 1))}});
  }
  Members members{{"primitives", std::move(primitives)}};
  if (!clips.empty()) members.emplace_back("clips", std::move(clips));
  members.emplace_back("thetaSteps", table.theta_steps);
  members.emplace_back("phiSteps", table.phi_steps);
  members.emplace_back("order", to.accessor(accessor_data(std::span(table.order), Component::uint8, 1)));
  if (!table.parts.empty()) {
    members.emplace_back("parts", listed(table.parts, [&](const SubjectPart& part) { return place_of(scene, part); }));
    members.emplace_back("sequences", to.accessor(accessor_data(std::span(table.sequences), Component::uint16, 1)));
  }
  return members;
}

Members value_of(const Scene& scene, DrawId id) {
  const Draw& draw = scene.draws[id];
  const std::vector<IndexStream>& streams = draw.levels[0].orders;
  const auto places = primitives_of(scene, id);
  if (places.empty()) throw Refusal("no-mesh", draw.name + " is not in a mesh", "remove draws that no mesh holds");
  return {{"name", draw.name},
          {"mesh", places.front().first},
          {"primitive", places.front().second},
          {"orders", listed(streams, [&](const IndexStream& stream) {
             const auto order = order_between(streams[0].indices.view(), stream.indices.view());
             if (!order)
               throw Refusal("other-triangles", "the orders of " + draw.name + " draw different triangles",
                             "run the orderer again");
             return ExtensionValue(List(order->begin(), order->end()));
           })}};
}

void add_sequences(const Scene& scene, const OrderTable& table, Members& members) {
  members.emplace_back("parts", listed(table.parts, [&](const SubjectPart& part) {
                         Members place{{"name", scene.draws[part.draw].name}};
                         for (auto& member : place_of(scene, part)) place.push_back(std::move(member));
                         return place;
                       }));
  List sequences;
  for (std::size_t order = 0; order < table.sequences.size() / table.parts.size(); ++order) {
    const auto sequence = table.sequence(order);
    sequences.push_back(List(sequence.begin(), sequence.end()));
  }
  members.emplace_back("sequences", std::move(sequences));
}

}  // namespace

void write_draw_orders(const Scene& scene, ExtensionWriter& to) {
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const auto& orders = scene.draws[id].levels[0].orders;
    if (orders.size() == 1) continue;
    List numbers;
    for (std::size_t order = 1; order < orders.size(); ++order)
      numbers.push_back(to.indices(orders[order].indices.view()));
    to.put_on_draw(id, Members{{"orders", std::move(numbers)}});
  }
  const auto tables = order_tables(scene);
  if (tables.empty()) return;
  to.put_on_file(
      Members{{"tables", listed(tables, [&](const OrderTable& table) { return value_of(scene, table, to); })}});
}

ExtensionValue draw_orders_value(const Scene& scene) {
  return Members{
      {"draw-orders", 1},
      {"file", scene.name},
      {"tables", listed(order_tables(scene), [&](const OrderTable& table) {
         Members members{
             {"clips",
              listed(table.clips,
                     [](const OrderTable::Clip& clip) {
                       return Members{{"name", clip.name}, {"times", List(clip.times.begin(), clip.times.end())}};
                     })},
             {"theta-steps", table.theta_steps},
             {"phi-steps", table.phi_steps},
             {"order", List(table.order.begin(), table.order.end())},
             {"draws", listed(table.draws, [&](DrawId id) { return value_of(scene, id); })}};
         if (!table.parts.empty()) add_sequences(scene, table, members);
         return members;
       })}};
}

}  // namespace foredraw
