// FOREDRAW_draw_orders, read: nothing in it is trusted.
#include <foredraw/draw_orders/draw_orders_product.h>

#include <foredraw/scene/reorder.h>
#include <foredraw/viewing/pose_set.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <set>

namespace foredraw {

namespace {

constexpr std::size_t most_orders = 256;  // a table's cells are bytes

class Reader {
 public:
  Reader(ExtensionReader& from, Scene& scene)
      : from_(from), scene_(scene), most_indices_((std::uint64_t{16} << 20) + 4 * from.bytes()) {}

  std::string read() {
    for (DrawId id = 0; id < scene_.draws.size(); ++id) {
      const ExtensionValue* value = from_.of_draw(id);
      if (value != nullptr && !orders(*value, id)) return mistake_;
    }
    if (const ExtensionValue* value = from_.of_file()) {
      const ExtensionValue* tables = value->member("tables");
      if (tables == nullptr || tables->list() == nullptr) return "the array 'tables' is missing";
      for (const ExtensionValue& one : *tables->list()) {
        if (!table(one, fmt::format("tables[{}]", made_.tables.size()))) return mistake_;
      }
    }
    scene_.products.set(std::move(made_));
    return {};
  }

 private:
  bool wrong(const std::string& place, const std::string& why) {
    mistake_ = place + " " + why;
    return false;
  }

  /// Single numbers; nothing where they are none such.
  std::optional<AccessorData> scalars(const ExtensionValue* value) const {
    const auto number = value == nullptr ? std::nullopt : value->whole();
    auto data = number ? from_.accessor(*number) : std::nullopt;
    const bool are_scalars = data && data->format.components == 1 && !data->format.normalized;
    return are_scalars ? std::move(data) : std::nullopt;
  }

  static std::vector<std::uint32_t> widened(const AccessorData& data) {
    std::vector<std::uint32_t> values(data.count, 0);
    const std::size_t width = data.format.bytes;
    for (std::size_t i = 0; i < data.count; ++i) std::memcpy(&values[i], data.bytes.view().data() + i * width, width);
    return values;
  }

  bool orders(const ExtensionValue& value, DrawId id) {
    Draw& draw = scene_.draws[id];
    const ExtensionValue* member = value.member("orders");
    const ExtensionValue::List* list = member == nullptr ? nullptr : member->list();
    if (list == nullptr || list->empty() || list->size() >= most_orders) {
      return wrong(draw.name, fmt::format("must have 1 to {} orders in addition to its indices", most_orders - 1));
    }
    if (draw.topology != Topology::triangles || !from_.is_list(id)) {
      return wrong(draw.name, "has orders, but is not a triangle list");
    }
    std::vector<IndexStream>& streams = draw.levels[0].orders;
    const IndexStream first = streams[0];
    for (const ExtensionValue& one : *list) {
      const auto data = scalars(&one);
      const bool are_indices =
          data && (data->format.component == Component::uint8 || data->format.component == Component::uint16 ||
                   data->format.component == Component::uint32);
      if (!are_indices) return wrong(draw.name, "names an order that is not an accessor of indices");
      if (data->count != first.indices.size()) {
        return wrong(draw.name, fmt::format("has an order of {} indices, but draws {} indices", data->count,
                                            first.indices.size()));
      }
      // Bytes may be named again and again; what is made of them may not fill the memory.
      indices_ += data->count;
      if (indices_ > most_indices_)
        return wrong(draw.name, "has orders that claim far more indices than the file holds");
      const auto same = std::pair(first.indices.stamp(), *one.whole());
      auto known = known_.find(same);
      if (known == known_.end()) {
        // Codecs may turn corners, so the order is taken, and not the corners.
        const auto order = order_between(first.indices.view(), widened(*data));
        if (!order) return wrong(draw.name, "has an order that does not draw the triangles of its indices");
        known = known_.emplace(same, with_triangle_order(first, *order)).first;
      }
      streams.push_back(known->second);
    }
    return true;
  }

  bool table(const ExtensionValue& value, const std::string& place) {
    OrderTable table;
    const ExtensionValue* primitives = value.member("primitives");
    if (primitives == nullptr || primitives->list() == nullptr || primitives->list()->empty()) {
      return wrong(place, "names no primitives");
    }
    std::size_t fewest = most_orders;
    for (const ExtensionValue& one : *primitives->list()) {
      const ExtensionValue::List* pair = one.list();
      const bool is_pair = pair != nullptr && pair->size() == 2;
      const auto mesh = is_pair ? (*pair)[0].whole() : std::nullopt;
      const auto primitive = is_pair ? (*pair)[1].whole() : std::nullopt;
      if (!mesh || !primitive || *mesh >= scene_.meshes.size() || *primitive >= scene_.meshes[*mesh].draws.size()) {
        return wrong(place, "names a primitive that does not exist");
      }
      const DrawId draw = scene_.meshes[*mesh].draws[*primitive];
      if (!in_tables_.insert(draw).second) return wrong(place, "names a primitive that a table names already");
      fewest = std::min(fewest, scene_.draws[draw].levels[0].orders.size());
      table.draws.push_back(draw);
    }
    if (const ExtensionValue* clips = value.member("clips"); clips != nullptr && !all_clips(*clips, table, place))
      return false;

    const auto steps = [&](const char* name) {
      const ExtensionValue* member = value.member(name);
      return member == nullptr ? std::nullopt : member->whole();
    };
    const auto theta = steps("thetaSteps"), phi = steps("phiSteps");
    if (!theta || !phi) return wrong(place, "must have thetaSteps and phiSteps");
    table.theta_steps = *theta;
    table.phi_steps = *phi;
    const auto cells = scalars(value.member("order"));
    if (!cells || cells->format.component != Component::uint8) {
      return wrong(place, "must have an 'order' that is an accessor of bytes");
    }
    for (const std::byte cell : cells->bytes.view()) table.order.push_back(std::to_integer<std::uint8_t>(cell));
    if (!all_sequences(value, table, place)) return false;
    if (const auto mistake = mistake_in(table, fewest)) return wrong(place, *mistake);
    made_.tables.push_back(std::move(table));
    return true;
  }

  /// The draw that a part is of: a primitive of the node's mesh, or of the mesh itself.
  std::optional<SubjectPart> part(const ExtensionValue& value) const {
    const auto number = [&](const char* name) {
      const ExtensionValue* member = value.member(name);
      return member == nullptr ? std::nullopt : member->whole();
    };
    const auto node = number("node"), primitive = number("primitive");
    if (node && *node >= scene_.nodes.size()) return std::nullopt;
    const auto mesh = node ? scene_.nodes[*node].mesh : number("mesh");
    if (!mesh || !primitive || *mesh >= scene_.meshes.size()) return std::nullopt;
    const std::vector<DrawId>& draws = scene_.meshes[*mesh].draws;
    if (*primitive >= draws.size()) return std::nullopt;
    return SubjectPart{draws[*primitive], node};
  }

  bool all_sequences(const ExtensionValue& value, OrderTable& table, const std::string& place) {
    const ExtensionValue* parts = value.member("parts");
    const ExtensionValue* sequences = value.member("sequences");
    if (parts == nullptr && sequences == nullptr) return true;
    if (parts == nullptr || parts->list() == nullptr || parts->list()->empty()) {
      return wrong(place, "has sequences, but no array of parts");
    }
    for (const ExtensionValue& one : *parts->list()) {
      const auto known = part(one);
      if (!known) return wrong(place, "has a part that does not exist");
      table.parts.push_back(*known);
    }
    const auto numbers = scalars(sequences);
    if (!numbers || numbers->format.component != Component::uint16) {
      return wrong(place, "must have 'sequences' that are an accessor of 16-bit numbers");
    }
    for (const std::uint32_t number : widened(*numbers)) table.sequences.push_back(static_cast<std::uint16_t>(number));
    return true;
  }

  bool all_clips(const ExtensionValue& clips, OrderTable& table, const std::string& place) {
    if (clips.list() == nullptr) return wrong(place, "must have an array of clips");
    const std::vector<std::string> names = clip_names(scene_);
    for (const ExtensionValue& clip : *clips.list()) {
      const ExtensionValue* member = clip.member("animation");
      const auto animation = member == nullptr ? std::nullopt : member->whole();
      if (!animation || *animation >= names.size()) return wrong(place, "has a clip whose 'animation' does not exist");
      const auto times = scalars(clip.member("times"));
      if (!times || times->format.component != Component::float32) {
        return wrong(place, "has a clip whose 'times' is not an accessor of floats");
      }
      std::vector<float> values(times->count);
      std::memcpy(values.data(), times->bytes.view().data(), 4 * values.size());
      table.clips.push_back({names[*animation], std::move(values)});
    }
    return true;
  }

  ExtensionReader& from_;
  Scene& scene_;
  std::uint64_t indices_ = 0, most_indices_;
  DrawOrders made_;
  std::set<DrawId> in_tables_;
  std::map<std::pair<Stamp, std::uint32_t>, IndexStream> known_;
  std::string mistake_;
};

}  // namespace

std::string read_draw_orders(ExtensionReader& from, Scene& scene) { return Reader(from, scene).read(); }

}  // namespace foredraw
