#pragma once
// Who chooses the levels of a crowd.

#include <foredraw/crowds/crowd_levels.h>
#include <foredraw/runtime/crowd_select.h>

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace foredraw {

enum class CrowdMethod {
  constant,    ///< everybody at the finest level
  paper,       ///< clamp(M Tmax / N, 1, Tmax), made whole (Tatarchuk, Barczak, Purnomo 2008)
  root,        ///< Tmax sqrt(M / N), made whole
  exact,       ///< foredraw_crowd_select(), frame by frame
  hysteresis,  ///< the same, with levels that stay
};
inline constexpr CrowdMethod all_crowd_methods[] = {CrowdMethod::constant, CrowdMethod::paper, CrowdMethod::root,
                                                    CrowdMethod::exact, CrowdMethod::hysteresis};
constexpr std::string_view to_text(CrowdMethod of) {
  constexpr std::string_view texts[] = {"constant", "paper", "root", "exact", "hysteresis"};
  return texts[static_cast<int>(of)];
}

class CrowdChooser {
 public:
  /// The crowd has to live longer. std::invalid_argument where the runtime refuses its levels.
  CrowdChooser(CrowdMethod method, const Crowd& crowd, std::uint32_t characters, foredraw_spacing spacing,
               float hysteresis);

  /// Formulas need levels that are tessellated.
  static bool is_able(CrowdMethod method, const Crowd& crowd);

  /// Chooses anew for each instance. `is_new`: [instance] it was not in the frame before.
  void choose(std::span<const float> distances, std::span<const std::uint8_t> is_new);

  std::span<const std::uint8_t> chosen() const { return chosen_; }  ///< [instance] number among the crowd's levels

 private:
  std::uint8_t by_formula(std::uint32_t instances) const;

  CrowdMethod method_;
  const Crowd& crowd_;
  std::uint32_t characters_;
  foredraw_spacing spacing_;
  float hysteresis_;
  foredraw_crowd_table table_{};
  std::vector<std::uint32_t> memory_;
  std::vector<std::uint8_t> chosen_;
};

}  // namespace foredraw
