#version 450
// Writes who was here. As light as shading gets.

layout(early_fragment_tests) in;

layout(push_constant) uniform Draw {
  mat4 clip_from_position;
  uint owner;
};

layout(location = 0) out uint written;

void main() { written = owner; }
