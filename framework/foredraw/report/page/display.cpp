#include <foredraw/report/page/display.h>

#include <foredraw/report/page/private/page_buffer.h>
#include <foredraw/report/page/shown_triangles.h>

#include <foredraw/scene/order_table.h>
#include <foredraw/viewing/bounding_sphere.h>
#include <foredraw/viewing/pose_set.h>
#include <foredraw/viewing/posed_positions.h>
#include <foredraw/viewing/subject_geometry.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <numeric>

namespace foredraw {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_triangles = 200'000;         // of a subject: what a small machine's browser turns smoothly
constexpr std::size_t most_branches = 24;               // each takes four bytes a triangle
constexpr std::size_t most_poses = 64;                  // of all clips
constexpr std::size_t most_bytes_of_poses = 6'000'000;  // of a subject

/// Draws of which the viewer can show every order: as those who measure overdraw see them, but without holes.
bool is_shown(const Scene& scene, const Draw& draw) {
  return draw.topology == Topology::triangles && !is_blended(scene, draw);
}

struct ShownPart {
  SubjectPart part;
  ShownTriangles shown;
};

class SubjectDisplay {
 public:
  SubjectDisplay(const Scene& input, const Subject& subject, PageBuffer& buffer)
      : input_(input), subject_(subject), buffer_(buffer) {
    choose_triangles();
  }

  bool empty() const {
    return std::ranges::all_of(parts_, [](const ShownPart& part) { return part.shown.triangles.empty(); });
  }

  Json json(std::span<const std::optional<Scene>> branches) {
    Json json{{"name", subject_.name}};
    add_parts(json);
    json["states"] = Json::array({state_of(input_)});
    for (const auto& branch : branches) {
      const bool is_one_too_many = json["states"].size() > most_branches;  // the input is the first of them
      const std::string why =
          is_one_too_many ? fmt::format("only the first {} are shown", most_branches) : why_absent(branch);
      if (!why.empty()) json["absent"][std::to_string(json["states"].size())] = why;
      json["states"].push_back(why.empty() ? state_of(*branch) : Json(nullptr));
    }
    if (const std::string note = this->note(); !note.empty()) json["note"] = note;
    return json;
  }

 private:
  void choose_triangles() {
    const PosedNodes nodes = posed_nodes(input_);
    std::size_t triangles = 0;
    for (const SubjectPart& part : subject_.parts) {
      if (is_shown(input_, input_.draws[part.draw])) triangles += order_of(input_, part.draw).triangle_count();
    }
    for (const SubjectPart& part : subject_.parts) {
      if (!is_shown(input_, input_.draws[part.draw])) continue;
      const auto positions = posed_positions(input_, part, nodes);
      if (positions.empty()) continue;
      const IndexStream& order = order_of(input_, part.draw);
      const std::size_t share = triangles <= most_triangles ? order.triangle_count()
                                                            : order.triangle_count() * most_triangles / triangles + 1;
      parts_.push_back({part, shown_triangles(positions, order.indices.view(), share)});
      all_triangles_ += order.triangle_count();
      shown_triangles_ += parts_.back().shown.triangles.size();
      vertices_ += parts_.back().shown.vertices.size();
    }
  }

  static const IndexStream& order_of(const Scene& scene, DrawId draw) { return scene.draws[draw].full().stream(); }

  std::string note() const {
    if (shown_triangles_ == all_triangles_) return "";
    return fmt::format("{} of {} triangles are shown; counts and ratios here are those of the shown triangles",
                       shown_triangles_, all_triangles_);
  }

  /// One where it looks alike in all of them.
  Poses poses() const {
    const std::size_t room = most_bytes_of_poses / (sizeof(glm::vec3) * std::max<std::size_t>(vertices_, 1));
    PoseSet set;
    set.poses = std::to_string(std::clamp<std::size_t>(room, 1, most_poses));
    return subject_.is_placed() && !input_.animations.empty() ? make_poses(input_, set) : rest_pose;
  }

  void add_parts(Json& json) {
    const Poses poses = this->poses();
    std::vector<Json> parts;
    for (const ShownPart& part : parts_) parts.push_back(part_json(part));
    std::vector<std::vector<glm::vec3>> all_positions;
    std::vector<std::string> clips = clip_names(input_);
    json["poses"] = Json::array();
    for (const Pose& pose : poses.poses) {
      const PosedNodes nodes = posed_nodes(input_, pose);
      json["poses"].push_back({{"name", pose_name(pose, clips)},
                               {"clip", pose.clip ? Json(clips[*pose.clip]) : Json(nullptr)},
                               {"time", pose.time}});
      for (std::size_t i = 0; i < parts_.size(); ++i) {
        const auto positions = posed_positions(input_, parts_[i].part, nodes);
        std::vector<glm::vec3> shown;
        for (const std::uint32_t vertex : parts_[i].shown.vertices) shown.push_back(positions[vertex]);
        parts[i]["positions"].push_back(buffer_.add(numbers_of(shown)));
        parts[i]["mirrored"].push_back(is_mirrored(parts_[i].part, nodes));
        all_positions.push_back(std::move(shown));
      }
    }
    json["parts"] = parts;
    add_sphere(json, all_positions);
  }

  static std::span<const float> numbers_of(const std::vector<glm::vec3>& positions) {
    return {positions.empty() ? nullptr : &positions[0].x, 3 * positions.size()};
  }

  Json part_json(const ShownPart& part) {
    const Draw& draw = input_.draws[part.part.draw];
    const Material* material = input_.material_of(draw);
    return {{"name", draw.name},
            {"vertices", part.shown.vertices.size()},
            {"triangles", part.shown.triangles.size()},
            {"double-sided", material != nullptr && material->double_sided},
            {"indices", buffer_.add(std::span<const std::uint32_t>(part.shown.indices))}};
  }

  /// Around all poses.
  void add_sphere(Json& json, const std::vector<std::vector<glm::vec3>>& positions) const {
    std::vector<DrawnPositions> drawn;
    for (std::size_t i = 0; i < positions.size(); ++i) {
      drawn.push_back({positions[i], parts_[i % parts_.size()].shown.indices});
    }
    const BoundingSphere sphere = bounding_sphere(drawn);
    json["centre"] = {sphere.centre.x, sphere.centre.y, sphere.centre.z};
    json["radius"] = sphere.radius;
  }

  /// Why what a pipeline made can not be shown as an order of the input's triangles; empty where it can.
  std::string why_absent(const std::optional<Scene>& scene) const {
    if (!scene) return "could not be planned for this file";
    const bool has_them = std::ranges::all_of(parts_, [&](const ShownPart& part) {
      const DrawId draw = part.part.draw;
      return draw < scene->draws.size() &&
             order_of(*scene, draw).triangle_count() == order_of(input_, draw).triangle_count();
    });
    return has_them ? "" : "does not draw the triangles of the input";
  }

  Json state_of(const Scene& scene) {
    const OrderTable* table = table_of(scene);
    std::size_t count = 1;
    for (const ShownPart& part : parts_) {
      if (table != nullptr) count = std::max(count, scene.draws[part.part.draw].full().orders.size());
    }
    Json orders = Json::array();
    for (std::size_t k = 0; k < count; ++k) {
      Json parts = Json::array();
      for (const ShownPart& part : parts_) {
        const auto& streams = scene.draws[part.part.draw].full().orders;
        parts.push_back(order_json(streams[k < streams.size() ? k : 0], part.shown));
      }
      orders.push_back(std::move(parts));
    }
    return {{"orders", std::move(orders)}, {"table", table == nullptr ? Json(nullptr) : table_json(*table)}};
  }

  const OrderTable* table_of(const Scene& scene) const {
    for (const OrderTable& table : order_tables(scene)) {
      for (const ShownPart& part : parts_) {
        if (std::ranges::find(table.draws, part.part.draw) != table.draws.end()) return &table;
      }
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

  /// The triangles that are shown, in this order, and where clusters begin among them.
  Json order_json(const IndexStream& stream, const ShownTriangles& shown) {
    constexpr std::uint32_t hidden = ~std::uint32_t{0};
    const std::span<const std::uint32_t> origin = stream.triangle_origin.view();
    std::vector<std::uint32_t> place(stream.triangle_count(), hidden);  // [number in the file] among those shown
    for (std::uint32_t i = 0; i < shown.triangles.size(); ++i) place[shown.triangles[i]] = i;
    std::vector<std::uint32_t> triangles;
    std::vector<std::uint32_t> offsets{0};
    std::size_t cluster = 0;
    for (std::uint32_t t = 0; t < place.size(); ++t) {
      if (stream.clusters && t == stream.clusters->offsets[cluster + 1]) {
        ++cluster;
        if (offsets.back() < triangles.size()) offsets.push_back(static_cast<std::uint32_t>(triangles.size()));
      }
      const std::uint32_t at = place[origin.empty() ? t : origin[t]];
      if (at != hidden) triangles.push_back(at);
    }
    if (offsets.back() < triangles.size()) offsets.push_back(static_cast<std::uint32_t>(triangles.size()));
    Json json{{"triangles", buffer_.add(std::span<const std::uint32_t>(triangles))}};
    if (stream.clusters && !triangles.empty()) {
      json["clusters"] = buffer_.add(std::span<const std::uint32_t>(offsets));
      json["cluster-count"] = offsets.size() - 1;
    }
    return json;
  }

  const Scene& input_;
  const Subject& subject_;
  PageBuffer& buffer_;
  std::vector<ShownPart> parts_;
  std::size_t all_triangles_ = 0;
  std::size_t shown_triangles_ = 0;
  std::size_t vertices_ = 0;
};

}  // namespace

Display display(const Scene& input, std::span<const std::optional<Scene>> branches, std::size_t file,
                SubjectUnit unit) {
  const std::string buffer_name = fmt::format("buffer-{}", file);
  Json scene{{"file", file}, {"buffer", buffer_name}, {"subjects", Json::array()}};
  PageBuffer buffer;
  for (const Subject& subject : subjects_of(input, unit)) {
    SubjectDisplay shown(input, subject, buffer);
    if (!shown.empty()) scene["subjects"].push_back(shown.json(branches));
  }
  return {scene.dump(-1, ' ', false, Json::error_handler_t::replace), buffer_name, buffer.base64()};
}

}  // namespace foredraw
