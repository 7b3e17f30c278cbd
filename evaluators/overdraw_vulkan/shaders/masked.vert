#version 450
// draw.vert, which also hands on where in its image each vertex lies.

layout(push_constant) uniform Draw {
  mat4 clip_from_position;
};

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 place_and_alpha;

layout(location = 0) out vec3 at;

invariant gl_Position;

void main() {
  gl_Position = clip_from_position * vec4(position, 1);
  at = place_and_alpha;
}
