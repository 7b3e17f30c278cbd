#include "side_choices.h"

#include <algorithm>

namespace foredraw::processors::sides {

Plan cheapest_plan(const Sided& draw, double price, double call_price, bool may_split) {
  double all_gains = 0, lost = 0;
  std::size_t both_sides = 0, copied = 0;
  bool shows_backs = false;
  for (std::size_t t = 0; t < draw.wanted.size(); ++t) {
    all_gains += draw.gains[t];
    shows_backs |= (draw.wanted[t] & back) != 0;
    if (draw.wanted[t] != both) continue;
    ++both_sides;
    if (draw.gains[t] > price)
      ++copied;
    else
      lost += draw.gains[t];
  }
  if (!shows_backs) return {Choice::single_sided, {}, 0, all_gains};
  const double by_copies = price * static_cast<double>(both_sides);
  const double by_two = lost + price * static_cast<double>(copied) + call_price;
  if (by_copies < all_gains && (!may_split || by_copies <= by_two)) return {Choice::copies, {}, both_sides, all_gains};
  if (!may_split || by_two >= all_gains) return {Choice::left, {}, 0, 0};
  Plan plan{Choice::two_draws, std::vector<bool>(draw.wanted.size()), copied, all_gains - lost};
  for (std::size_t t = 0; t < draw.wanted.size(); ++t) {
    plan.stays[t] = draw.wanted[t] == both && !(draw.gains[t] > price);
  }
  return plan;
}

std::map<DrawId, Plan> plans(const std::map<DrawId, Sided>& draws, const Sizes& scene, const ChoiceOptions& options) {
  constexpr double least_of_a_draw = 0.01;  // of what is seen: a draw call is worth it from there on
  const double vertex_price = options.vertex_weight * scene.visible / std::max(1.0, scene.vertices);
  const auto at_price = [&](double least) {
    std::map<DrawId, Plan> result;
    for (const auto& [id, draw] : draws) {
      const double price = vertex_price * draw.vertices / std::max(1.0, static_cast<double>(draw.wanted.size()));
      result[id] = cheapest_plan(draw, std::max(price, least), least_of_a_draw * scene.visible, options.split);
    }
    return result;
  };
  const auto fits = [&](const std::map<DrawId, Plan>& all) {
    double added = 0;
    for (const auto& [id, plan] : all) added += static_cast<double>(plan.added);
    return added <= options.most_added * scene.triangles;
  };
  double low = 0;
  std::map<DrawId, Plan> best = at_price(low);
  if (fits(best)) return best;
  double high = scene.visible + 1;  // no triangle gains more
  best = at_price(high);
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double middle = low + (high - low) / 2;
    std::map<DrawId, Plan> more = at_price(middle);
    const bool does_fit = fits(more);
    (does_fit ? high : low) = middle;
    if (does_fit) best = std::move(more);
  }
  return best;
}

}  // namespace foredraw::processors::sides
