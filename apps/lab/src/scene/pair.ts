// What is shown of two bodies: the lesson that explains them, and what they touch with.

import type { Drawing, Meaning } from "../parts/drawing.ts";
import type { Question, State, Vec } from "../question.ts";

/** Shapes of the plane that GJK's lesson draws. */
const convexInPlane = ["circle", "box", "capsule", "convex", "ellipse", "segment"];

/** A lesson that goes through a pair step by step, by what it shows, and the state in which it begins. */
export interface PairLesson {
  lesson: string;
  shows: string;
  state: State;
}
/** The lessons for a pair; none for what none draws. `apart`: whether the two are. */
export function lessonsOf(q: Question, apart: boolean): PairLesson[] {
  const pair = { dimension: q.dimension, a: q.a, b: q.b }, flat = q.dimension === 2;
  const contacts: State = { q: { query: "contacts", margin: q.margin, ...pair } }, distance: State = { q: { query: "distance", ...pair } };
  const boxes = q.a.shape.type === "box" && q.b!.shape.type === "box";
  if (boxes && flat) return [{ lesson: "separating-axes-plane", shows: "its axes", state: contacts }];
  if (boxes) return [{ lesson: "fifteen-axes", shows: "its axes", state: contacts }, { lesson: "contact-set", shows: "its contacts", state: contacts }];
  if (flat && ![q.a, q.b!].every(({ shape }) => convexInPlane.includes(shape.type))) return [];
  const gjk = { lesson: flat ? "gjk" : "gjk-space", shows: "GJK", state: distance };
  return apart ? [gjk] : [gjk, { lesson: flat ? "epa" : "epa-space", shows: "EPA", state: distance }];
}

/** A vertex, an edge or a face, to be lit up with the point that it belongs to. */
export function drawFeature(d: Drawing, corners: Vec[], meaning: Meaning, key: string): void {
  if (corners.length === 1) d.point(corners[0], meaning, { key });
  const ends = corners.length > 2 ? corners.length : corners.length - 1;
  for (let i = 0; i < ends; i++) d.line(corners[i], corners[(i + 1) % corners.length], meaning, { key });
}
