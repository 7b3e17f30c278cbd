#version 450

layout(push_constant) uniform Levels {
  float outer[3];
  float inner;
};

layout(vertices = 3) out;

void main() {
  gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;
  for (int e = 0; e < 3; ++e) gl_TessLevelOuter[e] = outer[e];
  gl_TessLevelInner[0] = inner;
}
