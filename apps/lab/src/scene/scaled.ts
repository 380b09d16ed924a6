// Shapes that are scaled along their axes.

import { graze, shapeOf } from "../graze.ts";
import type { Shape, Vec } from "../question.ts";

/** A shape under its node's scale: such a shape again, an ellipsoid, or the hull of its picture. */
export function scaled(shape: Shape, scale: Vec): Shape {
  const [x, y, z] = scale.map(Math.abs), near = (p: number, q: number): boolean => Math.abs(p - q) <= 1e-6 * Math.max(p, q);
  if ([x, y, z].every((s) => near(s, 1))) return shape;
  if (shape.type === "convex" || shape.type === "mesh") {
    const { points, ...rest } = shape[shape.type] as { points: Vec[] };
    return { ...shape, [shape.type]: { ...rest, points: points.map((p) => p.map((c, k) => c * scale[k])) } };
  }
  const m = shape[shape.type] as { radius: number; size: Vec; height: number; radiusBottom: number; radiusTop: number };
  const round = { height: m.height * y, radiusBottom: m.radiusBottom * x, radiusTop: m.radiusTop * x };
  if (shape.type === "box") return { type: "box", box: { size: [m.size[0] * x, m.size[1] * y, m.size[2] * z] } };
  if (shape.type === "sphere") return near(x, y) && near(y, z) ? { type: "sphere", sphere: { radius: m.radius * x } } : { type: "ellipsoid", ellipsoid: { radii: [m.radius * x, m.radius * y, m.radius * z] } };
  if (shape.type === "cylinder" && near(x, z)) return { type: "cylinder", cylinder: round };
  if (shape.type === "capsule" && near(x, y) && near(y, z)) return { type: "capsule", capsule: round };
  const points: Vec[] = [], made = shapeOf(shape);
  graze.draw.shape(made, {}, { triangle: (a, b, c) => points.push(...[a, b, c].map((p) => [p[0] * x, p[1] * y, p[2] * z])) });
  made.dispose();
  return { type: "convex", convex: { points } };
}
