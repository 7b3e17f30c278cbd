#include <foredraw/page/display.h>

#include <foredraw/page/private/page_buffer.h>
#include <foredraw/page/private/shown_state.h>
#include <foredraw/page/private/shown_wires.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/bounding_sphere.h>
#include <foredraw/viewing/drawn_orders.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>
#include <foredraw/wires/wires.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_poses = 64;                  // of all clips
constexpr std::size_t most_bytes_of_poses = 6'000'000;  // of a subject, in all its states

std::span<const float> numbers_of(const std::vector<glm::vec3>& positions) {
  return {positions.empty() ? nullptr : &positions[0].x, 3 * positions.size()};
}

class SubjectDisplay {
 public:
  SubjectDisplay(std::span<const ShownScene> scenes, std::size_t number, PageBuffer& buffer)
      : subject_(scenes.front().subjects[number]), buffer_(buffer) {
    ShownTrianglesOnce once;
    for (const ShownScene& scene : scenes) states_.push_back(shown_state(scene, scenes.front().subjects, number, once));
  }

  bool empty() const { return !states_.front().absent.empty(); }

  Json json() {
    const std::size_t room = most_bytes_of_poses / (sizeof(glm::vec3) * std::max<std::size_t>(different_vertices(), 1));
    Json json{{"name", subject_.name}};
    add_poses(json, std::clamp<std::size_t>(room, 1, most_poses));
    json["geometries"] = Json::array();
    json["states"] = Json::array();
    for (const ShownState& state : states_) {
      if (!state.absent.empty()) json["absent"][std::to_string(json["states"].size())] = state.absent;
      json["states"].push_back(state.absent.empty() ? levelled_json(state, json["geometries"]) : Json(nullptr));
    }
    return json;
  }

 private:
  /// As the buffer will hold them: what several states have alike counts once.
  std::size_t different_vertices() const {
    std::map<Stamp, std::size_t> counts;
    const auto count = [&](const ShownState& state) {
      const PosedNodes nodes = posed_nodes(*state.scene);
      for (const ShownPart& part : state.shown.parts) {
        const std::vector<glm::vec3> positions = part.positions(*state.scene, nodes);
        counts.emplace(content_hash(numbers_of(positions)), positions.size());
      }
    };
    for (const ShownState& state : states_) {
      if (!state.absent.empty()) continue;
      count(state);
      std::ranges::for_each(state.coarser, count);
    }
    std::size_t sum = 0;
    for (const auto& [stamp, count] : counts) sum += count;
    return sum;
  }

  /// One where it looks alike in all of them.
  void add_poses(Json& json, std::size_t at_most) {
    const Scene& input = *states_.front().scene;
    PoseSet set;
    set.poses = std::to_string(at_most);
    poses_ = subject_.is_placed() && !input.animations.empty() ? make_poses(input, set) : rest_pose;
    const std::vector<std::string> clips = clip_names(input);
    for (const Pose& pose : poses_.poses) {
      json["poses"].push_back({{"name", pose_name(pose, clips)},
                               {"clip", pose.clip ? Json(clips[*pose.clip]) : Json(nullptr)},
                               {"time", pose.time}});
    }
    if (poses_.poses.size() > 1 && at_most < most_poses) {
      json["note"] = fmt::format("At most {} poses are shown, for the sake of the page's size", at_most);
    }
  }

  /// With its coarser levels, each told as a state is.
  Json levelled_json(const ShownState& state, Json& geometries) {
    Json json = state_json(state, geometries);
    for (const ShownState& coarser : state.coarser) json["levels"].push_back(state_json(coarser, geometries));
    return json;
  }

  /// `geometries`: those of the states before, each once.
  Json state_json(const ShownState& state, Json& geometries) {
    Json geometry = geometry_json(state);
    const auto found = std::ranges::find(geometries, geometry);
    const auto number = static_cast<std::size_t>(found - geometries.begin());
    if (found == geometries.end()) geometries.push_back(std::move(geometry));
    const OrderTable* table = table_of(state);
    Json json{{"geometry", number},
              {"orders", orders_json(state, table)},
              {"sequences", sequences_json(state, table)},
              {"table", table == nullptr ? Json(nullptr) : table_json(*table)}};
    if (state.error > 0) json["error"] = state.error;
    if (Json wires = wires_json(state); !wires.is_null()) json["wires"] = std::move(wires);
    for (const auto& of_part : state.ancestors) {
      json["ancestors"].push_back(of_part.empty() ? Json(nullptr) : Json(buffer_.add(std::span(of_part))));
    }
    return json;
  }

  /// [part] null: it has none; null: no part has.
  Json wires_json(const ShownState& state) {
    Json json = Json::array();
    bool has_any = false;
    for (const ShownPart& part : state.shown.parts) {
      const auto wires = shown_wires(*state.scene, part);
      json.push_back(nullptr);
      if (!wires) continue;
      has_any = true;
      json.back() = {{"first", wires->first},
                     {"corners", buffer_.add(std::span(wires->corners))},
                     {"rows", buffer_.add(std::span(wires->rows))},
                     {"row-count", wires->rows.size() / ShownWires::row_floats}};
      for (const Pose& pose : poses_.poses) {
        const glm::mat4 matrix = shown_from_mesh(part, posed_nodes(*state.scene, pose));
        json.back()["from-mesh"].push_back(std::vector<float>(&matrix[0].x, &matrix[0].x + 16));
      }
    }
    return has_any ? json : Json(nullptr);
  }

  Json geometry_json(const ShownState& state) {
    std::vector<Json> parts;
    for (const ShownPart& part : state.shown.parts) parts.push_back(part_json(*state.scene, part));
    std::vector<std::vector<glm::vec3>> all_positions;
    for (const Pose& pose : poses_.poses) {
      const PosedNodes nodes = posed_nodes(*state.scene, pose);
      for (std::size_t i = 0; i < parts.size(); ++i) {
        const ShownPart& part = state.shown.parts[i];
        all_positions.push_back(part.positions(*state.scene, nodes));
        parts[i]["positions"].push_back(buffer_.add(numbers_of(all_positions.back())));
        parts[i]["mirrored"].push_back(is_mirrored(part.part, nodes));
      }
    }
    const BoundingSphere sphere = sphere_around(all_positions, state.shown.parts);
    Json json{{"centre", {sphere.centre.x, sphere.centre.y, sphere.centre.z}},
              {"radius", sphere.radius},
              {"parts", std::move(parts)}};
    if (!state.shown.note.empty()) json["note"] = state.shown.note;
    return json;
  }

  Json part_json(const Scene& scene, const ShownPart& part) {
    const Draw& draw = scene.draws[part.part.draw];
    const Material* material = scene.material_of(draw);
    return {{"name", draw.name},
            {"vertices", part.vertices.size()},
            {"triangles", part.triangles()},
            {"double-sided", material != nullptr && material->double_sided},
            {"indices", buffer_.add(std::span<const std::uint32_t>(part.indices))}};
  }

  /// Around all poses.
  static BoundingSphere sphere_around(const std::vector<std::vector<glm::vec3>>& positions,
                                      const std::vector<ShownPart>& parts) {
    std::vector<DrawnPositions> drawn;
    for (std::size_t i = 0; i < positions.size(); ++i) drawn.push_back({positions[i], parts[i % parts.size()].indices});
    return bounding_sphere(drawn);
  }

  static bool is_in(const OrderTable& table, const ShownPart& part) {
    return std::ranges::find(table.draws, part.part.draw) != table.draws.end();
  }

  static const OrderTable* table_of(const ShownState& state) {
    for (const OrderTable& table : order_tables(*state.scene)) {
      if (std::ranges::any_of(state.shown.parts, [&](const ShownPart& part) { return is_in(table, part); }))
        return &table;
    }
    return nullptr;
  }

  static Json table_json(const OrderTable& table) {
    Json clips = Json::array();
    for (const OrderTable::Clip& clip : table.clips) clips.push_back({{"name", clip.name}, {"times", clip.times}});
    return {{"clips", std::move(clips)},
            {"theta-steps", table.theta_steps},
            {"phi-steps", table.phi_steps},
            {"order", table.order}};
  }

  /// [order][part]; parts that the table does not choose for stay in the order that stands alone.
  Json orders_json(const ShownState& state, const OrderTable* table) {
    const std::vector<ShownPart>& parts = state.shown.parts;
    std::size_t count = 1;
    for (const ShownPart& part : parts) {
      if (table != nullptr && is_in(*table, part)) count = std::max(count, part.orders.size());
    }
    Json orders = Json::array();
    for (std::size_t k = 0; k < count; ++k) {
      Json order = Json::array();
      for (const ShownPart& part : parts) {
        const bool has_k = table != nullptr && is_in(*table, part) && k < part.orders.size();
        order.push_back(order_json(part.orders[has_k ? k : 0]));
      }
      orders.push_back(std::move(order));
    }
    return orders;
  }

  /// [order][rank] number of the part; null: every order draws them as the geometry has them.
  static Json sequences_json(const ShownState& state, const OrderTable* table) {
    if (table == nullptr || table->parts.empty()) return nullptr;
    const std::vector<ShownPart>& parts = state.shown.parts;
    Json sequences = Json::array();
    for (std::size_t k = 0; k * table->parts.size() < table->sequences.size(); ++k) {
      Json sequence = Json::array();
      for (const std::uint32_t part : parts_in_sequence(*state.subject, *table, table->sequence(k))) {
        const auto shown = std::ranges::find(parts, state.subject->parts[part], &ShownPart::part);
        if (shown != parts.end()) sequence.push_back(shown - parts.begin());
      }
      sequences.push_back(std::move(sequence));
    }
    return sequences;
  }

  Json order_json(const ShownOrder& order) {
    Json json{{"triangles", buffer_.add(std::span<const std::uint32_t>(order.triangles))}};
    if (!order.clusters.empty()) {
      json["clusters"] = buffer_.add(std::span<const std::uint32_t>(order.clusters));
      json["cluster-count"] = order.clusters.size() - 1;
    }
    return json;
  }

  const Subject& subject_;
  PageBuffer& buffer_;
  std::vector<ShownState> states_;
  Poses poses_;
};

}  // namespace

Display display(const Scene& input, std::span<const std::optional<Scene>> branches, std::size_t file,
                SubjectUnit unit) {
  const std::string buffer_name = fmt::format("buffer-{}", file);
  Json json{{"file", file}, {"buffer", buffer_name}, {"subjects", Json::array()}};
  PageBuffer buffer;
  const std::vector<ShownScene> scenes = shown_scenes(input, branches, unit);
  for (std::size_t number = 0; number < scenes.front().subjects.size(); ++number) {
    SubjectDisplay shown(scenes, number, buffer);
    if (!shown.empty()) json["subjects"].push_back(shown.json());
  }
  const bool has_wires = std::ranges::any_of(scenes, [](const ShownScene& shown) {
    return shown.scene != nullptr && shown.scene->products.has(Wires::product);
  });
  return {json.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_name, buffer.base64(), has_wires};
}

}  // namespace foredraw
