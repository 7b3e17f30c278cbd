#include "scene_wires.h"
#include "wires_product.h"

#include <foredraw/base/counted.h>
#include <foredraw/base/name_pattern.h>
#include <foredraw/technique/plugin.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <map>
#include <optional>

namespace foredraw {

namespace {

using processors::wire_radius::UnitWires;
using processors::wire_radius::WireUnit;

const char* text_of(WireRefusal why) {
  switch (why) {
    case WireRefusal::stout: return "too stout (`slender`)";
    case WireRefusal::flat: return "too flat or dented for a tube (`aspect`)";
    case WireRefusal::ribbon: return "a ribbon (`ribbons = false`)";
    case WireRefusal::decal: return "lies on a surface (`decal`)";
    case WireRefusal::small: return "too short (`least-length`)";
    case WireRefusal::joined:
      return "joins other things at all its corners, so none can move: it needs a ring of vertices between its ends";
    case WireRefusal::tiny: break;
  }
  return "too thin for 32-bit floats";
}

/// Which draw of the unit a triangle is in.
std::optional<std::size_t> draw_of(const UnitWires& wires, std::size_t triangle) {
  const auto next = std::ranges::upper_bound(wires.first_triangle, triangle);
  const auto draw = static_cast<std::size_t>(next - wires.first_triangle.begin()) - 1;
  if (draw + 1 >= wires.first_triangle.size()) return std::nullopt;
  return draw;
}

/// What vertices carry it in.
enum class As : std::uint8_t { attributes, texcoords };

struct StageOptions : WireOptions {
  std::string names;  ///< patterns with commas between them; empty: all draws are looked at
  As as = As::attributes;
};

std::vector<std::string_view> patterns_in(std::string_view text) {
  std::vector<std::string_view> patterns;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(','), text.size());
    std::string_view one = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    while (one.starts_with(' ')) one.remove_prefix(1);
    while (one.ends_with(' ')) one.remove_suffix(1);
    if (!one.empty()) patterns.push_back(one);
  }
  return patterns;
}

/// Those of the draws whose own name, material's name, or the name of a node that shows them is one that was chosen.
std::vector<DrawId> named_draws(const Scene& scene, const std::vector<DrawId>& draws, std::string_view names) {
  const std::vector<std::string_view> patterns = patterns_in(names);
  const auto is_chosen = [&](const std::string& name) {
    return std::ranges::any_of(patterns, [&](std::string_view pattern) { return matches(pattern, name); });
  };
  std::vector<bool> shown_so(scene.draws.size());
  for (const Node& node : scene.nodes) {
    if (!node.mesh || !is_chosen(node.name)) continue;
    for (const DrawId id : scene.meshes[*node.mesh].draws) shown_so[id] = true;
  }
  std::vector<DrawId> chosen;
  for (const DrawId id : draws) {
    const Material* material = scene.material_of(scene.draws[id]);
    if (shown_so[id] || is_chosen(scene.draws[id].name) || (material != nullptr && is_chosen(material->name))) {
      chosen.push_back(id);
    }
  }
  return chosen;
}

/// What somebody chose is taken if it has a centre line at all.
void take_any_shape(WireOptions& options) {
  options.slender = 2;
  options.aspect = 100;
  options.taper = 100;
  options.ribbons = true;
  options.decal = 0;
  options.least_length = 0;
}

class WireRadiusProcessor final : public Processor {
 public:
  explicit WireRadiusProcessor(StageOptions options) : options_(std::move(options)) {
    if (!options_.names.empty()) take_any_shape(options_);
  }

  std::vector<DrawId> process(Scene& scene, const std::vector<DrawId>& draws, Run& run) const override {
    const std::vector<DrawId> chosen = options_.names.empty() ? draws : named_draws(scene, draws, options_.names);
    if (chosen.empty() && !draws.empty()) {
      run.keep("no draw, material or node has a name that `names` asks for");
      return {};
    }
    processors::wire_radius::WireUnits units = processors::wire_radius::wire_units(scene, chosen);
    for (const processors::wire_radius::LeftDraw& left : units.left) {
      run.note_at({.draw = left.draw}, "left-alone", "its wires are left alone: " + left.why);
    }
    std::vector<UnitWires> found(units.units.size());
    const double part = 1 / static_cast<double>(std::max<std::size_t>(1, found.size()));
    std::atomic<std::size_t> done = 0;
    run.executor.for_each(found.size(), [&](std::size_t u) {
      if (run.cancelled()) return;
      WireSearch search{.cancel = run.cancel};
      if (run.progress && found.size() == 1) search.progress = run.progress;
      found[u] = processors::wire_radius::find_unit_wires(scene, units.units[u], options_, search, run.analyses);
      if (run.progress) run.progress(part * static_cast<double>(++done));
    });
    if (run.cancelled()) return {};
    Wires all;
    if (const Wires* before = scene.products.find<Wires>()) all = *before;
    std::vector<DrawId> changed;
    for (std::size_t u = 0; u < found.size(); ++u) {
      tell_refused(units.units[u], found[u], run);
      std::vector<std::uint32_t> ranged;
      for (const DrawId id : units.units[u].draws) {
        const std::vector<std::uint32_t> bounds = run.bounds(scene, {id, 0}, Wires::product);
        ranged.push_back(bounds.empty() ? 0 : bounds.back());
      }
      for (DrawWires& of :
           processors::wire_radius::put_wires(scene, units.units[u], found[u], ranged, options_.as == As::texcoords)) {
        changed.push_back(of.draw);
        std::erase_if(all.draws, [&](const DrawWires& old) { return old.draw == of.draw; });
        if (of.wires.empty()) continue;
        tell(scene, of, run);
        if (of.texcoords) {
          run.note_at({.draw = of.draw}, "texcoords",
                      fmt::format("its wires are in TEXCOORD_{} to TEXCOORD_{}", *of.texcoords, *of.texcoords + 3));
        }
        all.draws.push_back(std::move(of));
      }
    }
    if (changed.empty()) {
      run.keep(run.findings.notes.empty() ? "nothing in it is long and thin"
                                          : "no part was taken as a wire; the notes say why");
      return {};
    }
    std::ranges::sort(all.draws, {}, &DrawWires::draw);
    std::ranges::sort(changed);
    scene.products.set(std::move(all));
    return changed;
  }

 private:
  /// Figures alone: what was found is told by the product's row.
  static void tell(const Scene& scene, const DrawWires& of, const Run& run) {
    const About about{.draw = of.draw};
    std::array<double, 3> kinds{};
    for (const Wire& wire : of.wires) ++kinds[static_cast<std::size_t>(wire.kind)];
    const std::size_t triangles = scene.draws[of.draw].full().stream().triangle_count();
    run.count_at(about, "tubes", kinds[0]);
    run.count_at(about, "ribbons", kinds[1]);
    run.count_at(about, "nets", kinds[2]);
    run.measure_at(about, "share", static_cast<double>(triangles - of.first_triangle), static_cast<double>(triangles));
  }

  /// What is nearly a wire, draw by draw, with the longest of each kind.
  static void tell_refused(const WireUnit& unit, const UnitWires& wires, const Run& run) {
    struct Sum {
      std::size_t count = 0;
      RefusedWire longest;
    };
    std::map<std::pair<std::size_t, WireRefusal>, Sum> sums;
    for (const RefusedWire& refused : wires.found.refused) {
      const auto draw = draw_of(wires, refused.triangle);
      if (!draw) continue;
      Sum& sum = sums[{*draw, refused.why}];
      ++sum.count;
      if (refused.length > sum.longest.length) sum.longest = refused;
    }
    for (const auto& [key, sum] : sums) {
      const auto& [draw, why] = key;
      run.note_at(
          {.draw = unit.draws[draw]}, "no-wire",
          fmt::format("{} not taken as wires: {}; the longest is {:.3g} units long and {:.3g} wide, at triangle {}",
                      counted(sum.count, "part"), text_of(why), sum.longest.length, sum.longest.width,
                      sum.longest.triangle - wires.first_triangle[draw]));
    }
    for (const std::uint32_t wire : wires.bent) {
      run.note_at({.draw = unit.draws.front()}, "bent",
                  fmt::format("a wire of {:.3g} units is not taken: vertices around it follow different joints",
                              wires.found.wires[wire].length));
    }
  }

  StageOptions options_;
};

}  // namespace

Plugin wire_radius_plugin() {
  OptionTable<StageOptions> table;
  table
      .row(&WireOptions::slender, "slender", "A wire is at least this many times as long as it is wide, on average",
           {2, 1000, ""})
      .row(&WireOptions::aspect, "aspect",
           "The section of a tube is at most this many times as wide as thick; what is flatter is a board",
           {1, 100, ""})
      .row(&WireOptions::taper, "taper", "By which factor the width of a wire may change from end to end", {1, 100, ""})
      .row(&WireOptions::ribbons, "ribbons", "Take flat ribbons, and nets of them, too")
      .row(&WireOptions::decal, "decal",
           "A flat part is taken as painted on a surface, and not as a wire, if the surface lies within this many of "
           "its breadths in front of it or behind it; 0: it is taken as a wire",
           {0, 100, "breadths"})
      .row(&WireOptions::least_length, "least-length", "Shorter parts are not wires", {0, 1e30, "units"})
      .row(&StageOptions::names, "names",
           "Names that you know to be wires, such as \"rope*, Rail?\": draws with such a name, material or node are "
           "taken "
           "whatever their shape, and no others; the limits above do not count then")
      .choice(&StageOptions::as, "as",
              "What vertices know of their wire is stored as attributes of that name, or, for engines that import no "
              "others, as the next four sets of texture coordinates",
              {{"attributes", As::attributes}, {"texcoords", As::texcoords}});

  Plugin plugin;
  plugin.kind = Kind::processor;
  plugin.card = {
      .name = "wire-radius",
      .summary =
          "Finds wires, such as ropes, cables, railings and antennae, and stores their centre line and radius in each "
          "vertex, so that shaders keep them at least a pixel wide",
      .reference = "Persson 2012, Phone-wire AA",
      .acts_on = {traits::triangles},
      .breaks = {traits::cache_ordered, traits::overdraw_ordered, traits::fetch_ordered, traits::clustered},
      .pays_if = "a draw has something long and thin in it",
      .measured_by = {"thin-parts"},
      .metrics = {{"tubes", "wires", "Found with a closed section, or one open at the back", false},
                  {"ribbons", "wires", "Found that are flat", false},
                  {"nets", "wires", "Found of flat ribbons that cross", false},
                  {"share", "per triangle", "Triangles of wires", false}},
  };
  plugin.products = {wires_product()};
  bind_options(plugin, std::move(table),
               [](const StageOptions& options) { return std::make_unique<WireRadiusProcessor>(options); });
  return plugin;
}

}  // namespace foredraw
