#include <foredraw/report/inspection.h>
#include <foredraw/report/private/json_values.h>

#include <foredraw/analysis/scene_facts.h>
#include <foredraw/base/counted.h>
#include <foredraw/io/text/extension_text.h>
#include <foredraw/report/table.h>
#include <foredraw/scene/levels.h>
#include <foredraw/scene/subject.h>
#include <foredraw/scene/vertex_groups.h>

#include <fmt/format.h>

namespace foredraw {

namespace {

std::string_view text_of_one(Topology topology) {
  switch (topology) {
    case Topology::triangles: return "triangle";
    case Topology::lines: return "line";
    case Topology::points: return "point";
  }
  return "triangle";
}

std::string text_of(Topology topology) { return std::string(text_of_one(topology)) + 's'; }

std::size_t elements(const Draw& draw, std::size_t level = 0) {
  const std::size_t indices = draw.levels[level].stream().indices.size();
  switch (draw.topology) {
    case Topology::triangles: return indices / 3;
    case Topology::lines: return indices / 2;
    case Topology::points: return indices;
  }
  return indices;
}

std::string attributes_text(const VertexStreams& vertices) {
  std::string text;
  for (const VertexStream& stream : vertices.base) text += (text.empty() ? "" : " ") + stream.semantic;
  if (!vertices.morph_targets.empty()) text += " + " + counted(vertices.morph_targets.size(), "morph target");
  return text;
}

std::vector<std::string> names_of(const Traits& traits) { return {traits.begin(), traits.end()}; }

std::string odd_text(const MeshFacts& facts) {
  std::string text;
  for (const auto& [name, count] : named_counts(facts)) {
    if (count > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, name);
  }
  return text;
}

std::string levels_text(const Scene& scene) {
  std::string text;
  for (const Draw& draw : scene.draws) {
    for (std::size_t i = 1; i < draw.levels.size(); ++i) {
      const bool shares = draw.levels[i].vertices == draw.full().vertices;
      text += fmt::format(
          "  {}: {}, {}; error {:.4g}\n", name_of(draw, i), counted(elements(draw, i), text_of_one(draw.topology)),
          shares ? "vertices of full detail" : counted(draw.levels[i].vertices->count, "vertex", "vertices"),
          draw.levels[i].error);
    }
  }
  return text;
}

Json levels_json(const Draw& draw) {
  Json json = Json::array();
  for (std::size_t i = 1; i < draw.levels.size(); ++i) {
    json.push_back({{"elements", elements(draw, i)},
                    {"vertices", draw.levels[i].vertices->count},
                    {"shares-vertices", draw.levels[i].vertices == draw.full().vertices},
                    {"error", draw.levels[i].error}});
  }
  return json;
}

std::string images_text(const Scene& scene) {
  std::string text;
  for (std::size_t i = 0; i < scene.images.size(); ++i) {
    const Image& image = scene.images[i];
    text += fmt::format("  {}: ", image.name.empty() ? fmt::format("image{}", i) : image.name);
    if (const auto& facts = image.facts) {
      text += fmt::format("{} x {}, {} of {} bits{}\n", facts->width, facts->height,
                          counted(static_cast<std::uint64_t>(facts->channels), "channel"), facts->bits,
                          facts->is_float ? ", float" : "");
    } else if (!image.uri.empty()) {
      text += fmt::format("the file {}\n", image.uri);
    } else {
      text += image.media_type.empty() ? "of an unknown kind, or damaged\n"
                                       : fmt::format("{}, not looked into\n", image.media_type);
    }
  }
  return text;
}

/// What the rows tell of the products that the scene has.
std::vector<std::pair<std::string, ProductText>> products_of(const Scene& scene, const ProductRows& rows) {
  std::vector<std::pair<std::string, ProductText>> told;
  for (const auto& row : rows) {
    const std::string name = row->card().name;
    if (scene.products.has(name)) told.emplace_back(name, row->told(scene));
  }
  return told;
}

Json images_json(const Scene& scene) {
  Json json = Json::array();
  for (const Image& image : scene.images) {
    Json& one = json.emplace_back(Json{{"name", image.name}, {"media-type", image.media_type}});
    if (!image.uri.empty()) one["uri"] = image.uri;
    if (image.uri.empty()) one["bytes"] = image.bytes.size();
    if (!image.facts) continue;
    one["width"] = image.facts->width;
    one["height"] = image.facts->height;
    one["channels"] = image.facts->channels;
    one["bits"] = image.facts->bits;
    one["float"] = image.facts->is_float;
  }
  return json;
}

}  // namespace

std::string inspection_text(const Scene& scene, const ProductRows& rows, Analyses& analyses, const Executor& executor) {
  std::string text =
      fmt::format("{}: {} in {} on {}, {}, {}, {}, {}, {}\n\n", scene.name, counted(scene.draws.size(), "draw"),
                  counted(scene.meshes.size(), "mesh", "meshes"), counted(scene.nodes.size(), "node"),
                  counted(vertex_groups(scene).size(), "vertex stream"), counted(scene.materials.size(), "material"),
                  counted(scene.skins.size(), "skin"), counted(scene.animations.size(), "animation"),
                  counted(scene.images.size(), "image"));
  Table table({"draw", "count", "primitives", "vertices", "bytes/vertex", "attributes", "traits"});
  std::string odd;
  const std::vector<MeshFacts> facts = facts_of_draws(scene, analyses, executor);
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const Draw& draw = scene.draws[id];
    const VertexStreams& vertices = *draw.full().vertices;
    table.add({draw.name, counted(elements(draw)), text_of(draw.topology), counted(vertices.count),
               std::to_string(vertices.bytes_per_vertex()), attributes_text(vertices),
               fmt::format("{}", fmt::join(traits_of(draw), " "))});
    if (const std::string what = odd_text(facts[id]); !what.empty()) {
      odd += fmt::format("  {}: {}\n", draw.name, what);
    }
  }
  text += table.text();
  if (!odd.empty()) text += "\nunusual:\n" + odd;
  if (const std::string levels = levels_text(scene); !levels.empty()) {
    text += "\nlevels of detail (besides full detail):\n" + levels;
  }
  for (const auto& [name, product] : products_of(scene, rows)) {
    text += fmt::format("\n{}:\n", product.heading);
    for (const std::string& line : product.lines) text += fmt::format("  {}\n", line);
  }
  if (!scene.images.empty()) text += "\nimages:\n" + images_text(scene);
  text += "\nsubjects (seen and judged together):\n";
  for (const Subject& subject : subjects_of(scene)) {
    text += fmt::format("  {}: {}\n", subject.name, counted(subject.parts.size(), "draw"));
  }
  return text;
}

std::string inspection_json(const Scene& scene, const ProductRows& rows, const Diagnostics& told, Analyses& analyses,
                            const Executor& executor) {
  Json json{{"inspection", 1},
            {"file", scene.name},
            {"meshes", scene.meshes.size()},
            {"nodes", scene.nodes.size()},
            {"materials", scene.materials.size()},
            {"skins", scene.skins.size()},
            {"images", images_json(scene)},
            {"vertex-streams", vertex_groups(scene).size()}};
  json["animations"] = Json::array();
  for (const Animation& animation : scene.animations) {
    json["animations"].push_back({{"name", animation.name}, {"channels", animation.channels.size()}});
  }
  json["draws"] = Json::array();
  const std::vector<MeshFacts> facts = facts_of_draws(scene, analyses, executor);
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const Draw& draw = scene.draws[id];
    const VertexStreams& vertices = *draw.full().vertices;
    Json counts = Json::object();
    for (const auto& [name, count] : named_counts(facts[id])) counts[std::string(name)] = count;
    Json attributes = Json::array();
    for (const VertexStream& stream : vertices.base) attributes.push_back(stream.semantic);
    json["draws"].push_back({{"name", draw.name},
                             {"topology", text_of(draw.topology)},
                             {"elements", elements(draw)},
                             {"orders", draw.full().orders.size()},
                             {"vertices", vertices.count},
                             {"bytes-per-vertex", vertices.bytes_per_vertex()},
                             {"attributes", attributes},
                             {"morph-targets", vertices.morph_targets.size()},
                             {"traits", names_of(traits_of(draw))},
                             {"facts", counts}});
    if (draw.levels.size() > 1) json["draws"].back()["levels"] = levels_json(draw);
  }
  json["products"] = Json::object();
  for (const auto& [name, product] : products_of(scene, rows))
    json["products"][name] = Json::parse(json_text(product.value));
  json["diagnostics"] = Json::array();
  for (const Diagnostic& diagnostic : told.all()) json["diagnostics"].push_back(json_of(diagnostic));
  json["subjects"] = Json::array();
  for (const Subject& subject : subjects_of(scene)) {
    Json draws = Json::array();
    for (const SubjectPart& part : subject.parts) draws.push_back(scene.draws[part.draw].name);
    json["subjects"].push_back({{"name", subject.name}, {"draws", draws}});
  }
  return indented_text(json) + '\n';
}

}  // namespace foredraw
