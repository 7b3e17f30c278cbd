#version 450

layout(location = 0) in vec3 surface;
layout(location = 1) in vec3 weights;
layout(location = 2) flat in uvec4 corners;

layout(set = 0, binding = 6) buffer Counts {
  uint counts[];  // [row][column][sample] of front faces and of back faces
};

void main() {
  uvec2 pixel = uvec2(gl_FragCoord.xy);
  uint first = 8u * (192u * pixel.y + pixel.x) + (gl_FrontFacing ? 0u : 1u);
  for (uint s = 0u; s < 4u; ++s) {
    if ((gl_SampleMaskIn[0] >> s & 1) != 0) atomicAdd(counts[first + 2u * s], 1u);
  }
}
