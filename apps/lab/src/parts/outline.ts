// Outlines of the plane's shapes, as the library draws them.

import { graze, planeShapeOf } from "../graze.ts";
import type { Body, Vec } from "../question.ts";

export interface Outline {
  points: Vec[];
  closed: boolean;
}

/** The outlines of a body in the world, one for each of its pieces; a half-plane as far as `far`. */
export function outlines(body: Body, far: number): Outline[] {
  const made: Outline[] = [];
  const same = (p: Vec, q: Vec): boolean => p[0] === q[0] && p[1] === q[1];
  const shape = planeShapeOf(body.shape);
  const at = { translation: body.translation ?? [0, 0], rotation: Number(body.rotation ?? 0) };
  graze.plane.draw.shape(shape, at, {
    center: [...at.translation.slice(0, 2), 0],
    size: far,
    line(from, to) {
      const last = made.at(-1);
      if (!last || last.closed || !same(last.points.at(-1)!, from)) made.push({ points: [from.slice(0, 2), to.slice(0, 2)], closed: false });
      else if (same(last.points[0], to)) last.closed = true;
      else last.points.push(to.slice(0, 2));
    },
  });
  shape.dispose();
  return made;
}

/** The corners of all outlines. */
export const corners = (body: Body, far: number): Vec[] => outlines(body, far).flatMap((outline) => outline.points);
