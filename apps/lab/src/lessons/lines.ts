// Lines and planes without an end. The library has segments, rays and half-spaces: a line is asked as two rays, its
// nearest point by the plane across it, and a plane as the half-space whose outside one stands on. It has no question
// for whether two lines or planes are parallel: that is decided here.

import { answered } from "../graze.ts";
import { add, cross, length, quatBetween, rotate, scale, unit } from "../parts/vec.ts";
import { convex, plane, type Body, type Question, type Vec } from "../question.ts";

/** The sine of the angle below which directions are called parallel, a tolerance of the lab's own: most digits of
 *  their product are then rounding. */
const parallel = 1e-9;
/** The product of two directions, made a unit; null where they are parallel. */
export function across(u: Vec, v: Vec): Vec | null {
  const n = cross(unit(u), unit(v));
  return length(n) > parallel ? unit(n) : null;
}

export const planeAcross = (p: Vec, n: Vec): Body => ({ shape: plane(), translation: p, rotation: quatBetween([0, 1, 0], n) });
export const normalOf = (body: Body): Vec => rotate(body.rotation, [0, 1, 0]);
export const asksBefore = (body: Body, x: Vec): Question => ({ query: "closest", a: body, point: x });
/** The signed distance of a point before a plane. */
export const before = (body: Body, x: Vec): number => answered(asksBefore(body, x)).distance!;
/** The distance of two points. */
export const between = (p: Vec, q: Vec): number => answered({ query: "closest", a: { shape: convex([p]) }, point: q }).distance!;

/** The point of the line through p along u that is nearest to x, and its place on the line, from p in units of
 *  length. */
export function foot(p: Vec, u: Vec, x: Vec): { t: number; point: Vec } {
  const t = before(planeAcross(p, u), x);
  return { t, point: add(p, scale(unit(u), t)) };
}

export interface Meeting { t: number; point: Vec; question: Question }
/** The first of two rays, along u and against it, that meets a body; null where neither does. */
export function alongLine(body: Body, p: Vec, u: Vec): Meeting | null {
  for (const sign of [1, -1]) {
    const question: Question = { query: "raycast", a: body, ray: { origin: p, direction: scale(u, sign) } }, answer = answered(question);
    if (answer.hit) return { t: sign * answer.t!, point: answer.point!, question };
  }
  return null;
}
/** The point in which the line through p along u meets a plane; null where it is parallel to it. */
export const meeting = (face: Body, p: Vec, u: Vec): Meeting | null =>
  alongLine(before(face, p) < 0 ? planeAcross(face.translation ?? [0, 0, 0], scale(normalOf(face), -1)) : face, p, u);
