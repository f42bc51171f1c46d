// How surfaces and lines are drawn: two lights fixed to the camera, colours as given. Shaders of a few
// lines, because a browser without a graphics card takes seconds to compile three's own.

import { Color, ColorManagement, DoubleSide, GLSL3, RawShaderMaterial } from 'three';

ColorManagement.enabled = false;  // colours are those of the screen

const kVertex = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
uniform mat3 normalMatrix;
in vec3 position, normal, color;
out vec3 place, side, paint;
void main() {
  vec4 p = modelViewMatrix * vec4(position, 1.0);
  place = p.xyz;
  side = normalMatrix * normal;
  paint = color;
  gl_Position = projectionMatrix * p;
}`;

// `flat_sides`: the normal is that of the triangle.
const kFragment = `
precision highp float;
uniform vec3 tint;
uniform float flat_sides;
in vec3 place, side, paint;
out vec4 colour;
void main() {
  vec3 n = normalize(flat_sides > 0.5 ? cross(dFdx(place), dFdy(place)) : side);
  if (dot(n, place) > 0.0) n = -n;
  float light = 0.52 + 0.46 * max(dot(n, vec3(-0.36, 0.57, 0.74)), 0.0) + 0.14 * max(dot(n, vec3(0.78, -0.45, 0.43)), 0.0);
  colour = vec4(tint * paint * light, 1.0);
}`;

const kLine = `
precision mediump float;
uniform vec3 tint;
uniform float alpha;
out vec4 colour;
void main() { colour = vec4(tint, alpha); }`;

const kLineVertex = `
precision highp float;
uniform mat4 modelViewMatrix, projectionMatrix;
in vec3 position;
void main() { gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }`;

/** A surface, coloured by the attribute `color` where it has one, times a tint. */
export function surface(tint = 0xffffff, flat = false) {
  return new RawShaderMaterial({
    glslVersion: GLSL3, vertexShader: kVertex, fragmentShader: kFragment, side: DoubleSide,
    uniforms: { tint: { value: new Color(tint) }, flat_sides: { value: flat ? 1 : 0 } },
  });
}

export function lines(tint, alpha) {
  return new RawShaderMaterial({
    glslVersion: GLSL3, vertexShader: kLineVertex, fragmentShader: kLine, transparent: true,
    uniforms: { tint: { value: new Color(tint) }, alpha: { value: alpha } },
  });
}
