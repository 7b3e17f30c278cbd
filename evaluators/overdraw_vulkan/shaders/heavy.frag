#version 450
// A chain of 256 steps, each of which waits for the one before it: about what a long material costs.

layout(early_fragment_tests) in;

layout(location = 0) out uint written;

void main() {
  float x = gl_FragCoord.x + 0.37 * gl_FragCoord.y;
  for (int i = 0; i < 256; ++i) x = sin(x) * 1.7 + 0.3;
  written = floatBitsToUint(x);  // nobody reads it, but the compiler can not know
}
