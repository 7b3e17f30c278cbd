#pragma once
// Which stage makes which trait, followed through a pipeline: who needs what nobody made, and who undoes whose work.

#include <foredraw/pipeline/plan.h>

#include <functional>
#include <map>
#include <span>
#include <string>

namespace foredraw {

class TraitMakers {
 public:
  TraitMakers(const Registry& registry, Diagnostics& diagnostics) : registry_(registry), diagnostics_(diagnostics) {}

  /// What the stage that comes next lacks is told: an error where it needs it, a warning where it wants it; so is what
  /// it breaks or makes for nobody. `later`: the plugins of the stages after it.
  void look_around(const PlannedStage& planned, std::span<const Plugin* const> later) const;
  /// Keeps the books: who made what. What the stage undoes is told.
  void follow(const PlannedStage& planned);

 private:
  Traits made() const;
  bool has_needs(const PlannedStage& planned, std::span<const Plugin* const> later) const;

  const Registry& registry_;
  Diagnostics& diagnostics_;
  std::map<std::string, std::string, std::less<>> maker_;  ///< [trait]: the stage that made it
};

}  // namespace foredraw
