// FOREDRAW_lod_table, read and written.
#include "lod_table_product.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

using Wrong = WrongExtension;

double number(const ExtensionValue& value, const char* name, double least, double most) {
  const auto number = value.number();
  if (!number || !(*number >= least && *number <= most)) {
    throw Wrong(std::string("has a '") + name + "' that is not a number from " + std::to_string(least) + " to " +
                std::to_string(most));
  }
  return *number;
}

double number(const ExtensionValue& of, const char* name, double most) {
  return number(needed_member(of, name), name, 0, most);
}

std::uint32_t whole(const ExtensionValue& value, const char* name) {
  const auto number = value.whole();
  if (!number) throw Wrong(std::string("has a '") + name + "' that is not a whole number below 2^32");
  return *number;
}

const List& list(const ExtensionValue& value, const char* name, std::size_t least, std::size_t most) {
  const List* held = value.list();
  if (held == nullptr || held->size() < least || held->size() > most) {
    throw Wrong(std::string("has '") + name + "' that are not an array of " + std::to_string(least) +
                (least == most ? "" : " to " + std::to_string(most)));
  }
  return *held;
}

constexpr double most_nanoseconds = 1e9;
constexpr std::size_t longest_name = 200;
constexpr auto most_length = static_cast<double>(std::numeric_limits<float>::max());

RenderingCosts costs_from(const ExtensionValue& file) {
  RenderingCosts costs;
  const std::string* machine = needed_member(file, "machine").text();
  if (machine == nullptr || machine->size() > longest_name) throw Wrong("has no 'machine' of at most 200 bytes");
  costs.machine = *machine;
  const std::string* stages = needed_member(file, "stages").text();
  for (const Stages each : {Stages::max, Stages::sum}) {
    if (stages != nullptr && *stages == to_text(each)) costs.stages = each;
  }
  if (stages == nullptr || *stages != to_text(costs.stages)) throw Wrong("has no 'stages', \"max\" or \"sum\"");
  costs.frame = number(file, "frame", most_nanoseconds);
  costs.draw = number(file, "draw", most_nanoseconds);
  const List& renderings =
      list(needed_member(file, "renderings"), "renderings", LodTable::renderings, LodTable::renderings);
  for (std::size_t i = 0; i < renderings.size(); ++i) {
    const std::string* name = needed_member(renderings[i], "name").text();
    if (name == nullptr || *name != to_text(all_renderings[i])) {
      throw Wrong("has renderings that are not full, without-normal-map and unlit");
    }
    costs.renderings[i] = {number(renderings[i], "triangle", most_nanoseconds),
                           number(renderings[i], "vertex", most_nanoseconds),
                           number(renderings[i], "pixel", most_nanoseconds)};
  }
  return costs;
}

LodTable::OfDraw draw_from(const ExtensionValue& value, DrawId id) {
  LodTable::OfDraw draw;
  draw.draw = id;
  draw.radius = static_cast<float>(number(value, "radius", most_length));
  if (!(draw.radius > 0)) throw Wrong("has a 'radius' of 0");
  draw.coverage = static_cast<float>(number(value, "coverage", 1));
  draw.importance = static_cast<float>(number(value, "importance", 1));
  const List& accuracy = list(needed_member(value, "accuracy"), "accuracy", LodTable::renderings, LodTable::renderings);
  for (std::size_t i = 0; i < accuracy.size(); ++i) {
    draw.accuracy[i] = static_cast<float>(number(accuracy[i], "accuracy", 0, 1));
  }
  for (const ExtensionValue& level : list(needed_member(value, "levels"), "levels", 1, LodTable::most_levels)) {
    draw.levels.push_back(
        {whole(needed_member(level, "triangles"), "triangles"), whole(needed_member(level, "shaded"), "shaded"),
         whole(needed_member(level, "vertices"), "vertices"), static_cast<float>(number(level, "error", most_length))});
  }
  const List& hulls = list(needed_member(value, "hulls"), "hulls", LodTable::octaves, LodTable::octaves);
  for (std::size_t octave = 0; octave < hulls.size(); ++octave) {
    const List& masks = list(hulls[octave], "hulls", LodTable::renderings, LodTable::renderings);
    for (std::size_t i = 0; i < masks.size(); ++i) {
      const std::uint32_t mask = whole(masks[i], "hulls");
      if ((std::uint64_t{mask} >> draw.levels.size()) != 0)
        throw Wrong("has a hull with levels that the draw does not have");
      draw.hulls[octave][i] = mask;
    }
  }
  return draw;
}

Members value_of(const LodTable::OfDraw& draw) {
  return {{"radius", draw.radius},
          {"coverage", draw.coverage},
          {"importance", draw.importance},
          {"accuracy", List(draw.accuracy.begin(), draw.accuracy.end())},
          {"levels", listed(draw.levels,
                            [](const LodTable::OfLevel& level) {
                              return Members{{"triangles", level.triangles},
                                             {"shaded", level.shaded},
                                             {"vertices", level.vertices},
                                             {"error", level.error}};
                            })},
          {"hulls", listed(draw.hulls, [](const auto& masks) { return List(masks.begin(), masks.end()); })}};
}

}  // namespace

std::variant<LodTable, std::string> read_lod_table(ExtensionReader& from, const Scene& scene) {
  std::string place = "it ";
  try {
    const ExtensionValue* file = from.of_file();
    if (file == nullptr) return std::string("the file does not say what things cost");
    LodTable table{costs_from(*file), {}};
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      place = scene.draws[id].name + ' ';
      table.draws.push_back(draw_from(*value, id));
    }
    if (table.draws.empty()) return std::string("no primitive has a row");
    return table;
  } catch (const Wrong& wrong) {
    return place + wrong.what();
  }
}

void write_lod_table(const LodTable& table, ExtensionWriter& to) {
  const RenderingCosts& costs = table.costs;
  List renderings;
  for (const Rendering rendering : all_renderings) {
    const RenderingCost& of = costs.of(rendering);
    renderings.push_back(Members{{"name", std::string(to_text(rendering))},
                                 {"triangle", of.triangle},
                                 {"vertex", of.vertex},
                                 {"pixel", of.pixel}});
  }
  to.put_on_file(Members{{"machine", costs.machine},
                         {"stages", std::string(to_text(costs.stages))},
                         {"frame", costs.frame},
                         {"draw", costs.draw},
                         {"renderings", std::move(renderings)}});
  for (const LodTable::OfDraw& draw : table.draws) to.put_on_draw(draw.draw, value_of(draw));
}

}  // namespace foredraw
