// Wires drawn as the project's shaders for engines draw them: with the same functions, which the page carries.

import {
  AddEquation,
  CustomBlending,
  Matrix4,
  OneFactor,
  OneMinusSrcAlphaFactor,
  SrcAlphaFactor,
  Vector4,
  ZeroFactor,
} from 'three';
import { facet_light, surface } from './materials.js';

const vertex_shader = (functions) => `
#define precise
${functions}
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
uniform mat4 shown_from_mesh;
uniform mat4 clip_from_mesh;
uniform vec4 pane;
in vec3 position;
in vec4 wire_place;
in vec4 wire;
in vec4 wire_axis;
out vec3 seen;
out vec4 widths;
out vec3 centre;
out vec3 axis;
void main() {
  WireView view = wire_view(clip_from_mesh, pane.zw);
  WireVertex at = wire_vertex(view, wire_place.xyz, wire, wire_axis, WIRE_SAMPLES);
  seen = (viewMatrix * vec4(position, 1.0)).xyz;
  widths = vec4(at.radius, at.half_pixel, wire_axis.w, wire_place.w);
  centre = wire_place.xyz + wire.xyz;
  axis = wire_axis.xyz;
  // What is not widened stays where the other shaders draw it, to the bit.
  vec3 shown = position + mat3(shown_from_mesh) * (at.position - wire_place.xyz);
  gl_Position = projectionMatrix * (viewMatrix * vec4(shown, 1.0));
}`;

const fragment_shader = (functions) => `
precision highp float;
#define precise
${functions}
${facet_light}
uniform mat4 viewMatrix;
uniform mat4 shown_from_mesh;
uniform mat4 clip_from_mesh;
uniform vec4 pane;
uniform bool is_faded;
uniform float outwards;
in vec4 widths;
in vec3 centre;
in vec3 axis;
out vec4 colour;

// The mean light over the width of a round wire.
vec3 lit_all_over() {
  vec3 along = mat3(viewMatrix) * (mat3(shown_from_mesh) * axis), sum = vec3(0.0);
  for (int i = -1; i <= 1; ++i) {
    vec3 normal = wire_normal(along, towards_eye(), 0.7746 * float(i));
    sum += lit(normal, towards_eye()) * (i == 0 ? 8.0 : 5.0) / 18.0;
  }
  return sum;
}

void main() {
  WireView view = wire_view(clip_from_mesh, pane.zw);
  vec2 pixel = gl_FragCoord.xy - pane.xy;
  float alpha = widths.x > 0.0 ? wire_coverage(wire_section(view, centre, axis), widths.x, pixel) : 1.0;
  vec3 normal = facet_normal();  // before anything is discarded: neighbours are asked
  if ((alpha < 1.0) != is_faded) discard;
  bool is_far_side = widths.w * outwards * (gl_FrontFacing ? 1.0 : -1.0) < 0.0;
  if (is_faded && is_far_side) discard;
  float part = widths.x > 0.0 && widths.z < 0.5 ? wire_lit(widths.x, widths.y) : 1.0;
  vec3 light = lit(normal, towards_eye()) * part;
  if (part < 1.0) light += lit_all_over() * (1.0 - part);
  colour = vec4(light, alpha);
}`;

/**
 * What is opaque, and then what is blended without writing depth. Both are asked for by part and pose.
 * @param {string} functions  of wires, as the page carries them
 * @param {number} samples  of a pixel
 */
export function make_wire_materials(functions, samples) {
  const made = (is_faded, properties) =>
    surface({
      vertexShader: vertex_shader(functions),
      fragmentShader: fragment_shader(functions),
      defines: { WIRE_SAMPLES: samples },
      uniforms: {
        shown_from_mesh: { value: new Matrix4() },
        clip_from_mesh: { value: new Matrix4() },
        pane: { value: new Vector4() },
        is_faded: { value: is_faded },
        outwards: { value: 0 },
      },
      ...properties,
    });
  return {
    opaque: made(false, {}),
    faded: made(true, {
      depthWrite: false,
      blending: CustomBlending,
      blendEquation: AddEquation,
      blendSrc: SrcAlphaFactor,
      blendDst: OneMinusSrcAlphaFactor,
      blendSrcAlpha: ZeroFactor,
      blendDstAlpha: OneFactor,
    }),
  };
}
