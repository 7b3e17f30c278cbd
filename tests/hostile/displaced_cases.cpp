#include "displaced_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace foredraw::testing {

namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();

void each(std::vector<float>& rows, std::size_t width, std::size_t step, const std::vector<float>& value) {
  for (std::size_t i = 0; i < rows.size(); i += width * step)
    std::copy(value.begin(), value.end(), rows.begin() + std::ptrdiff_t(i));
}

void scale(std::vector<float>& values, float by) {
  for (float& value : values) value *= by;
}

GltfJson& transform(Parts& of) {
  return of.displacement["displacementGeometryTexture"]["extensions"]["KHR_texture_transform"];
}

DisplacedCase number(const char* name, const char* member, const GltfJson& value) {
  return {name, [=](Parts& of) { of.displacement[std::string("displacementGeometry") + member] = value; }};
}

}  // namespace

const std::vector<DisplacedCase>& displaced_layouts() {
  static const std::vector<DisplacedCase> all = {
      {"uv-no-number",
       [](Parts& of) {
         each(of.uvs, 2, 3, {nan, 0.5f});
       }},
      {"uv-no-numbers",
       [](Parts& of) {
         each(of.uvs, 2, 1, {nan, nan});
       }},
      {"uv-infinite",
       [](Parts& of) {
         each(of.uvs, 2, 4, {inf, -inf});
       }},
      {"uv-1e30",
       [](Parts& of) {
         each(of.uvs, 2, 4, {1e30f, -1e30f});
       }},
      {"uv-negative",
       [](Parts& of) {
         for (float& uv : of.uvs) uv -= 7;
       }},
      {"uv-tiled", [](Parts& of) { scale(of.uvs, 40); }},
      {"uv-point",
       [](Parts& of) {
         each(of.uvs, 2, 1, {0.5f, 0.5f});
       }},
      {"uv-line",
       [](Parts& of) {
         for (std::size_t i = 1; i < of.uvs.size(); i += 2) of.uvs[i] = 0.5f;
       }},
      {"uv-none", [](Parts& of) { of.uvs.clear(); }},
      {"second-uv-none", [](Parts& of) { of.displacement["displacementGeometryTexture"]["texCoord"] = 1; }},
      {"nearest", [](Parts& of) { of.sampler["magFilter"] = 9728; }},
      {"mirrored",
       [](Parts& of) {
         of.sampler["wrapS"] = of.sampler["wrapT"] = 33648;
         scale(of.uvs, -3);
       }},
      {"transform",
       [](Parts& of) {
         transform(of) = {{"offset", {0.5, 3}}, {"scale", {1e20, 0}}, {"rotation", 1}};
       }},
  };
  return all;
}

const std::vector<DisplacedCase>& displaced_normals() {
  static const std::vector<DisplacedCase> all = {
      {"none", [](Parts& of) { of.normals.clear(); }},
      {"zero", [](Parts& of) { scale(of.normals, 0); }},
      {"no-number",
       [](Parts& of) {
         each(of.normals, 3, 3, {nan, 0, 1});
       }},
      {"long", [](Parts& of) { scale(of.normals, 1e38f); }},
      {"opposite",
       [](Parts& of) {
         for (std::size_t i = of.normals.size() / 2; i < of.normals.size(); ++i) of.normals[i] *= -1;
       }},
      {"position-no-number",
       [](Parts& of) {
         each(of.positions, 3, 7, {nan, 0, 0});
       }},
      {"position-1e30", [](Parts& of) { scale(of.positions, 1e30f); }},
      {"position-1e-30", [](Parts& of) { scale(of.positions, 1e-30f); }},
      {"position-point",
       [](Parts& of) {
         each(of.positions, 3, 1, {1, 1, 1});
       }},
      {"degenerate",
       [](Parts& of) {
         of.indices.insert(of.indices.begin(), {0, 0, 0, 1, 1, 2});
       }},
      {"three-at-an-edge",
       [](Parts& of) {
         of.indices.insert(of.indices.end(), {0, 1, 20, 1, 0, 25});
       }},
      {"twice",
       [](Parts& of) {
         const auto once = of.indices;
         of.indices.insert(of.indices.end(), once.begin(), once.end());
       }},
  };
  return all;
}

const std::vector<DisplacedCase>& displaced_numbers() {
  static const std::vector<DisplacedCase> all = {
      number("factor-0", "Factor", 0),
      number("factor-negative", "Factor", -2),
      number("factor-1e30", "Factor", 1e30),
      number("factor-1e-40", "Factor", 1e-40),
      number("factor-text", "Factor", "1"),
      number("factor-1e300", "Factor", 1e300),
      number("offset-1e30", "Offset", 1e30),
      number("offset-negative", "Offset", -0.5),
      number("offset-list", "Offset", {1}),
      number("texture-9", "Texture", {{"index", 9}}),
      number("no-texture", "Texture", nullptr),
      {"beyond-floats",
       [](Parts& of) {
         of.displacement["displacementGeometryFactor"] = of.displacement["displacementGeometryOffset"] = 3e38;
       }},
  };
  return all;
}

}  // namespace foredraw::testing
