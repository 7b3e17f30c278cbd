#version 450

layout(location = 0) in vec3 weights;
layout(location = 1) flat in uint patch_number;

layout(location = 0) out uint written;

void main() { written = weights.x < 0 ? 0 : 7 + patch_number; }
