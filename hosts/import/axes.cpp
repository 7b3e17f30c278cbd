#include "axes.h"

#include <cmath>
#include <optional>

namespace foredraw::import {

namespace {

/// The direction of an axis that the file names by its number and its sign.
std::optional<aiVector3D> axis(const aiMetadata& said, const char* name) {
  int number = 0, sign = 0;
  if (!said.Get(name, number) || !said.Get(std::string(name) + "Sign", sign)) return std::nullopt;
  if (number < 0 || number > 2 || (sign != 1 && sign != -1)) return std::nullopt;
  aiVector3D direction(0, 0, 0);
  direction[static_cast<unsigned>(number)] = static_cast<float>(sign);
  return direction;
}

/// A float or a double, as Assimp's versions have it.
std::optional<float> number(const aiMetadata& said, const char* name) {
  float single = 0;
  double twice = 0;
  if (said.Get(name, single)) return single;
  if (said.Get(name, twice)) return static_cast<float>(twice);
  return std::nullopt;
}

}  // namespace

bool is_fbx(const aiScene& scene) { return scene.mMetaData != nullptr && number(*scene.mMetaData, "UnitScaleFactor"); }

aiMatrix4x4 transform_of_root(const aiScene& scene) {
  if (!is_fbx(scene)) return scene.mRootNode->mTransformation;
  const aiMetadata& said = *scene.mMetaData;
  const auto unit = number(said, "UnitScaleFactor");
  const auto right = axis(said, "CoordAxis"), up = axis(said, "UpAxis"), front = axis(said, "FrontAxis");
  const float metres = std::isfinite(*unit) && *unit > 0 ? *unit / 100 : 0.01f;
  aiVector3D x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  if (right && up && front && std::abs(*right * (*up ^ *front)) > 0.5f) {
    x = *right;
    y = *up;
    z = *front;
  }
  x *= metres;
  y *= metres;
  z *= metres;
  return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1};
}

}  // namespace foredraw::import
