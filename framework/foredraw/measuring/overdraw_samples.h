#pragma once
// From where to look to know a ratio as exactly as somebody asks.

#include <foredraw/overdraw/overdraw_figures.h>
#include <foredraw/scene/views.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace foredraw {

/// Views, of which every `views_in_sample` are one sample: what these count together scatters independently of what
/// others do, and its scatter is the error.
struct OverdrawSamples {
  Views views;
  std::size_t views_in_sample = 1;
};

/// Evenly spread sets of `count` orthographic or perspective views, each set turned at random: evenly spread views err
/// less than as many random ones, and sets turned independently tell by how much (randomised quasi-Monte Carlo; Owen,
/// Monte Carlo theory, methods and examples, chapter 17). Every turn also moves the pixels over the subject, so the
/// error of the resolution shows in the scatter too, and does not build up: a point of the picture counts as the
/// subject does there, at any resolution.
OverdrawSamples turned_sets(std::size_t count, std::uint64_t seed, double distance, int size);

/// How many sets turned_sets() makes.
inline constexpr std::size_t sets_of_views = 10;

/// How far from the mean of the sets the truth is, in standard errors, 99 times of 100 (Student's t with 9 degrees of
/// freedom). Who stops at the first error that is low enough errs more often than that; 95 of 100 is what is left.
inline constexpr double errors_to_bound = 3.25;

/// Pixels along the edge of the picture at which fragments cost about what triangles do: more of them, or more views of
/// fewer, would tell less for the same work. `triangles`: of the largest subject.
int balanced_size(std::size_t triangles);

/// How many views a set needs so that the error falls from what `count` views left to `wanted`. Errors of even sets
/// fall about with their count, as measured on the corpus (docs/results/overdraw-error.md).
std::size_t views_for(std::size_t count, double error, double wanted);

/// What each sample counts: the sums of every `views_in_sample` tallies.
std::vector<ViewTally> summed_by_sample(std::span<const ViewTally> tallies, std::size_t views_in_sample);

}  // namespace foredraw
