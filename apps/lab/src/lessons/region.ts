// The region of a simplex of the plane that belongs to one of its features: all points to which that feature is nearer
// than the rest of the simplex. GJK keeps the feature in whose region the origin lies.

import { add, dot, scale, sub, unit } from "../parts/vec.ts";
import type { Vec } from "../question.ts";

/** The direction across a side, away from a point. */
function away([p, q]: Vec[], from: Vec): Vec {
  const [x, y] = unit(sub(q, p)), side = [-y, x];
  return dot(side, sub(from, p)) > 0 ? scale(side, -1) : side;
}
/** The region of a corner: between the two directions that are across the sides that meet there. */
function beyondCorner(p: Vec, others: Vec[], far: number): Vec[] {
  const ways = others.map((q) => unit(sub(q, p)));
  const rims = others.length === 1 ? [-1, 1].map((sign) => scale([-ways[0][1], ways[0][0]], sign))
    : others.map((q, i) => away([p, q], others[1 - i]));
  const middle = unit(scale(ways.reduce((sum, u) => add(sum, u)), -1));
  return [p, add(p, scale(rims[0], far)), add(p, scale(add(rims[0], middle), far)), add(p, scale(add(rims[1], middle), far)), add(p, scale(rims[1], far))];
}

/** The region of `feature`, a part of the corners of a point, an edge or a triangle, as a polygon that reaches
 *  `far`. */
export function region(corners: Vec[], feature: Vec[], far: number): Vec[] {
  const others = corners.filter((p) => !feature.includes(p)), [p, q] = feature;
  if (feature.length === 1) return others.length > 0 ? beyondCorner(p, others, far) : [];
  if (feature.length === 3) return feature;
  const out = scale(away([p, q], others[0] ?? add(p, [1, 1])), far), back = others.length > 0 ? [0, 0] : scale(out, -1);
  return [add(p, back), add(q, back), add(q, out), add(p, out)];
}
