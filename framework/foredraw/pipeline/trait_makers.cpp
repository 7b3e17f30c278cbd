#include <foredraw/pipeline/trait_makers.h>

#include <foredraw/pipeline/eligible.h>
#include <foredraw/pipeline/stage_order.h>

#include <fmt/format.h>

#include <algorithm>

namespace foredraw {

/// What stages so far have made, and none has undone.
Traits TraitMakers::made() const {
  Traits made;
  for (const auto& [trait, maker] : maker_) made.add(Trait(trait));
  return made;
}

/// A need that no earlier stage was to provide is a mistake in the pipeline; one that was not met for some draws
/// alone is a reason to skip those.
bool TraitMakers::has_needs(const PlannedStage& planned, std::span<const Plugin* const> later) const {
  const Card& card = planned.plugin->card;
  const bool unmet = std::ranges::any_of(planned.skips, [](const Skip& skip) { return skip.code == "needs"; });
  const std::string lacks = missing(card.needs, made());
  if (!unmet || lacks.empty()) return true;
  Traits wanted = card.needs;
  wanted.add(card.wants);
  const std::string before = way_to(wanted, made(), registry_);
  const std::string after = who_restores(left_broken(*planned.plugin, later, registry_), registry_);
  diagnostics_.error(
      planned.stage.where, "needs",
      fmt::format("'{}' needs draws that are {}, but no stage before it makes them so", card.name, lacks),
      way_to(card.needs, made(), registry_).empty() ? "no plugin in this build provides that"
      : after.empty()                               ? fmt::format("put {} before it", before)
                                                    : fmt::format("put {} before it, and {} after it", before, after));
  return false;
}

void TraitMakers::look_around(const PlannedStage& planned, std::span<const Plugin* const> later) const {
  if (!has_needs(planned, later) || planned.draws.empty()) return;
  const Card& card = planned.plugin->card;
  if (const std::string lacks = missing(card.wants, made()); !lacks.empty()) {
    const std::string before = way_to(card.wants, made(), registry_);
    diagnostics_.warning(
        planned.stage.where, "wants",
        fmt::format("'{}' works best on draws that are {}, but no stage before it makes them so", card.name, lacks),
        before.empty() ? "" : fmt::format("put {} before it", before));
  }
  Traits broken = left_broken(*planned.plugin, later, registry_);
  broken.remove(made());  // of which it is said who undoes whose work
  if (!broken.empty()) {
    diagnostics_.warning(planned.stage.where, "left-broken",
                         fmt::format("after '{}', draws are no longer {}, and no later stage restores that", card.name,
                                     missing(broken, {})),
                         fmt::format("put {} after it", who_restores(broken, registry_)));
  }
  if (const Traits unused = left_unused(*planned.plugin, later); !unused.empty()) {
    const std::string users = who_asks_for(unused, registry_);
    diagnostics_.warning(planned.stage.where, "unused",
                         fmt::format("'{}' makes draws {} for later stages, but none uses that, and no file keeps it",
                                     card.name, missing(unused, {})),
                         users.empty() ? "" : fmt::format("put {} after it", users));
  }
}

void TraitMakers::follow(const PlannedStage& planned) {
  const Card& card = planned.plugin->card;
  for (const std::string& trait : card.breaks) {
    const auto made = maker_.find(trait);
    if (made == maker_.end() || made->second == card.name || card.provides.has(trait)) continue;
    if (card.needs.has(trait) || card.acts_on.has(trait)) {  // used up, not undone
      maker_.erase(made);
      continue;
    }
    diagnostics_.warning(planned.stage.where, "undoes",
                         fmt::format("'{}' undoes what '{}' made ({})", card.name, made->second, trait),
                         fmt::format("put '{}' before '{}'", card.name, made->second));
    maker_.erase(made);
  }
  for (const std::string& trait : card.provides) maker_[trait] = card.name;
}

}  // namespace foredraw
