#pragma once
// What a machine takes to draw: the constants of the cost model, and the text file that holds them.
//
// T. Funkhouser, C. Sequin: Adaptive Display Algorithm for Interactive Frame Rates, SIGGRAPH 1993, section 4. What an
// object takes comes from its triangles, vertices and pixels, each times a constant of the machine and of the
// rendering.

#include <foredraw/frames/rendering.h>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace foredraw {

/// Nanoseconds that one more of each takes; 0 or more.
struct RenderingCost {
  double triangle = 0, vertex = 0, pixel = 0;
  friend bool operator==(const RenderingCost&, const RenderingCost&) = default;
};

/// How an object's two stages, triangles with vertices and pixels, come together.
enum class Stages : std::uint8_t {
  max,  ///< they work at once, so that the slower one counts: a GPU
  sum,  ///< one works after the other: a processor
};

constexpr std::string_view to_text(Stages stages) { return stages == Stages::max ? "max" : "sum"; }

struct RenderingCosts {
  std::string machine = {};  ///< its name, on one line; may be empty
  Stages stages = Stages::max;
  std::array<RenderingCost, all_renderings.size()> renderings = {};
  double frame = 0;  ///< nanoseconds that each frame takes, whatever it draws
  double draw = 0;   ///< nanoseconds that each draw call takes
  double posed = 0;  ///< nanoseconds more for each vertex that joints or morph targets move
  const RenderingCost& of(Rendering rendering) const { return renderings[static_cast<std::size_t>(rendering)]; }
  RenderingCost& of(Rendering rendering) { return renderings[static_cast<std::size_t>(rendering)]; }
  friend bool operator==(const RenderingCosts&, const RenderingCosts&) = default;
};

/// Numbers of no real machine, of a size that is usual for graphics cards. For examples, and where nothing was
/// measured.
RenderingCosts example_costs();

/// What is done for an object, or for several at once that are drawn by one rendering.
struct ObjectWork {
  Rendering rendering = Rendering::full;
  double triangles = 0;
  double vertices = 0;  ///< that are moved and shaded
  double pixels = 0;    ///< that are shaded, those that are hidden later too
  double draws = 1;     ///< draw calls
  double posed = 0;     ///< of the vertices, those that joints or morph targets move
  friend bool operator==(const ObjectWork&, const ObjectWork&) = default;
};

/// Nanoseconds for the object: both stages as the runtime's foredraw_lod_pipeline() or foredraw_lod_sum() puts them
/// together, in floats, and its draw calls.
double object_cost(const RenderingCosts& costs, const ObjectWork& work);

/// Nanoseconds for a frame of these objects. By `Stages::max` the slower stage counts for each object, as in the paper:
/// so a frame's cost is a sum over its objects, which a choice of levels within a budget needs.
double frame_cost(const RenderingCosts& costs, std::span<const ObjectWork> objects);

/// The costs as a text file, one line for each of these, in any sequence; empty lines and what follows # are left out:
///   machine NAME                    may be missing
///   stages max | sum
///   frame NANOSECONDS               that each frame takes
///   draw NANOSECONDS                that each draw call takes
///   posed NANOSECONDS               more for each vertex that joints or morph targets move; may be missing: nothing
///   full TRIANGLE VERTEX PIXEL      nanoseconds for each; the same for without-normal-map and unlit
/// Numbers are finite, from 0 to 1e9, and come back to the bit.
std::string costs_text(const RenderingCosts& costs);

/// Reads that text, or says what is wrong: "costs.txt:3: expected 'stages max' or 'stages sum', but found 'stages
/// min'". `name`: of the text, for messages.
std::variant<RenderingCosts, std::string> costs_in(std::string_view text, const std::string& name);

/// The same of a file.
std::variant<RenderingCosts, std::string> read_costs(const std::string& path);

}  // namespace foredraw
