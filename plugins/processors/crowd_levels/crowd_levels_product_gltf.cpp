// FOREDRAW_crowd_levels, read and written.
#include "crowd_levels_product.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

constexpr auto most_length = static_cast<double>(std::numeric_limits<float>::max());
constexpr std::uint32_t most_characters = 1'000'000;
constexpr CrowdClass all_classes[] = {CrowdClass::tessellated, CrowdClass::plain, CrowdClass::simplified};
constexpr foredraw_spacing all_spacings[] = {FOREDRAW_SPACING_EQUAL, FOREDRAW_SPACING_FRACTIONAL_ODD,
                                             FOREDRAW_SPACING_FRACTIONAL_EVEN};

using Wrong = WrongExtension;

float distance(const ExtensionValue& of, const char* name) {
  const auto number = needed_member(of, name).number();
  if (!number || !(*number >= 0 && *number <= most_length)) {
    throw Wrong(fmt::format("has a '{}' that is not a number from 0 to 3.4e38", name));
  }
  return static_cast<float>(*number);
}

std::uint32_t whole(const ExtensionValue& of, const char* name, std::uint32_t least, std::uint32_t most) {
  const auto number = needed_member(of, name).whole();
  if (!number || *number < least || *number > most) {
    throw Wrong(fmt::format("has a '{}' that is not a whole number from {} to {}", name, least, most));
  }
  return *number;
}

template <class All>
auto choice(const ExtensionValue& of, const char* name, const All& all) {
  const std::string* text = needed_member(of, name).text();
  const auto found =
      std::ranges::find_if(all, [&](const auto each) { return text != nullptr && *text == to_text(each); });
  if (found == std::end(all)) throw Wrong(fmt::format("has a '{}' that is not known", name));
  return *found;
}

constexpr std::uint32_t any = std::numeric_limits<std::uint32_t>::max();

CrowdLevel level_from(const ExtensionValue& value) {
  CrowdLevel level;
  level.kind = choice(value, "class", all_classes);
  const bool is_plain = level.kind == CrowdClass::plain, is_tessellated = level.kind == CrowdClass::tessellated;
  level.number = whole(value, "number", is_plain ? 0 : 1,
                       is_plain         ? 0
                       : is_tessellated ? 64
                                        : CrowdLevels::most_levels);
  level.triangles = whole(value, "triangles", 0, any);
  level.vertices = whole(value, "vertices", 0, any);
  level.largest = distance(value, "largest");
  level.rms = distance(value, "rms");
  if (level.rms > level.largest) throw Wrong("has an 'rms' above its 'largest'");
  return level;
}

/// Tessellated ones from the finest on, plain, and all simplified ones in turn.
void check_sequence(const std::vector<CrowdLevel>& levels, foredraw_spacing spacing) {
  std::size_t at = 0;
  for (; at < levels.size() && levels[at].kind == CrowdClass::tessellated; ++at) {
    const std::uint32_t parts = levels[at].number;
    if (foredraw_tessellation_parts(static_cast<float>(parts), spacing) != parts) {
      throw Wrong(fmt::format("has {} parts of an edge, which its spacing does not allow", parts));
    }
    if (at > 0 && parts >= levels[at - 1].number)
      throw Wrong("has parts of edges that do not fall from level to level");
  }
  if (at == levels.size() || levels[at].kind != CrowdClass::plain)
    throw Wrong("has no plain level after tessellated ones");
  for (std::uint32_t number = 1; ++at < levels.size(); ++number) {
    if (levels[at].kind != CrowdClass::simplified || levels[at].number != number) {
      throw Wrong("has simplified levels that are not 1, 2, ... in turn");
    }
  }
}

CrowdLevels::OfDraw draw_from(const ExtensionValue& value, DrawId id, foredraw_spacing spacing) {
  CrowdLevels::OfDraw draw;
  draw.draw = id;
  draw.crowd = whole(value, "crowd", 0, any);
  draw.area = distance(value, "area");
  const List* levels = needed_member(value, "levels").list();
  if (levels == nullptr || levels->empty() || levels->size() > CrowdLevels::most_levels) {
    throw Wrong(fmt::format("has 'levels' that are not an array of 1 to {}", CrowdLevels::most_levels));
  }
  for (const ExtensionValue& level : *levels) draw.levels.push_back(level_from(level));
  check_sequence(draw.levels, spacing);
  return draw;
}

bool has_rows_of(const CrowdLevels::OfDraw& a, const CrowdLevels::OfDraw& b) {
  return std::ranges::equal(a.levels, b.levels, [](const CrowdLevel& x, const CrowdLevel& y) {
    return x.kind == y.kind && x.number == y.number;
  });
}

/// Draws of a crowd are drawn at the same row, and their triangles can be added up.
void check_crowds(const CrowdLevels& levels, const Scene& scene) {
  std::map<std::uint32_t, const CrowdLevels::OfDraw*> first;
  std::map<std::uint32_t, std::uint64_t> most;
  for (const CrowdLevels::OfDraw& draw : levels.draws) {
    const auto [found, is_first] = first.emplace(draw.crowd, &draw);
    if (!is_first && !has_rows_of(draw, *found->second)) {
      throw Wrong(fmt::format("has other levels on {} than on {}", scene.draws[draw.draw].name,
                              scene.draws[found->second->draw].name));
    }
    most[draw.crowd] += std::ranges::max_element(draw.levels, {}, &CrowdLevel::triangles)->triangles;
    if (most[draw.crowd] >= any) throw Wrong("has more triangles than 32 bits count");
  }
}

}  // namespace

std::variant<CrowdLevels, std::string> read_crowd_levels(ExtensionReader& from, const Scene& scene) {
  std::string place = "it ";
  try {
    const ExtensionValue* file = from.of_file();
    if (file == nullptr) return std::string("the file does not say how many characters its budget is");
    CrowdLevels levels{whole(*file, "characters", 1, most_characters), choice(*file, "spacing", all_spacings), {}};
    for (DrawId id = 0; id < scene.draws.size(); ++id) {
      const ExtensionValue* value = from.of_draw(id);
      if (value == nullptr) continue;
      place = scene.draws[id].name + ' ';
      levels.draws.push_back(draw_from(*value, id, levels.spacing));
    }
    place = "it ";
    if (levels.draws.empty()) return std::string("no primitive has levels");
    check_crowds(levels, scene);
    return levels;
  } catch (const Wrong& wrong) {
    return place + wrong.what();
  }
}

void write_crowd_levels(const CrowdLevels& levels, ExtensionWriter& to) {
  to.put_on_file(Members{{"characters", levels.characters}, {"spacing", std::string(to_text(levels.spacing))}});
  for (const CrowdLevels::OfDraw& draw : levels.draws) {
    to.put_on_draw(draw.draw, Members{{"crowd", draw.crowd},
                                      {"area", draw.area},
                                      {"levels", listed(draw.levels, [](const CrowdLevel& level) {
                                         return Members{{"class", std::string(to_text(level.kind))},
                                                        {"number", level.number},
                                                        {"triangles", level.triangles},
                                                        {"vertices", level.vertices},
                                                        {"largest", level.largest},
                                                        {"rms", level.rms}};
                                       })}});
  }
}

}  // namespace foredraw
