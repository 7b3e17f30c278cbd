#version 450

layout(triangles, fractional_even_spacing, cw) in;

layout(xfb_buffer = 0, xfb_stride = 24) out;
layout(location = 0, xfb_offset = 0) out vec3 weights;
layout(location = 1, xfb_offset = 12) out vec3 position;

void main() {
  weights = gl_TessCoord;
  precise vec3 between = gl_TessCoord.x * gl_in[0].gl_Position.xyz + gl_TessCoord.y * gl_in[1].gl_Position.xyz +
                         gl_TessCoord.z * gl_in[2].gl_Position.xyz;
  position = between;
  gl_Position = vec4(between, 1);
}
