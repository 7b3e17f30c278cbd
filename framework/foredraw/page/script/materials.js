// How triangles and counts become colours. All colours are as they show: nothing is converted on the way.

import {
  AddEquation,
  BackSide,
  CustomBlending,
  DoubleSide,
  FrontSide,
  GLSL3,
  LessDepth,
  NoBlending,
  OneFactor,
  RawShaderMaterial,
  Vector2,
  Vector3,
} from 'three';
import { heat, heat_background } from './colours.js';

const vertex_shader = `
uniform mat4 projectionMatrix;
uniform mat4 viewMatrix;
in vec3 position;
#ifdef TINTED
in vec4 tint;
out vec3 base;
#endif
#ifdef AWAY
in float away;
out float far_off;
#endif
out vec3 seen;
void main() {
  vec4 at = viewMatrix * vec4(position, 1.0);
  seen = at.xyz;
#ifdef TINTED
  base = tint.rgb;
#endif
#ifdef AWAY
  far_off = away;
#endif
  gl_Position = projectionMatrix * at;
}`;

// Lit from the upper left by a large soft light, from below by a cool one.
const light = `
vec3 lit(vec3 normal, vec3 towards) {
  float key = max(0.0, dot(normal, normalize(vec3(-0.45, 0.7, 0.65))));
  float fill = 0.5 + 0.5 * normal.y;
  float rim = pow(1.0 - max(0.0, dot(normal, towards)), 3.0);
  vec3 light = mix(vec3(0.42, 0.43, 0.48), vec3(0.62, 0.62, 0.63), fill) + key * vec3(0.50, 0.47, 0.42);
  return vec3(0.83, 0.79, 0.75) * light + rim * vec3(0.10, 0.11, 0.14);
}
`;

/** Facets as they are. `seen`: where they are before the camera. */
export const facet_light = `
uniform mat4 projectionMatrix;
in vec3 seen;
vec3 towards_eye() {
  return projectionMatrix[3][3] == 1.0 ? vec3(0.0, 0.0, 1.0) : normalize(-seen);
}
vec3 facet_normal() {
  vec3 normal = normalize(cross(dFdx(seen), dFdy(seen)));
  return dot(normal, towards_eye()) < 0.0 ? -normal : normal;
}
${light}`;

const solid_shader = `
precision highp float;
${facet_light}
#ifdef TINTED
in vec3 base;
#endif
#ifdef AWAY
in float far_off;
uniform float first_distance;
uniform vec3 palette[${heat.length}];
#endif
out vec4 colour;
void main() {
#ifdef AWAY
  float doublings = far_off <= first_distance ? 0.0 : ceil(log2(far_off / first_distance));
  vec3 base = palette[int(min(doublings, ${heat.length - 1}.0))];
#endif
  vec3 normal = facet_normal();
#if defined(TINTED) || defined(AWAY)
  float key = max(0.0, dot(normal, normalize(vec3(-0.45, 0.7, 0.65))));
  float rim = pow(1.0 - max(0.0, dot(normal, towards_eye())), 3.0);
  colour = vec4(base * (0.72 + 0.36 * key) + 0.06 * rim, 1.0);
#else
  colour = vec4(lit(normal, towards_eye()), 1.0);
#endif
}`;

const counting_shader = `
precision highp float;
out vec4 colour;
void main() { colour = vec4(1.0 / 255.0); }`;

const full_screen_shader = `
in vec3 position;
void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }`;

const heat_shader = `
precision highp float;
uniform highp sampler2D counts;
uniform vec2 corner;
uniform vec3 background;
uniform vec3 palette[${heat.length}];
out vec4 colour;
void main() {
  int count = int(texelFetch(counts, ivec2(gl_FragCoord.xy - corner), 0).r * 255.0 + 0.5);
  colour = vec4(count == 0 ? background : palette[min(count, ${heat.length}) - 1], 1.0);
}`;

const as_vector = (rgb) => new Vector3(...rgb).divideScalar(255);

function material(properties) {
  return new RawShaderMaterial({ glslVersion: GLSL3, blending: NoBlending, ...properties });
}

/** Of triangles at the same depth the first one is seen. Back faces are culled as the part's material says. */
export function surface(properties) {
  const by_side = new Map(
    [FrontSide, BackSide, DoubleSide].map((side) => [
      side,
      material({ vertexShader: vertex_shader, depthFunc: LessDepth, side, ...properties }),
    ]),
  );
  return (part, pose) =>
    by_side.get(part['double-sided'] ? DoubleSide : part.mirrored?.[pose] ? BackSide : FrontSide);
}

/** Those of parts are asked for by part and pose. */
export function make_materials() {
  const palette = heat.map(as_vector);
  // Fragments that pass in the sequence of drawing add one each.
  const counting = surface({
    fragmentShader: counting_shader,
    blending: CustomBlending,
    blendEquation: AddEquation,
    blendSrc: OneFactor,
    blendDst: OneFactor,
  });
  const heat_map = material({
    vertexShader: full_screen_shader,
    fragmentShader: heat_shader,
    depthTest: false,
    depthWrite: false,
    uniforms: {
      counts: { value: null },
      corner: { value: new Vector2() },
      background: { value: as_vector(heat_background) },
      palette: { value: palette },
    },
  });
  const first_distance = { value: 1 };
  const by_distance = {
    fragmentShader: solid_shader,
    defines: { AWAY: 1 },
    uniforms: { first_distance, palette: { value: palette } },
  };
  return {
    solid: surface({ fragmentShader: solid_shader }),
    tinted: surface({ fragmentShader: solid_shader, defines: { TINTED: 1 } }),
    deviation: surface(by_distance),
    behind_deviation: surface({ ...by_distance, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }),
    first_distance,
    counting,
    heat_map,
  };
}
