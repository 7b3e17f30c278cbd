#include <foredraw/pipeline/eligible.h>

#include <foredraw/base/name_pattern.h>
#include <foredraw/base/printable.h>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace foredraw {

std::string missing(const Traits& wanted, const Traits& held) {
  std::string text;
  for (const std::string& name : wanted) {
    if (held.has(name)) continue;
    if (!text.empty()) text += " and ";
    text += name;
  }
  return text;
}

Traits after_stage(const Card& card, Traits traits) {
  traits.remove(card.breaks);
  traits.add(card.provides);
  return traits;
}

namespace {

bool orders_triangles(const PlannedStage& stage) {
  return std::holds_alternative<std::unique_ptr<DrawOrderer>>(*stage.technique) ||
         std::holds_alternative<std::unique_ptr<SubjectOrderer>>(*stage.technique);
}

}  // namespace

Holders holders_of_draws(const Scene& scene, const ProductRows& rows) {
  Holders holders;
  for (const auto& row : rows) {
    if (!scene.products.has(row->card().name)) continue;
    for (const DrawId draw : row->held(scene)) holders.emplace(draw, row->card().title);
  }
  return holders;
}

std::optional<std::string> names_instead(const Stage& stage, const Scene& scene) {
  const auto is_named = [&](const Draw& draw) { return matches(stage.only, draw.name); };
  if (stage.only.empty() || scene.draws.empty() || std::ranges::any_of(scene.draws, is_named)) return std::nullopt;
  constexpr std::size_t most = 8;
  std::vector<std::string> names;
  for (const Draw& draw : scene.draws) {
    if (std::ranges::find(names, draw.name) == names.end()) names.push_back(draw.name);
    if (names.size() > 1000) break;
  }
  if (const std::string_view near = nearest(stage.only, names); !near.empty()) {
    return fmt::format("did you mean '{}'?", printable(near));
  }
  std::string text = "its draws are called ";
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) {
    text += (i == 0 ? "'" : ", '") + printable(names[i]) + "'";
  }
  return text + (names.size() > most ? " and so on" : "") + "; * stands for any characters";
}

std::optional<Skip> why_not(const PlannedStage& stage, const Scene& scene, DrawId id, const Traits& traits,
                            const Holders& holders) {
  const Draw& draw = scene.draws[id];
  const Card& card = stage.plugin->card;
  if (!stage.stage.only.empty() && !matches(stage.stage.only, draw.name)) {
    return Skip{id, "only", "not named by only = \"" + stage.stage.only + '"'};
  }
  if (const std::string lacks = missing(card.acts_on, traits); !lacks.empty()) {
    return Skip{id, "does-not-apply", "not " + lacks};
  }
  if (stage.plugin->kind == Kind::evaluator) return std::nullopt;
  if (const auto held = holders.find(id); held != holders.end()) {
    return Skip{id, "held",
                fmt::format("the {} refer to its triangles and vertices by number: put this stage before the one that "
                            "makes them, or first write the file with --products none",
                            held->second)};
  }
  if (traits.has(traits::extended)) {
    return Skip{id, "extended", "has an extension that may refer to its triangles or vertices by number"};
  }
  if (orders_triangles(stage) && traits.has(traits::blended) && !stage.stage.blended) {
    return Skip{id, "blended", "alpha-blended, so its order may be visible (blended = true reorders it anyway)"};
  }
  if (const std::string lacks = missing(card.needs, traits); !lacks.empty()) {
    return Skip{id, "needs", "not " + lacks};
  }
  return std::nullopt;
}

}  // namespace foredraw
