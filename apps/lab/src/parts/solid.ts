// Faces and edges of shapes, as the library draws them.

import * as THREE from "three";
import { toCreasedNormals } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { graze, planeShapeOf, shapeOf } from "../graze.ts";
import type { Shape, Vec } from "../question.ts";

export interface Solid {
  faces: THREE.BufferGeometry;
  edges: THREE.BufferGeometry;
  /** The geometry that, moved along its normals, shows as an outline: the faces of a solid, turned inside out; in the
   *  plane the edges, twice each. */
  rim: THREE.BufferGeometry;
}

/** The angle in radians below which faces that meet are the sampling of something smooth. */
const crease = 0.5;
/** The size up to which a half-space is drawn by default. */
const reach = 4;

const geometry = (corners: number[]): THREE.BufferGeometry =>
  new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));

/** A line of the plane as two triangles of a width. */
function ribbon([fromX, fromY]: Vec, [toX, toY]: Vec, width: number): number[] {
  const x = toX - fromX, y = toY - fromY, l = Math.hypot(x, y) || 1;
  const side = [(-y / l) * (width / 2), (x / l) * (width / 2)];
  const corner = (cx: number, cy: number, s: number): number[] => [cx + s * side[0], cy + s * side[1], 0];
  const [a, b, c, d] = [corner(fromX, fromY, -1), corner(toX, toY, -1), corner(toX, toY, 1), corner(fromX, fromY, 1)];
  return [...a, ...b, ...c, ...a, ...c, ...d];
}

/** Edges of the plane as quads without a width, whose corners have the normals of the two sides of their edge. */
function rims(edges: THREE.BufferGeometry): THREE.BufferGeometry {
  const ends = Array.from(edges.getAttribute("position").array), corners: number[] = [], normals: number[] = [];
  for (let i = 0; i < ends.length; i += 6) {
    const from = ends.slice(i, i + 3), to = ends.slice(i + 3, i + 6);
    const middle = ribbon(from, to, 0);
    corners.push(...middle);
    normals.push(...ribbon(from, to, 2).map((x, k) => x - middle[k]));
  }
  return geometry(corners).setAttribute("normal", new THREE.Float32BufferAttribute(normals, 3));
}

/** The faces and edges that `draw` draws, half-spaces as far as `size`. */
export function solidDrawn(draw: (on: graze.Renderer) => void, size = reach): Solid {
  const faces: number[] = [], edges: number[] = [];
  draw({
    size,
    triangle: (a, b, c) => faces.push(...a, ...b, ...c),
    line: (from, to) => edges.push(...from, ...to),
  });
  const made = toCreasedNormals(geometry(faces), crease);
  return { faces: made, edges: geometry(edges), rim: made };
}
/** The faces and edges of a drawing of the plane. Lines without an area are as wide as a hundredth of `size`. */
export function flatSolidDrawn(draw: (on: graze.Renderer) => void, size: number): Solid {
  const drawn = solidDrawn(draw, size), solid = { ...drawn, rim: rims(drawn.edges) };
  if (solid.faces.getAttribute("position").count > 0) return solid;
  const ends = Array.from(solid.edges.getAttribute("position").array), faces: number[] = [];
  for (let i = 0; i < ends.length; i += 6) faces.push(...ribbon(ends.slice(i, i + 3), ends.slice(i + 3, i + 6), size / 100));
  return { ...solid, faces: toCreasedNormals(geometry(faces), crease) };
}
/** The faces and edges of a shape of the protocol, of space or of the plane. */
export function solidOf(shape: Shape, flat = false, size = reach): Solid {
  const made = flat ? planeShapeOf(shape) : shapeOf(shape);
  try {
    if (flat) return flatSolidDrawn((on) => graze.plane.draw.shape(made as graze.plane.Shape, {}, on), size);
    return solidDrawn((on) => graze.draw.shape(made as graze.Shape, {}, on), size);
  } finally {
    made.dispose();
  }
}
