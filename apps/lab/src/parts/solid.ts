// Faces and edges of shapes, as the library draws them.

import * as THREE from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { graze, shapeOf } from "../graze.ts";
import type { Shape } from "../question.ts";

export interface Solid {
  faces: THREE.BufferGeometry;
  edges: THREE.BufferGeometry;
}

/** Faces that meet at less than this angle, in radians, are the sampling of something smooth. */
const crease = 0.5;
/** How far a half-space is drawn. */
const reach = 4;

const geometry = (corners: number[]): THREE.BufferGeometry =>
  new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));

export function solidOfShape(shape: graze.Shape): Solid {
  const faces: number[] = [], edges: number[] = [];
  graze.draw.shape(shape, {}, {
    size: reach,
    triangle: (a, b, c) => faces.push(...a, ...b, ...c),
    line: (from, to) => edges.push(...from, ...to),
  });
  return { faces: toCreasedNormals(geometry(faces), crease), edges: geometry(edges) };
}
/** Of a shape of the protocol. */
export function solidOf(shape: Shape): Solid {
  const made = shapeOf(shape);
  const solid = solidOfShape(made);
  made.dispose();
  return solid;
}
