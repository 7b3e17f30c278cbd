#pragma once
// A crowd on a plane, and an eye that walks through it.

#include <foredraw/base/random.h>

#include <cstdint>
#include <vector>

namespace foredraw {

struct CrowdPathOptions {
  std::uint32_t instances = 1000;
  double near = 2;          ///< units; the eye's height over the plane, so nothing is nearer
  double far = 40;          ///< units; what is on the square around the eye is no farther, but for its height
  double eye_speed = 1.4;   ///< units a second
  double walk_speed = 1.4;  ///< units a second, of the fastest; the slowest is half as fast
  double rate = 30;         ///< frames a second
  std::uint64_t seed = 0;
};

/// Everybody walks straight on and turns somewhere else every 3 seconds in the mean; the eye turns every 10. Whoever
/// leaves the square around the eye comes in again on the other side, as somebody else. The same everywhere.
class CrowdPath {
 public:
  explicit CrowdPath(const CrowdPathOptions& options);

  /// The next frame.
  void step();

  const std::vector<float>& distances() const { return distances_; }   ///< [instance] units
  const std::vector<std::uint8_t>& is_new() const { return is_new_; }  ///< [instance] was not in the frame before

 private:
  struct Walker {
    double x = 0, z = 0;    ///< from the eye
    double dx = 0, dz = 0;  ///< a second
  };
  void turn(Walker& walker, double speed);
  void look();

  CrowdPathOptions options_;
  Random random_;
  double half_side_;
  Walker eye_;
  std::vector<Walker> walkers_;
  std::vector<float> distances_;
  std::vector<std::uint8_t> is_new_;
};

}  // namespace foredraw
