#version 450
// Moves a vertex of an object to where the camera sees it. What fragments need is from the camera on, so that it is exact
// far from the origin too.

struct Object {
  vec4 x, y, w;               // rows to clip space, whose z is the near plane's distance
  vec4 eye_x, eye_y, eye_z;   // rows to the vector from the eye
  vec4 along_x, along_y, along_z;  // columns for normals
};

layout(push_constant) uniform Draw {
  vec4 colour;
  float normal_scale;
  float cutoff;
  float near;
};

layout(std430, set = 0, binding = 0) readonly buffer Objects { Object objects[]; };

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 base_place;
layout(location = 3) in vec2 normal_map_place;

layout(location = 0) out vec3 from_eye;
layout(location = 1) out vec3 moved_normal;
layout(location = 2) out vec2 base_at;
layout(location = 3) out vec2 normal_map_at;

void main() {
  Object object = objects[gl_InstanceIndex];
  vec4 p = vec4(position, 1);
  gl_Position = vec4(dot(object.x, p), dot(object.y, p), near, dot(object.w, p));
  from_eye = vec3(dot(object.eye_x, p), dot(object.eye_y, p), dot(object.eye_z, p));
  moved_normal = object.along_x.xyz * normal.x + object.along_y.xyz * normal.y + object.along_z.xyz * normal.z;
  base_at = base_place;
  normal_map_at = normal_map_place;
}
