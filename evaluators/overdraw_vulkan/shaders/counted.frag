#version 450
// Writes who was here, and counts. Early tests are what makes the count right: a fragment that fails does not run.

layout(early_fragment_tests) in;

layout(push_constant) uniform Draw {
  mat4 clip_from_position;
  uint owner;
  uint counter;
};

layout(set = 0, binding = 0) buffer Counters { uint passed[]; };

layout(location = 0) out uint written;

void main() {
  atomicAdd(passed[counter], 1);
  written = owner;
}
