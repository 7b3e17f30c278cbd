#version 450

layout(constant_id = 0) const uint factor = 1;

layout(location = 0) flat in uint number;

layout(location = 0) out uint written;

void main() { written = factor * number; }
