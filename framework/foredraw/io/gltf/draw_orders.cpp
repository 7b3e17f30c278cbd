// FOREDRAW_draw_orders, read: nothing in it is trusted. It is optional, so what is wrong in it costs the orders alone.
#include <foredraw/io/gltf/private/draw_orders.h>

#include <foredraw/viewing/pose_set.h>
#include <foredraw/io/gltf/private/gate.h>
#include <foredraw/io/gltf/private/member.h>
#include <foredraw/scene/reorder.h>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace foredraw::gltf {

namespace {

constexpr std::size_t most_orders = 256;  // a table's cells are bytes

class DrawOrdersReader {
 public:
  DrawOrdersReader(const Document& document, Scene& scene) : document_(document), draws_(scene.draws), scene_(scene) {
    most_indices_ = (std::size_t{16} << 20) + 4 * bytes_read(document);
  }

  /// Empty where all of it holds, and the scene has it then.
  std::string read() {
    for (std::size_t m = 0; m < scene_.meshes.size(); ++m) {
      for (std::size_t p = 0; p < scene_.meshes[m].draws.size(); ++p) {
        const std::string place = at(in(at("meshes", m), "primitives"), p);
        const Json& json = document_.json["meshes"][m]["primitives"][p];
        const Json* value = extension_of(json, draw_orders);
        if (value != nullptr && !orders(*value, json, draws_[scene_.meshes[m].draws[p]], place)) return mistake_;
      }
    }
    if (const Json* value = extension_of(document_.json, draw_orders)) {
      const Json* list = member(*value, "tables");
      if (list == nullptr || !list->is_array()) return wrong(draw_orders, "has no array 'tables'"), mistake_;
      for (std::size_t t = 0; t < list->size(); ++t) {
        if (!table((*list)[t], at("tables", t))) return mistake_;
      }
    }
    scene_.draws = std::move(draws_);
    scene_.order_tables = std::move(tables_);
    return {};
  }

 private:
  bool wrong(const std::string& place, const std::string& why) {
    mistake_ = place + " " + why;
    return false;
  }

  static std::optional<std::size_t> number(const Json* json) {
    return json != nullptr && json->is_number_unsigned() ? std::optional(json->get<std::size_t>()) : std::nullopt;
  }

  /// Of single numbers; nothing where it is none such.
  const Accessor* scalars(const Json* json) const {
    const auto i = number(json);
    if (!i || *i >= document_.accessors.size() || document_.json["accessors"][*i]["type"] != "SCALAR") return nullptr;
    const Accessor& accessor = document_.accessors[*i];
    return accessor.format.components == 1 && !accessor.format.normalized ? &accessor : nullptr;
  }

  bool orders(const Json& value, const Json& primitive, Draw& draw, const std::string& place) {
    const Json* list = member(value, "orders");
    if (list == nullptr || !list->is_array() || list->empty() || list->size() >= most_orders) {
      return wrong(place, fmt::format("must have 1 to {} orders besides its indices", most_orders - 1));
    }
    if (draw.topology != Topology::triangles || primitive.value("mode", 4) != 4) {
      return wrong(place, "has orders, but is no list of triangles");
    }
    std::vector<IndexStream>& streams = draw.levels[0].orders;
    const IndexStream first = streams[0];
    for (const Json& one : *list) {
      const Accessor* accessor = scalars(&one);
      const bool is_index = accessor != nullptr && (accessor->format.component == Component::uint8 ||
                                                    accessor->format.component == Component::uint16 ||
                                                    accessor->format.component == Component::uint32);
      if (!is_index) return wrong(place, "names an order that is no accessor of indices");
      if (accessor->count != first.indices.size()) {
        return wrong(place,
                     fmt::format("has an order of {} indices, but draws {}", accessor->count, first.indices.size()));
      }
      // Bytes may be named again and again; what is made of them may not fill the memory.
      indices_ += accessor->count;
      if (indices_ > most_indices_) return wrong(place, "has orders that claim far more indices than the file holds");
      const auto same = std::pair(first.indices.stamp(), one.get<std::size_t>());
      if (const auto known = known_.find(same); known != known_.end()) {
        streams.push_back(known->second);
        continue;
      }
      // Codecs may turn corners, so the order is taken, and not the corners.
      const auto order = order_between(first.indices.view(), index_elements(document_, *accessor));
      if (!order) return wrong(place, "has an order that draws other triangles than its indices do");
      streams.push_back(with_triangle_order(first, *order));
      known_.emplace(same, streams.back());
    }
    return true;
  }

  bool table(const Json& json, const std::string& place) {
    OrderTable table;
    const Json* primitives = member(json, "primitives");
    if (primitives == nullptr || !primitives->is_array() || primitives->empty()) {
      return wrong(place, "names no primitives");
    }
    std::size_t fewest = most_orders;
    for (const Json& pair : *primitives) {
      const bool is_pair = pair.is_array() && pair.size() == 2;
      const auto mesh = is_pair ? number(&pair[0]) : std::nullopt;
      const auto primitive = is_pair ? number(&pair[1]) : std::nullopt;
      if (!mesh || !primitive || *mesh >= scene_.meshes.size() || *primitive >= scene_.meshes[*mesh].draws.size()) {
        return wrong(place, "names a primitive that does not exist");
      }
      const DrawId draw = scene_.meshes[*mesh].draws[*primitive];
      if (!in_tables_.insert(draw).second) return wrong(place, "names a primitive that a table has already");
      fewest = std::min(fewest, draws_[draw].levels[0].orders.size());
      table.draws.push_back(draw);
    }
    if (const Json* clips = member(json, "clips"); clips != nullptr && !all_clips(*clips, table, place)) return false;

    const auto theta = number(member(json, "thetaSteps"));
    const auto phi = number(member(json, "phiSteps"));
    constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    if (!theta || !phi || *theta > most || *phi > most) return wrong(place, "must have thetaSteps and phiSteps");
    table.theta_steps = static_cast<std::uint32_t>(*theta);
    table.phi_steps = static_cast<std::uint32_t>(*phi);
    const Accessor* cells = scalars(member(json, "order"));
    if (cells == nullptr || cells->format.component != Component::uint8) {
      return wrong(place, "must have an 'order' that is an accessor of bytes");
    }
    for (const std::byte cell : elements(document_, *cells)) table.order.push_back(std::to_integer<std::uint8_t>(cell));
    if (const auto mistake = mistake_in(table, fewest)) return wrong(place, *mistake);
    tables_.push_back(std::move(table));
    return true;
  }

  bool all_clips(const Json& clips, OrderTable& table, const std::string& place) {
    if (!clips.is_array()) return wrong(place, "must have an array of clips");
    const std::vector<std::string> names = clip_names(scene_);
    for (const Json& json : clips) {
      const auto animation = number(member(json, "animation"));
      if (!animation || *animation >= names.size()) return wrong(place, "has a clip of no animation");
      const Accessor* times = scalars(member(json, "times"));
      if (times == nullptr || times->format.component != Component::float32) {
        return wrong(place, "has a clip whose 'times' is no accessor of floats");
      }
      table.clips.push_back({names[*animation], decoded_elements(document_, *times)});
    }
    return true;
  }

  const Document& document_;
  std::vector<Draw> draws_;
  Scene& scene_;
  std::vector<OrderTable> tables_;
  std::set<DrawId> in_tables_;
  std::map<std::pair<Stamp, std::size_t>, IndexStream> known_;
  std::size_t indices_ = 0;
  std::size_t most_indices_ = 0;
  std::string mistake_;
};

template <class AnyJson, class F>
void each_primitive(AnyJson& json, F visit) {
  if (!json.contains("meshes")) return;
  for (auto& mesh : json.at("meshes")) {
    for (auto& primitive : mesh.at("primitives")) visit(primitive);
  }
}

}  // namespace

void read_draw_orders(Document& document, Scene& scene, Diagnostics& diagnostics) {
  if (!has_draw_orders(document.json)) return;
  const std::string mistake = DrawOrdersReader(document, scene).read();
  if (mistake.empty()) return;
  diagnostics.warning({.file = document.name, .inside = draw_orders}, "draw-orders-left-out",
                      "the orders and their tables are left out: " + mistake,
                      "make them again, once nothing changes the file any more");
  take_draw_orders(document.json);
  document.left_out = true;
}

std::set<std::size_t> used_by_orders(const Json& json) {
  std::set<std::size_t> numbers;
  each_primitive(json, [&](const Json& primitive) {
    const Json* value = extension_of(primitive, draw_orders);
    if (value == nullptr) return;
    for (const Json& number : value->at("orders")) numbers.insert(number.get<std::size_t>());
  });
  return numbers;
}

std::set<std::size_t> used_by_tables(const Json& json) {
  std::set<std::size_t> numbers;
  const Json* value = extension_of(json, draw_orders);
  if (value == nullptr) return numbers;
  for (const Json& table : value->at("tables")) {
    numbers.insert(table.at("order").get<std::size_t>());
    if (!table.contains("clips")) continue;
    for (const Json& clip : table["clips"]) numbers.insert(clip.at("times").get<std::size_t>());
  }
  return numbers;
}

bool has_draw_orders(const Json& json) {
  bool found = extension_of(json, draw_orders) != nullptr;
  each_primitive(json,
                 [&](const Json& primitive) { found = found || extension_of(primitive, draw_orders) != nullptr; });
  return found;
}

void take_draw_orders(Json& json) {
  take_extension(json, draw_orders);
  each_primitive(json, [](Json& primitive) { take_extension(primitive, draw_orders); });
}

}  // namespace foredraw::gltf
