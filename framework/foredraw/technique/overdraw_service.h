#pragma once
// Measured overdraw for techniques that want it, whoever answers: a plugin says uses = {overdraw} on its card and asks
// run.overdraw; the pipeline's [services] says which evaluator that is.

#include <foredraw/scene/subject.h>
#include <foredraw/scene/views.h>
#include <foredraw/technique/run.h>

#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// ratio = shaded / visible; 1 is the limit.
struct OverdrawCount {
  std::uint64_t shaded = 0;   ///< fragments that pass the depth test, in draw order
  std::uint64_t visible = 0;  ///< fragments that stay
  std::uint64_t ties = 0;     ///< fragments equally near as what was there before them
  OverdrawCount& operator+=(const OverdrawCount& other) {
    shaded += other.shaded;
    visible += other.visible;
    ties += other.ties;
    return *this;
  }
};

/// For each part of a subject, in its sequence, and each view.
struct SubjectOverdraw {
  std::size_t views = 0;
  std::vector<OverdrawCount> counts;  ///< [part * views + view]
  OverdrawCount& at(std::size_t part, std::size_t view) { return counts[part * views + view]; }
  const OverdrawCount& at(std::size_t part, std::size_t view) const { return counts[part * views + view]; }
};

class OverdrawService {
 public:
  virtual ~OverdrawService() = default;
  /// Draws the subject's parts in their sequence from every view and counts. Blended parts are left out.
  virtual SubjectOverdraw count(const Scene&, const Subject&, const Views&, Run&) = 0;
};

}  // namespace foredraw
