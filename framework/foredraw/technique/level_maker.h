#pragma once
// Makers of levels of detail answer with coarser levels; the framework checks them, measures how far they lie from full
// detail, and puts them behind it.

#include <foredraw/technique/orderer.h>

namespace foredraw {

/// A level, and how far it is said to lie from full detail, either way, in the draw's units, where it says so.
struct MadeLevel {
  std::shared_ptr<const VertexStreams> vertices;  ///< of full detail's layout; full detail's own, where indices will do
  Shared<std::uint32_t> indices;                  ///< three a triangle
  std::optional<double> largest = {};
  std::optional<double> rms = {};  ///< root of the mean square over both surfaces
};

/// [i][j]: level j + 1 of the view's draw i. In step: as many levels for each draw, so that a subject changes as one.
/// None at all leaves the subject as it is.
using SubjectLevels = std::vector<std::vector<MadeLevel>>;

/// Makes levels of the draws of one subject together, so that what they share stays together.
class LevelMaker {
 public:
  virtual ~LevelMaker() = default;
  virtual SubjectLevels levels(const SubjectView&, Run&) const = 0;
};

}  // namespace foredraw
