// FOREDRAW_packed_vertices, read and written.
#include "packed_vertices_product.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace foredraw {

namespace {

using List = ExtensionValue::List;
using Members = ExtensionValue::Members;

constexpr std::array<std::string_view, FOREDRAW_PACKED_FIELDS> field_names = {
    "x", "y", "z", "normal0", "normal1", "tangent", "sign", "u", "v"};
constexpr std::string_view spare = "spare";
constexpr std::string_view method_names[] = {"octahedral", "spherical"};

using Wrong = WrongExtension;

const List& list(const ExtensionValue& value, const char* name, std::size_t count) {
  const List* held = value.list();
  if (held == nullptr || held->size() != count) {
    throw Wrong(std::string("has '") + name + "' that are not an array of " + std::to_string(count));
  }
  return *held;
}

std::int32_t integer(const ExtensionValue& value, const char* name, std::int32_t most) {
  const auto number = value.number();
  if (!number || !(std::abs(*number) <= most) || *number != std::floor(*number)) {
    throw Wrong(std::string("has a '") + name + "' that is not a whole number of at most " + std::to_string(most));
  }
  return static_cast<std::int32_t>(*number);
}

void add_field(PackedLayout& layout, const ExtensionValue& value, std::uint32_t word, std::uint32_t& used) {
  const std::string* name = needed_member(value, "field").text();
  const auto bits = needed_member(value, "bits").whole();
  if (name == nullptr || !bits || *bits < 1 || *bits > 32) throw Wrong("has a field without a name and bits, 1 to 32");
  if (used + *bits > 32) throw Wrong("has a word of more than 32 bits");
  if (*name != spare) {
    const auto* found = std::ranges::find(field_names, *name);
    if (found == field_names.end()) throw Wrong("has a field whose name is not known");
    foredraw_packed_field& field = layout.field[found - field_names.begin()];
    if (field.bits != 0) throw Wrong("has the field '" + *name + "' twice");
    field = {word, used, *bits};
  }
  used += *bits;
}

PackedLayout layout_from(const ExtensionValue& value) {
  PackedLayout layout{};
  const std::string* method = needed_member(value, "method").text();
  const auto* known = method == nullptr ? std::end(method_names) : std::ranges::find(method_names, *method);
  if (known == std::end(method_names)) throw Wrong("has no 'method', \"octahedral\" or \"spherical\"");
  layout.is_spherical = known == std::begin(method_names) ? 0 : 1;
  const List& words = list(needed_member(value, "words"), "words", 4);
  for (std::uint32_t word = 0; word < 4; ++word) {
    const List* fields = words[word].list();
    std::uint32_t used = 0;
    for (std::size_t i = 0; fields != nullptr && i < fields->size(); ++i) add_field(layout, (*fields)[i], word, used);
    if (used != 32) throw Wrong("has a word of " + std::to_string(used) + " bits, not 32");
  }
  constexpr std::int32_t most = 1 << 24;
  const List& origin = list(needed_member(value, "origin"), "origin", 3);
  for (std::size_t i = 0; i < 3; ++i) layout.origin[i] = integer(origin[i], "origin", most);
  layout.step = std::ldexp(1.0f, integer(needed_member(value, "step"), "step", 100));
  if (layout.field[FOREDRAW_PACKED_U].bits != 0) {
    const List& uv_origin = list(needed_member(value, "uvOrigin"), "uvOrigin", 2);
    const List& uv_step = list(needed_member(value, "uvStep"), "uvStep", 2);
    for (std::size_t i = 0; i < 2; ++i) {
      layout.uv_origin[i] = integer(uv_origin[i], "uvOrigin", most);
      const auto step = uv_step[i].number();
      if (!step || !(*step > 0 && *step < 1e30)) throw Wrong("has a 'uvStep' that is not a number above 0");
      layout.uv_step[i] = static_cast<float>(*step);
    }
  }
  if (foredraw_packed_is_layout(&layout) == 0) throw Wrong("has a layout whose fields or numbers are out of range");
  return layout;
}

Members layout_value(const PackedLayout& layout) {
  std::array<List, 4> words;
  std::array<std::uint32_t, 4> used{};
  std::vector<std::size_t> order;
  for (std::size_t f = 0; f < field_names.size(); ++f) order.push_back(f);
  std::ranges::sort(order, {}, [&](std::size_t f) { return std::pair(layout.field[f].shift, f); });
  const auto put = [&](std::uint32_t word, std::string_view name, std::uint32_t bits) {
    if (bits > 0) words[word].push_back(Members{{"field", std::string(name)}, {"bits", bits}});
    used[word] += bits;
  };
  for (const std::size_t f : order) {
    const foredraw_packed_field& field = layout.field[f];
    if (field.bits == 0) continue;
    put(field.word, spare, field.shift - used[field.word]);
    put(field.word, field_names[f], field.bits);
  }
  for (std::uint32_t word = 0; word < 4; ++word) put(word, spare, 32 - used[word]);
  Members value = {{"method", std::string(method_names[layout.is_spherical])},
                   {"words", List(words.begin(), words.end())},
                   {"origin", List(std::begin(layout.origin), std::end(layout.origin))},
                   {"step", std::ilogb(layout.step)}};
  if (layout.field[FOREDRAW_PACKED_U].bits != 0) {
    value.emplace_back("uvOrigin", List(std::begin(layout.uv_origin), std::end(layout.uv_origin)));
    value.emplace_back("uvStep", List(std::begin(layout.uv_step), std::end(layout.uv_step)));
  }
  return value;
}

Shared<std::uint32_t> rows_from(const ExtensionValue& value, ExtensionReader& from) {
  const auto data = value.whole() ? from.accessor(*value.whole()) : std::nullopt;
  const Format wanted{Component::uint32, 4, false, 16};
  if (!data || !(data->format == wanted)) throw Wrong("has rows that are missing or are not four unsigned ints");
  std::vector<std::uint32_t> rows(std::size_t{4} * data->count);
  std::memcpy(rows.data(), data->bytes.view().data(), data->bytes.size());
  return Shared<std::uint32_t>(std::move(rows));
}

PackedVertices::OfDraw draw_from(const ExtensionValue& value, DrawId id, const Draw& draw, ExtensionReader& from) {
  PackedVertices::OfDraw packed{.draw = id, .layout = layout_from(needed_member(value, "layout"))};
  if (const ExtensionValue* posed = value.member("posed")) packed.posed = layout_from(*posed);
  for (const ExtensionValue& level : list(needed_member(value, "rows"), "rows", draw.levels.size())) {
    packed.rows.push_back(rows_from(level, from));
  }
  return packed;
}

}  // namespace

std::variant<PackedVertices, std::string> read_packed_vertices(ExtensionReader& from, const Scene& scene) {
  PackedVertices all;
  for (DrawId id = 0; id < scene.draws.size(); ++id) {
    const ExtensionValue* value = from.of_draw(id);
    if (value == nullptr) continue;
    try {
      all.draws.push_back(draw_from(*value, id, scene.draws[id], from));
    } catch (const Wrong& wrong) {
      return scene.draws[id].name + ' ' + wrong.what();
    }
  }
  if (all.draws.empty()) return std::string("no primitive has rows");
  return all;
}

void write_packed_vertices(const PackedVertices& all, ExtensionWriter& to) {
  for (const PackedVertices::OfDraw& draw : all.draws) {
    Members value = {{"rows", listed(draw.rows,
                                     [&](const Shared<std::uint32_t>& rows) {
                                       return to.accessor(accessor_data(rows.view(), Component::uint32, 4));
                                     })},
                     {"layout", layout_value(draw.layout)}};
    if (draw.posed) value.emplace_back("posed", layout_value(*draw.posed));
    to.put_on_draw(draw.draw, std::move(value));
  }
}

}  // namespace foredraw
