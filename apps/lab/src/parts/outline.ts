// Outlines of the plane's shapes, to draw them.

import { measures, pointsOf, radiusOf, sizeOf, type Body, type Shape, type Vec } from "../question.ts";
import { add, cross, scale, sub, toWorld, unit } from "./vec.ts";

function arc(center: Vec, radius: number, from: number, to: number): Vec[] {
  const count = 48;
  return Array.from({ length: count + 1 }, (_, i) => {
    const angle = from + ((to - from) * i) / count;
    return add(center, [radius * Math.cos(angle), radius * Math.sin(angle)]);
  });
}

/** Corners of the convex hull, counter-clockwise (Andrew 1979): what to draw of `points`. */
export function hull2(points: Vec[]): Vec[] {
  const sorted = [...points].sort((p, q) => p[0] - q[0] || p[1] - q[1]);
  if (sorted.length < 3) return sorted;
  const half = (list: Vec[]): Vec[] => {
    const chain: Vec[] = [];
    for (const p of list) {
      while (chain.length > 1) {
        const [o, q] = chain.slice(-2);
        if (cross([...sub(q, o), 0], [...sub(p, o), 0])[2] > 0) break;
        chain.pop();
      }
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(sorted), ...half(sorted.reverse())];
}

function local(shape: Shape, far: number): { points: Vec[]; closed: boolean } {
  switch (shape.type) {
    case "circle":
      return { points: arc([0, 0], radiusOf(shape), 0, 2 * Math.PI), closed: true };
    case "box": {
      const [x, y] = scale(sizeOf(shape), 0.5);
      return { points: [[-x, -y], [x, -y], [x, y], [-x, y]], closed: true };
    }
    case "ellipse": {
      const [x, y] = measures<{ radii: Vec }>(shape).radii;
      return { points: arc([0, 0], 1, 0, 2 * Math.PI).map((p) => [p[0] * x, p[1] * y]), closed: true };
    }
    case "capsule": {
      const m = measures<{ height: number; radiusBottom: number; radiusTop: number }>(shape);
      const lean = Math.asin(Math.max(-1, Math.min(1, (m.radiusBottom - m.radiusTop) / m.height)));
      return {
        points: [
          ...arc([0, m.height / 2], m.radiusTop, lean, Math.PI - lean),
          ...arc([0, -m.height / 2], m.radiusBottom, Math.PI - lean, 2 * Math.PI + lean),
        ],
        closed: true,
      };
    }
    case "plane":
      return { points: [[far, 0], [-far, 0], [-far, -far], [far, -far]], closed: true };
    case "convex":
      return { points: hull2(pointsOf(shape)), closed: true };
    case "polygon":
      return { points: pointsOf(shape), closed: true };
    default:
      return { points: pointsOf(shape) ?? [], closed: false };
  }
}

/** A convex outline with a margin: every corner becomes an arc. */
function rounded(points: Vec[], margin: number): Vec[] {
  const made: Vec[] = [];
  points.forEach((p, i) => {
    const before = unit(sub(p, points[(i + points.length - 1) % points.length]));
    const after = unit(sub(points[(i + 1) % points.length], p));
    const from = Math.atan2(-before[0], before[1]);
    let to = Math.atan2(-after[0], after[1]);
    while (to < from) to += 2 * Math.PI;
    made.push(...arc(p, margin, from, to));
  });
  return made;
}

export function outline(body: Body, far: number): { points: Vec[]; closed: boolean } {
  const { points, closed } = local(body.shape, far);
  const grown = body.shape.margin && body.shape.type !== "circle" ? rounded(points, body.shape.margin) : points;
  return { points: grown.map((p) => toWorld(body, p)), closed };
}
