#version 450
// One invocation for each vertex that the device does not find in its cache: the vertex buffer is drawn as it is.

layout(push_constant) uniform Draw {
  mat4 clip_from_position;
  uint owner;
};

layout(location = 0) in vec3 position;

invariant gl_Position;

void main() { gl_Position = clip_from_position * vec4(position, 1); }
