#pragma once
// Tables that choose among orders of draws, while a stage orders subjects anew.

#include <foredraw/pipeline/answers.h>
#include <foredraw/pipeline/stage_products.h>

#include <vector>

namespace foredraw {

class ChangedTables {
 public:
  /// Changes the scene, which stays where it is.
  explicit ChangedTables(Scene& scene);

  /// The subject's draws at that level are ordered anew. Engines choose among several orders at full detail alone: of
  /// the others the one that stands alone is kept.
  void put(OrderedSubject answer, std::size_t level);
  /// The tables that there are now become the scene's product, made by this stage.
  void settle(StageProducts& products);

 private:
  void forget_tables_of(DrawId id);

  Scene& scene_;
  std::vector<OrderTable> tables_;
};

}  // namespace foredraw
