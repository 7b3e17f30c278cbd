#pragma once
// Which stages belong before a stage and after it, by what the cards say that they provide, break, need, want and use.

#include <foredraw/technique/registry.h>

namespace foredraw {

/// How what is wanted, and not made yet, comes about: the plugins that provide it, before them those that provide what
/// they need or want in turn. "'forsyth' or 'tipsify', then 'linear-clusters'"; empty where no plugin provides any.
std::string way_to(const Traits& wanted, const Traits& made, const Registry& registry);

/// What a stage breaks for good though some plugin brings it back at no price: it provides it, needs nothing and breaks
/// nothing. Of orderers only: a processor makes something new, of which nothing holds yet. Of several stages that break
/// it, it is the last one's.
Traits left_broken(const Plugin& stage, std::span<const Plugin* const> later, const Registry& registry);

/// The plugins that bring these back at no price: "'vertex-fetch'".
std::string who_restores(const Traits& broken, const Registry& registry);

/// What a clusterer provides and no later stage asks for. Clusters are for later stages alone: no file keeps them.
Traits left_unused(const Plugin& stage, std::span<const Plugin* const> later);

/// The plugins that need, want or use one of these: "'dot-rule' or 'occlusion-order'".
std::string who_asks_for(const Traits& provided, const Registry& registry);

}  // namespace foredraw
