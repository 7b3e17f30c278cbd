#pragma once
// Figures gathered: by plugin, then by metric, each with its unit and error.

#include <foredraw/technique/plugin.h>

#include <map>
#include <string>

namespace foredraw {

/// A figure, or what several come to that were measured in several places.
struct Figure {
  double numerator = 0;
  std::optional<double> denominator;  ///< none: a count
  double error = 0;                   ///< one standard deviation; 0: exact
  std::string unit;
  bool lower_is_better = true;
  bool worst_stands = false;  ///< over several places the worst one stands, not their sum
  bool is_neutral = false;    ///< as on the card's metric: no gain and no loss where it changes

  /// Not a number where the denominator is 0.
  double value() const { return denominator ? numerator / *denominator : numerator; }
};

/// "0.7053", with " ±0.0040" where it has an error; a count without places; "-" where it is no number.
std::string to_text(const Figure& figure);

class Metrics {
 public:
  /// Adds to what is there, or, of figures of which the worst one stands, puts the worse one there. Numerators and
  /// denominators add up; errors are averaged by their denominators (those of counts add up), which is never too low,
  /// however the errors are correlated.
  void add(const std::string& plugin, const std::string& metric, const Figure& figure);
  void add(const Metrics& others);
  /// Puts the figure in the place of what is there.
  void set(const std::string& plugin, const std::string& metric, const Figure& figure);

  const Figure* find(const std::string& plugin, const std::string& metric) const;
  /// By both with a dot between them: "vertex-cache.models.amd.acmr".
  const Figure* find(const std::string& name) const;
  const std::map<std::string, std::map<std::string, Figure>>& all() const { return by_plugin_; }
  bool empty() const { return by_plugin_.empty(); }

 private:
  std::map<std::string, std::map<std::string, Figure>> by_plugin_;
};

/// The figure for what a plugin measured. Unit and direction are those of the card's metric of that name, or of the
/// name behind the last dot ("models.fifo-32.acmr" is an acmr).
Figure figure_of(const Measured& measured, const Card& card);

}  // namespace foredraw
