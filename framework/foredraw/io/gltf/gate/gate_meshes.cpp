// Checks of meshes: that every primitive's attributes fit one another and its indices stay below its vertices.
#include <foredraw/io/gltf/gate/private/gate.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace foredraw::gltf {

namespace {

struct IndexRange {
  std::uint32_t most = 0;     ///< of those that do not restart
  std::uint32_t restart = 0;  ///< the type's greatest value, which glTF keeps free
  bool does_restart = false;
};

/// What glTF lets a semantic hold. Components are not told apart further: quantised assets mix them.
struct SemanticRule {
  std::string_view prefix;
  std::uint8_t least, most;  ///< components
};
constexpr SemanticRule rules[] = {{"POSITION", 3, 3}, {"NORMAL", 3, 3},  {"TANGENT", 3, 4}, {"TEXCOORD_", 2, 2},
                                  {"COLOR_", 3, 4},   {"JOINTS_", 4, 4}, {"WEIGHTS_", 4, 4}};

class MeshCheck {
 public:
  explicit MeshCheck(Gate& gate) : gate_(gate) {}

  void mesh(const Json& mesh, const std::string& place) {
    gate_.required(mesh, "primitives", place);
    const Json* primitives = gate_.array(mesh, "primitives", place);
    if (primitives == nullptr) return;
    if (primitives->empty()) gate_.error(in(place, "primitives"), "out-of-range", "must not be empty");
    std::optional<std::size_t> targets;  // of the first
    std::size_t most_targets = 0;
    for (std::size_t p = 0; p < primitives->size(); ++p) {
      const std::string inside = at(in(place, "primitives"), p);
      if (!(*primitives)[p].is_object()) {
        gate_.error(inside, "wrong-type", "must be an object");
        continue;
      }
      const std::size_t own = primitive((*primitives)[p], inside);
      if (targets && *targets != own) {
        gate_.fault("morph-targets", in(inside, "targets"),
                    fmt::format("has {} morph targets, but the first primitive has {}", own, *targets));
      }
      if (!targets) targets = own;
      most_targets = std::max(most_targets, own);
    }
    if (mesh.contains("weights")) gate_.numbers(mesh, "weights", place, most_targets);
  }

 private:
  /// Returns the number of morph targets.
  std::size_t primitive(const Json& primitive, const std::string& place) {
    gate_.required(primitive, "attributes", place);
    const Json* attributes = gate_.object(primitive, "attributes", place);
    std::optional<std::size_t> vertices;
    if (attributes != nullptr) {
      vertices = streams(*attributes, std::nullopt, in(place, "attributes"));
      if (attributes->empty()) {
        gate_.error(in(place, "attributes"), "out-of-range", "must not be empty");
      } else if (!attributes->contains("POSITION")) {
        gate_.warning(in(place, "attributes"), "no-position",
                      "lacks POSITION: there is nothing to draw, so it is kept as it is");
      }
    }
    const Json* targets = gate_.array(primitive, "targets", place);
    for (std::size_t t = 0; targets != nullptr && t < targets->size(); ++t) {
      const std::string inside = at(in(place, "targets"), t);
      if ((*targets)[t].is_object()) {
        streams((*targets)[t], vertices, inside);
      } else {
        gate_.error(inside, "wrong-type", "must be an object");
      }
    }
    gate_.reference(primitive, "material", "materials", place);
    const auto mode = gate_.whole(primitive, "mode", place, 0, 6);
    std::optional<std::size_t> drawn = vertices;
    if (primitive.contains("indices")) drawn = indices(primitive, vertices, is_list(mode.value_or(4)), place);
    if (drawn && (mode || !primitive.contains("mode"))) index_count(*drawn, mode.value_or(4), place);
    return targets == nullptr ? 0 : targets->size();
  }

  /// The one count that all of the streams have.
  std::optional<std::size_t> streams(const Json& attributes, std::optional<std::size_t> vertices,
                                     const std::string& place) {
    for (const auto& [semantic, value] : attributes.items()) {
      const auto number = gate_.reference(value, "accessors", in(place, semantic));
      const Accessor* accessor = gate_.accessor(number);
      if (accessor == nullptr) continue;
      format(semantic, accessor->format, in(place, semantic));
      if (!vertices) vertices = accessor->count;
      if (accessor->count != *vertices) {
        gate_.error(in(place, semantic), "unequal-counts",
                    fmt::format("accessor {} has {} elements, but the primitive's others have {}", *number,
                                accessor->count, *vertices));
      }
    }
    return vertices;
  }

  void format(const std::string& semantic, const Format& format, const std::string& place) {
    for (const SemanticRule& rule : rules) {
      if (semantic.compare(0, rule.prefix.size(), rule.prefix) != 0) continue;
      const bool joints = rule.prefix == "JOINTS_";
      const bool type_fits = joints ? format.component == Component::uint8 || format.component == Component::uint16
                                    : format.component != Component::uint32;
      if (type_fits && format.components >= rule.least && format.components <= rule.most) return;
      gate_.error(place, "attribute-type",
                  fmt::format("accessor has {} components of {} bytes, which {} cannot have", format.components,
                              bytes_of(format.component), semantic));
      return;
    }
  }

  /// Points, lines and triangles, of which each has corners of its own.
  static bool is_list(std::uint64_t mode) { return mode == 0 || mode == 1 || mode == 4; }

  std::optional<std::size_t> indices(const Json& primitive, std::optional<std::size_t> vertices, bool is_list,
                                     const std::string& place) {
    const auto number = gate_.reference(primitive, "indices", "accessors", place);
    const Accessor* accessor = gate_.accessor(number);
    if (accessor == nullptr) return std::nullopt;
    const Format& format = accessor->format;
    const bool is_unsigned = format.component == Component::uint8 || format.component == Component::uint16 ||
                             format.component == Component::uint32;
    if (format.components != 1 || !is_unsigned || format.normalized || !accessor->rows) {
      gate_.error(
          in(place, "indices"), "index-type",
          fmt::format(
              "accessor {} must be SCALAR of unsigned 8-, 16- or 32-bit integers, not normalized, in a buffer view",
              *number));
      return std::nullopt;
    }
    const IndexRange& range = range_of(*number, *accessor);
    if (range.does_restart && vertices) {
      const bool is_vertex = range.restart < *vertices;
      std::string message =
          fmt::format("accessor {} holds {}, which restarts primitives; glTF forbids it", *number, range.restart);
      if (is_vertex == is_list) {
        gate_.fault(is_list ? "restart-index" : "restart", in(place, "indices"), std::move(message));
      } else {
        gate_.error(in(place, "indices"), "primitive-restart", std::move(message));
      }
    }
    if (vertices && range.most >= *vertices) {
      gate_.error(
          in(place, "indices"), "index-range",
          fmt::format("accessor {} names vertex {}, but there are {} vertices", *number, range.most, *vertices));
    }
    return accessor->count;
  }

  /// Kept, since many primitives may share one accessor.
  const IndexRange& range_of(std::size_t number, const Accessor& accessor) {
    const auto [known, is_new] = ranges_.try_emplace(number);
    if (!is_new) return known->second;
    IndexRange& range = known->second;
    range.restart = restart_of(accessor.format.component);
    range.most = greatest_index(gate_.document(), accessor);
    range.does_restart = range.most == range.restart;
    if (!range.does_restart) return range;
    range.most = 0;
    for (const std::uint32_t index : index_elements(gate_.document(), accessor)) {
      if (index != range.restart) range.most = std::max(range.most, index);
    }
    return range;
  }

  void index_count(std::size_t count, std::uint64_t mode, const std::string& place) {
    struct Need {
      std::size_t least, multiple;
      const char* of;
    };
    static constexpr Need needs[] = {{1, 1, "points"},        {2, 2, "lines"},     {2, 1, "a line loop"},
                                     {2, 1, "a line strip"},  {3, 3, "triangles"}, {3, 1, "a triangle strip"},
                                     {3, 1, "a triangle fan"}};
    const Need& need = needs[mode];
    if (count < need.least) {
      gate_.fault("nothing-to-draw", place, fmt::format("{} corners are too few for {}", count, need.of));
    } else if (count % need.multiple != 0) {
      gate_.warning(
          place, "index-count",
          fmt::format("{} corners are not a whole number of {}; the leftover ones are not drawn", count, need.of));
    }
  }

  Gate& gate_;
  std::map<std::size_t, IndexRange> ranges_;
};

}  // namespace

namespace {

/// Levels of detail are moved by the same weights, and written again by us: they have one number of targets.
void check_targets_of_levels(Gate& gate) {
  const Json& meshes = gate.all("meshes");
  const auto targets_of = [&](const DrawOrigin& origin) {
    const Json& primitive = meshes[origin.mesh]["primitives"][origin.primitive];
    return primitive.contains("targets") ? primitive["targets"].size() : 0;
  };
  for (const Ladder& ladder : gate.document().ladders) {
    const std::size_t wanted = targets_of(ladder.full);
    for (const DrawOrigin& level : ladder.coarser) {
      const std::size_t own = targets_of(level);
      if (own == wanted) continue;
      gate.error(in(at(in(at("meshes", level.mesh), "primitives"), level.primitive), "targets"), "unequal-counts",
                 fmt::format("has {} morph targets, but the full level has {}", own, wanted));
    }
  }
}

}  // namespace

void check_meshes(Gate& gate) {
  const Json& meshes = gate.all("meshes");
  MeshCheck check(gate);
  for (std::size_t m = 0; m < meshes.size(); ++m) check.mesh(meshes[m], at("meshes", m));
  if (gate.sound()) check_targets_of_levels(gate);
}

}  // namespace foredraw::gltf
