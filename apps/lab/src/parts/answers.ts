// Answers of the library as the library draws them: its calls onto a stage, in the lab's colours, with the
// keys by which rows light up.

import { graze, planeShapeOf, poseOf, shapeOf, type End, type Trace } from "../graze.ts";
import type { Question, Vec } from "../question.ts";
import type { Drawing, Look, Meaning } from "./drawing.ts";
import { add, scale } from "./vec.ts";

/** The lab's names for the library's colours. Moving things have the colour of an algorithm's, as scenes have their
 *  own. */
const usual: Partial<Record<graze.DrawMeaning, Meaning>> = {
  a: "a", b: "b", contact: "touch", normal: "axis", gap: "touch", bounds: "ink", path: "made", ghost: "made", moving: "made",
  touching: "made", joint: "ink" };

/** Settings of a drawing of answers, beyond those of the library. */
export interface Marks {
  /** Twelve times as long as an arrow; how far a ray without an end is drawn. */
  size?: number;
  center?: Vec;
  /** The look of lines, and of points unless `points` gives those, in their order. */
  look?: Look;
  points?: (number: number) => Look;
  /** The colours of points of contact, in their order; null for those that are not drawn. */
  contact?: (number: number) => Meaning | null;
  /** The words beside a normal. */
  label?: string;
  /** Everything is drawn that far away, or where this says. */
  by?: Vec | ((at: Vec, meaning: graze.DrawMeaning) => Vec);
  /** Other colours than usual; null for what is not drawn. */
  as?: Partial<Record<graze.DrawMeaning, Meaning | null>>;
}

/** A renderer that draws on a stage. Faces are left out: these are marks upon bodies that are seen. */
export function onto(d: Drawing, { size = 12, center, look = {}, points, contact, label, by, as }: Marks = {}): graze.Renderer {
  const meanings = { ...usual, ...as };
  const drawn = (meaning: graze.DrawMeaning, draw: (meaning: Meaning) => void, own = meanings[meaning]): void => {
    if (own) draw(own);
  };
  const there = (at: Vec, meaning: graze.DrawMeaning): Vec =>
    typeof by === "function" ? by(at, meaning) : by ? at.map((x, i) => x + (by[i] ?? 0)) : at;
  let number = 0;
  return {
    size, center: center && [...center, 0].slice(0, 3),
    point(at, _, meaning) {
      const i = number++;
      drawn(meaning, (own) => d.point(there(at, meaning), own, points?.(i) ?? look), meaning === "contact" && contact ? contact(i) : meanings[meaning]);
    },
    line: (from, to, _, meaning) => drawn(meaning, (own) => d.line(there(from, meaning), there(to, meaning), own, meaning === "ghost" ? { ...look, wide: false, ghost: true } : look)),
    arrow: (from, direction, _, meaning) => drawn(meaning, (own) => d.arrow(there(from, meaning), add(there(from, meaning), scale(direction, size / 12)), own, meaning === "normal" ? { ...look, label } : look)),
    text: (at, words, _, meaning) => drawn(meaning, (own) => d.text(there(at, meaning), words, own)),
  };
}

/** Points of contact with their normal. */
export interface DrawnManifold {
  normal: Vec;
  points: readonly graze.DrawnContact[];
}
const drawsOf = (flat: boolean): Pick<typeof graze.draw, "contacts" | "distance" | "ray" | "cast"> =>
  (flat ? graze.plane.draw : graze.draw) as typeof graze.draw;

/** Draws the points of a manifold, and its normal from their middle; in the plane where vectors have two numbers. */
export const drawManifold = (d: Drawing, manifold: DrawnManifold, marks?: Marks): void =>
  drawsOf(manifold.normal.length === 2).contacts(manifold, onto(d, marks));
/** Draws the shortest way between two shapes, or out of each other, and its ends. */
export const drawDistance = (d: Drawing, { a, b }: { a?: unknown; b?: unknown }, marks?: Marks): void =>
  drawsOf((a as Vec).length === 2).distance({ a, b } as { a: graze.Vec3; b: graze.Vec3 }, onto(d, marks));
export const drawRay = (d: Drawing, ray: graze.Ray, hit: Pick<graze.RayHit, "t" | "point" | "normal"> | null, marks?: Marks): void =>
  drawsOf(ray.origin.length === 2).ray(ray, hit, onto(d, marks));
/** A question's body on its way for so long: its path, places along it, and where it comes to. */
export function drawCast(d: Drawing, { a, dimension }: Question, duration: number, marks?: Marks): void {
  const flat = dimension === 2, shape = (flat ? planeShapeOf(a.shape) : shapeOf(a.shape)) as graze.Shape;
  const pose = flat ? { translation: a.translation, rotation: a.rotation } : poseOf(a);
  try {
    drawsOf(flat).cast({ shape, ...pose, linear: a.linear, angular: a.angular } as graze.Moving, null, onto(d, marks), { duration });
  } finally {
    shape.dispose();
  }
}
/** The edges of a box along the axes. */
export const drawBounds = (d: Drawing, box: { lower: Vec; upper: Vec }, meaning: Meaning, look?: Look): void =>
  graze.draw.bounds(box as graze.Aabb, onto(d, { look, as: { bounds: meaning } }));

/** Where an interval ends. */
export const endOf = (end: End): number => (typeof end === "number" ? end : end === "infinity" ? Infinity : -Infinity);
/** Draws what a query did as far as `trace` holds it, or one step of it (axes, iterations of GJK, expansions of EPA,
 *  cuts, counted in this order): axes through the centre, the Minkowski difference about the origin, faces where they
 *  are. */
export function drawTrace(d: Drawing, { winner, axes = [], gjk, epa, difference, polytope, faces, cuts }: Partial<Trace>, marks?: Marks, step?: number): void {
  const whole = axes.map(({ name, direction, a, b }) => ({ name, direction, a: a.map(endOf), b: b.map(endOf) }));
  graze.draw.trace({ winner, axes: whole, gjk, epa: epa as graze.DrawnTrace["epa"], difference, polytope: polytope?.points, triangles: polytope?.triangles,
    faceA: faces?.a, faceB: faces?.b, cuts }, onto(d, marks), { step });
}
