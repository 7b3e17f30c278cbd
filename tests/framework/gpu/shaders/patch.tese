#version 450

layout(triangles, equal_spacing, ccw) in;

layout(xfb_buffer = 0, xfb_stride = 16) out;
layout(location = 0, xfb_offset = 0) out vec3 weights;
layout(location = 1, xfb_offset = 12) out uint patch_number;

void main() {
  weights = gl_TessCoord;
  patch_number = gl_PrimitiveID;
  gl_Position = weights.x * gl_in[0].gl_Position + weights.y * gl_in[1].gl_Position + weights.z * gl_in[2].gl_Position;
}
