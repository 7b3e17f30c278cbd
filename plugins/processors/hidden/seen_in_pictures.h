#pragma once
// Triangles that pictures of a thing show.

#include "hidden.h"
#include "sight.h"

#include <foredraw/scene/views.h>

#include <span>

namespace foredraw::processors::hidden {

class Pictures {
 public:
  explicit Pictures(const Sight& sight);

  /// Flags in `seen` what the views show of the triangles `asked`: what has a fragment than which no other thing is
  /// nearer; of equally near ones all count as seen. What it answers does not depend on the executor.
  Pixels add_seen(std::span<const View> views, int size, const Flags& asked, Flags& seen,
                  const Executor& executor) const;

 private:
  const Sight& sight_;
  std::vector<PreparedPart> parts_;
};

}  // namespace foredraw::processors::hidden
