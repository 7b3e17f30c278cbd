#pragma once
#include <foredraw/technique/draw_view.h>
#include <foredraw/technique/run.h>

namespace foredraw {

/// Cuts the triangle order of one draw into contiguous clusters. Called for many draws at once.
class Clusterer {
 public:
  static constexpr std::string_view works_on = "draws";
  virtual ~Clusterer() = default;
  virtual Clusters cluster(const DrawView&, Run&) const = 0;
};

}  // namespace foredraw
