// What is shown of two bodies: the lesson that explains them, and what they touch with.

import type { Drawing, Meaning } from "../parts/drawing.ts";
import type { Question, State, Vec } from "../question.ts";

/** Shapes of the plane that GJK's lesson draws. */
const convexInPlane = ["circle", "box", "capsule", "convex", "ellipse", "segment"];

/** The lesson that goes through a pair step by step, and the state in which it begins; none for what none draws. */
export function lessonOf(q: Question): { lesson: string | null; state: State } {
  const pair = { dimension: q.dimension, a: q.a, b: q.b };
  const boxes = q.a.shape.type === "box" && q.b!.shape.type === "box";
  if (!boxes && q.dimension === 2 && ![q.a, q.b!].every(({ shape }) => convexInPlane.includes(shape.type))) return { lesson: null, state: { q } };
  if (boxes) return { lesson: q.dimension === 2 ? "separating-axes-plane" : "fifteen-axes", state: { q: { query: "contacts", ...pair } } };
  return { lesson: q.dimension === 2 ? "gjk" : "gjk-space", state: { q: { query: "distance", ...pair } } };
}

/** A vertex, an edge or a face, to be lit up with the point that it belongs to. */
export function drawFeature(d: Drawing, corners: Vec[], meaning: Meaning, key: string): void {
  if (corners.length === 1) d.point(corners[0], meaning, { key });
  const ends = corners.length > 2 ? corners.length : corners.length - 1;
  for (let i = 0; i < ends; i++) d.line(corners[i], corners[(i + 1) % corners.length], meaning, { key });
}
