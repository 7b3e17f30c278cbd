#include <foredraw/pipeline/stage_order.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

namespace {

/// "'a' or 'b'": the plugins that are so.
template <class Is>
std::string names_of_plugins(const Registry& registry, Is is) {
  std::vector<std::string> names;
  for (const Plugin* plugin : registry.all()) {
    if (is(*plugin)) names.push_back(fmt::format("'{}'", plugin->card.name));
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

bool asks_for(const Card& card, Trait trait) {
  return card.needs.has(trait) || card.wants.has(trait) || card.uses.has(trait);
}

bool restores(const Plugin& plugin, Trait trait) {
  return plugin.kind != Kind::clusterer && plugin.card.provides.has(trait) && plugin.card.needs.empty() &&
         plugin.card.breaks.empty();
}

void add_steps(const Traits& wanted, Traits& made, const Registry& registry, std::vector<std::string>& steps) {
  for (const std::string& trait : wanted) {
    if (made.has(trait)) continue;
    made.add(Trait(trait));  // before those who provide it are asked what they need: so no circle is endless
    const auto provides = [&](const Plugin& plugin) { return plugin.card.provides.has(trait); };
    const std::vector<const Plugin*> all = registry.all();
    const auto first = std::ranges::find_if(all, [&](const Plugin* plugin) { return provides(*plugin); });
    if (first == all.end()) continue;
    add_steps((*first)->card.needs, made, registry, steps);
    add_steps((*first)->card.wants, made, registry, steps);
    steps.push_back(names_of_plugins(registry, provides));
  }
}

}  // namespace

std::string way_to(const Traits& wanted, const Traits& made, const Registry& registry) {
  std::vector<std::string> steps;
  Traits then = made;
  add_steps(wanted, then, registry, steps);
  return fmt::format("{}", fmt::join(steps, ", then "));
}

Traits left_broken(const Plugin& stage, std::span<const Plugin* const> later, const Registry& registry) {
  Traits broken;
  if (stage.kind != Kind::orderer) return broken;
  const std::vector<const Plugin*> all = registry.all();
  for (const std::string& trait : stage.card.breaks) {
    const bool has_its_turn = std::ranges::any_of(
        later, [&](const Plugin* other) { return other->card.provides.has(trait) || other->card.breaks.has(trait); });
    const bool comes_back = std::ranges::any_of(all, [&](const Plugin* other) { return restores(*other, trait); });
    if (!stage.card.provides.has(trait) && !has_its_turn && comes_back) broken.add(Trait(trait));
  }
  return broken;
}

std::string who_restores(const Traits& broken, const Registry& registry) {
  return names_of_plugins(registry, [&](const Plugin& plugin) {
    return std::ranges::any_of(broken, [&](const std::string& trait) { return restores(plugin, trait); });
  });
}

Traits left_unused(const Plugin& stage, std::span<const Plugin* const> later) {
  Traits unused;
  if (stage.kind != Kind::clusterer) return unused;
  for (const std::string& trait : stage.card.provides) {
    // Whoever breaks it is told of as one that undoes it.
    const bool has_its_turn = std::ranges::any_of(
        later, [&](const Plugin* other) { return asks_for(other->card, trait) || other->card.breaks.has(trait); });
    if (!has_its_turn) unused.add(Trait(trait));
  }
  return unused;
}

std::string who_asks_for(const Traits& provided, const Registry& registry) {
  return names_of_plugins(registry, [&](const Plugin& plugin) {
    return std::ranges::any_of(provided, [&](const std::string& trait) { return asks_for(plugin.card, trait); });
  });
}

}  // namespace foredraw
