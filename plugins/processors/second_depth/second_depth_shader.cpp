#include "second_depth_shader.h"

#include <string_view>

namespace foredraw {

namespace {

/// Held to runtime/second_depth.h line by line; a test compares them on a device. $2 and $3 are vectors of floats.
constexpr std::string_view text =
    R"(// Second-depth anti-aliasing, as foredraw/runtime/second_depth.h has it and says what it means.

#define SECOND_DEPTH_REACH 3
#define SECOND_DEPTH_NONE 2.0
#define SECOND_DEPTH_STRAIGHT 0.25

struct SecondDepthRule {
  float towards_far;  // 1: what is farther away has a larger depth; -1: a smaller one
  float absolute;     // slopes, per pixel, below absolute + relative * depth are noise: 8 / (2^bits - 1) and 0,
  float relative;     // or 0 and 8 / 2^24 for floats
  float round_rims;   // 1: the square of the thickness may be the line
};

float second_depth_bend(float a, float b, float c) {
  precise float bend = abs(a - 2.0 * b + c);
  return bend;
}

float second_depth_crease(float depth[7], float least) {
  precise float slope_before = depth[2] - depth[1];
  precise float slope_behind = depth[5] - depth[4];
  precise float turn = slope_before - slope_behind;
  bool turns = abs(turn) > least;
  precise float crease = (depth[4] - slope_behind - (depth[2] + slope_before)) / (turns ? turn : 1.0);
  precise float bend = crease > 0.0 ? second_depth_bend(depth[1], depth[2], depth[3])
                                    : second_depth_bend(depth[3], depth[4], depth[5]);
  precise float most = SECOND_DEPTH_STRAIGHT * abs(turn);
  return turns && abs(crease) <= 0.5 && bend <= most ? crease : SECOND_DEPTH_NONE;
}

bool second_depth_is_one_body($3 front, $3 back, bool has_third) {
  if (front.x <= back.y && front.y <= back.x) return true;
  precise float most = SECOND_DEPTH_STRAIGHT * abs(front.y - front.x);
  return has_third && second_depth_bend(front.x, front.y, front.z) <= most;
}

float second_depth_rim($3 front, $3 back, bool has_third, float least, float round_rims) {
  precise $3 t = back - front;
  precise $3 q = t * t;
  precise float slope = t.y - t.x;
  precise float q_slope = q.y - q.x;
  precise float bend = second_depth_bend(t.x, t.y, t.z);
  precise float q_bend = second_depth_bend(q.x, q.y, q.z);
  if (!(t.x > 0.0) || !(slope > least) || !second_depth_is_one_body(front, back, has_third)) return SECOND_DEPTH_NONE;
  precise float most = SECOND_DEPTH_STRAIGHT * q_slope;
  precise float as_round = q_bend * slope;
  precise float as_straight = bend * q_slope;
  if (has_third && round_rims > 0.0 && q_bend <= most && as_round < as_straight) return q.x / q_slope;
  return t.x / slope;
}

float second_depth_silhouette(float front[4], float back[4], int there, int opposite, float least, float round_rims) {
  if (there < 2) return SECOND_DEPTH_NONE;
  float rim = second_depth_rim($3(front[0], front[1], front[2]), $3(back[0], back[1], back[2]), true, least, round_rims);
  if (rim <= 0.5) return opposite > 0 ? -rim : SECOND_DEPTH_NONE;
  rim = second_depth_rim($3(front[1], front[2], front[3]), $3(back[1], back[2], back[3]), there > 2, least, round_rims);
  precise float edge = 1.0 - rim;
  return rim >= 0.5 && rim <= 1.0 ? edge : SECOND_DEPTH_NONE;
}

float second_depth_edge(SecondDepthRule rule, float depth[7], float second[7], int before, int behind) {
  precise float least = rule.relative * max(abs(depth[3]), max(abs(depth[2]), abs(depth[4])));
  least = rule.absolute + least;
  if (before > 0 && behind > 0 && !(second_depth_bend(depth[2], depth[3], depth[4]) > 0.5 * least)) {
    return SECOND_DEPTH_NONE;
  }
  float edge = SECOND_DEPTH_NONE;
  if (before > 1 && behind > 1) edge = second_depth_crease(depth, least);
  if (edge < SECOND_DEPTH_NONE) return edge;
  float front[4];
  float back[4];
  for (int i = 0; i < 4; ++i) {
    front[i] = depth[3 + i] * rule.towards_far;
    back[i] = second[3 + i] * rule.towards_far;
  }
  float right = second_depth_silhouette(front, back, behind, before, least, rule.round_rims);
  for (int j = 0; j < 4; ++j) {
    front[j] = depth[3 - j] * rule.towards_far;
    back[j] = second[3 - j] * rule.towards_far;
  }
  float left = second_depth_silhouette(front, back, before, behind, least, rule.round_rims);
  return abs(left) < abs(right) ? -left : right;
}

// What to add to the pixel's middle, in pixels, before a bilinear fetch from the frame.
$2 second_depth_offset(float row, float column) {
  bool is_row = abs(row) <= abs(column);
  float edge = is_row ? row : column;
  precise float part = max(0.5 - abs(edge), 0.0);
  part = edge < 0.0 ? -part : part;
  return is_row ? $2(part, 0.0) : $2(0.0, part);
}
)";

}  // namespace

std::string second_depth_shader_text(ShaderLanguage language) {
  const std::string vector = language == ShaderLanguage::glsl ? "vec" : "float";
  std::string result;
  for (const char c : text) result += c == '$' ? vector : std::string(1, c);
  return result;
}

}  // namespace foredraw
