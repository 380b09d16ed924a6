// Outlines of the plane's shapes, as the library draws them.

import { graze, planeShapeOf } from "../graze.ts";
import type { Body, Shape, Vec } from "../question.ts";

export interface Outline {
  readonly points: Vec[];
  closed: boolean;
}

/** The number of shapes that are known at most: one whose size is dragged is another at every moment. */
const mostShapes = 32;
const known = new Map<string, graze.plane.Shape>();
/** A shape of the library's, which a drag of bodies asks for several times a frame. */
function shapeOf(of: Shape): graze.plane.Shape {
  const key = JSON.stringify(of);
  let shape = known.get(key);
  if (!shape) {
    if (known.size >= mostShapes) {
      for (const old of known.values()) old.dispose();
      known.clear();
    }
    known.set(key, (shape = planeShapeOf(of)));
  }
  return shape;
}

/** The number of outlines that are remembered: those of a picture, which several of its parts ask for, and of bodies
 *  that a drag leaves where they are. */
const mostOutlines = 64;
const remembered = new Map<string, Outline[]>();
/** Whether a shape has no end, or a piece of it. */
const isEndless = (shape: Shape): boolean => JSON.stringify(shape).includes('"plane"');
/** The outlines of a body in the world, one for each of its pieces; a half-plane as far as `far`. */
export function outlines(body: Body, far: number): readonly Outline[] {
  const { shape, translation = [0, 0], rotation = 0 } = body;
  const key = JSON.stringify([shape, translation, rotation, isEndless(shape) && far]);
  let made = remembered.get(key);
  if (!made) {
    if (remembered.size >= mostOutlines) remembered.clear();
    remembered.set(key, (made = drawn(shape, { translation, rotation: Number(rotation) }, far)));
  }
  return made;
}
function drawn(shape: Shape, at: { translation: Vec; rotation: number }, far: number): Outline[] {
  const made: Outline[] = [];
  const same = (p: Vec, q: Vec): boolean => p[0] === q[0] && p[1] === q[1];
  const { points, loops } = graze.plane.tessellate(shapeOf(shape), at, { center: at.translation, size: far });
  for (const loop of loops) {
    const piece = loop.map((i) => points[i].slice(0, 2)), last = made.at(-1);
    if (piece.length > 2) made.push({ points: piece, closed: true });
    else if (piece.length < 2) continue;
    // The edges of a chain come one by one.
    else if (!last || last.closed || !same(last.points.at(-1)!, piece[0])) made.push({ points: piece, closed: false });
    else if (same(last.points[0], piece[1])) last.closed = true;
    else last.points.push(piece[1]);
  }
  return made;
}

/** The corners of all outlines. */
export const corners = (body: Body, far: number): Vec[] => outlines(body, far).flatMap((outline) => outline.points);
