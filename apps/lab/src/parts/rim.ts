// The outlines of bodies, whose own colours say something else: their back faces, moved outwards by some pixels, so
// that what is seen of them surrounds a body.

import * as THREE from "three";

/** The width of an outline in pixels, of which in the plane one half lies inside. */
const width = 2.5;
/** The part of the way to the eye by which an outline comes nearer: what the body stands on does not hide it then. */
const nearer = 0.01;

const vertexShader = `
  uniform vec2 pixel;
  void main() {
    vec4 seen = modelViewMatrix * instanceMatrix * vec4(position, 1.0);
    seen.xyz *= ${(1 - nearer).toFixed(4)};
    gl_Position = projectionMatrix * seen;
    vec2 outwards = (mat3(modelViewMatrix) * mat3(instanceMatrix) * normal).xy;
    gl_Position.xy += outwards / max(length(outwards), 1e-6) * pixel * gl_Position.w;
  }`;
const fragmentShader = `
  uniform vec3 shade;
  void main() {
    gl_FragColor = vec4(shade, 1.0);
    #include <colorspace_fragment>
  }`;

/** The material of outlines, which needs instances; `flat` for those of the plane, which have no back. */
export function rimMaterial(flat: boolean): THREE.ShaderMaterial {
  const pixel = new THREE.Vector2(), out = flat ? width / 2 : width;
  const material = new THREE.ShaderMaterial({
    uniforms: { pixel: { value: pixel }, shade: { value: new THREE.Color() } }, vertexShader, fragmentShader,
    side: flat ? THREE.DoubleSide : THREE.BackSide });
  material.onBeforeRender = (renderer) => void renderer.getSize(pixel).set((2 * out) / pixel.x, (2 * out) / pixel.y);
  return material;
}
