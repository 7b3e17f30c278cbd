#version 450
// Draws with a number out of a buffer.

layout(push_constant) uniform Draw {
  uint which;
};

layout(set = 0, binding = 0) readonly buffer Offset { uint offset; };
layout(set = 0, binding = 1) readonly buffer Numbers { uint numbers[]; };

layout(location = 0) in vec2 corner;
layout(location = 1) in float depth;

layout(location = 0) flat out uint number;

void main() {
  gl_Position = vec4(corner, depth, 1);
  number = offset + numbers[which];
}
