#pragma once
// What stages make beside triangles and vertices: proved when it is made, told in the report, taken along by later
// stages.

#include <foredraw/report/report.h>
#include <foredraw/scene/product_row.h>

#include <set>
#include <string>

namespace foredraw {

/// The products of one stage.
class StageProducts {
 public:
  StageProducts(const ProductRows& rows, StageRecord& record) : rows_(rows), record_(record) {}

  /// What a stage made shows what the scene shows. Throws std::runtime_error where it does not.
  void prove(const Scene& before, const Scene& changed);
  /// The stage made this one of what the draws are now.
  void made(std::string_view name) { made_.emplace(name); }
  /// Notes what the stage made. What was there before goes along with what became of the draws, or is left out, and a
  /// note says why; so is that of which nobody here knows what a stage makes of it.
  void settle(const Scene& before, Scene& scene);

 private:
  void tell(const Products& before, const Scene& scene);
  void leave_out_unknown(Scene& scene);

  const ProductRows& rows_;
  StageRecord& record_;
  std::set<std::string, std::less<>> made_;
};

}  // namespace foredraw
