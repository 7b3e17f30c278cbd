#pragma once
// What is seen of a surface, found step by step: cheap pictures of everything first, dear rays for what is left.

#include "connected.h"
#include "hidden.h"
#include "seen_by_rays.h"
#include "sight.h"

#include <foredraw/scene/views.h>

namespace foredraw::processors::hidden {

inline constexpr int most_checks = 8;  ///< rounds, of which each puts back what the pictures show

/// Triangles with a position that is not finite: nobody can ask whether they are seen.
Flags not_finite(std::span<const RasterPart> parts);

class SeenSearch {
 public:
  /// `seen`: what stays, whoever sees it. The others must outlive the search.
  SeenSearch(const Connected& surface, Flags seen, const HiddenOptions& options, const BetweenSteps& between,
             const Executor& executor);

  /// Looks at the surface as it stands there: by the views, or from inside where cameras are; then by so many rays of
  /// each triangle that is still not seen, and is not known to lie within something closed.
  void look(const Sight& sight, std::span<const View> views, std::size_t rays, std::uint64_t seed);

  /// Pictures of what would go; what they show of it is put back. Views: of cameras outside.
  Pixels check(const Sight& sight, std::span<const View> views, std::uint64_t seed);

  /// [triangle] what may go.
  Flags hidden() const;
  bool hides_any() const;

  /// [triangle] what is hidden without a sample.
  const Flags& proved() const { return proved_; }

 private:
  Flags open() const;
  Flags open_to_rays() const;
  bool is_any_of(const Sight& sight, const Flags& flags) const;
  void add_by_pictures(const Sight& sight, std::span<const View> views);
  void add_proved(const Sight& sight);
  void add_neighbours(const Sight& sight, const Rays& tree, std::vector<WayOut> ways, std::uint64_t seed);
  void add_by_rays(const Sight& sight, std::size_t rays, std::uint64_t seed);

  const Connected& surface_;
  Flags seen_;
  Flags proved_;
  const HiddenOptions& options_;
  const BetweenSteps& between_;
  const Executor& executor_;
};

}  // namespace foredraw::processors::hidden
