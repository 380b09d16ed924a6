// Rays and bodies on their way, and their hits.

import { ask } from "../graze.ts";
import { drawDistance, onto } from "../parts/answers.ts";
import { digits } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, scale, sub } from "../parts/vec.ts";
import { circle, sphere, type Body, type Question, type Vec } from "../question.ts";
import { reached, type Hit, type Run } from "./run.ts";

export interface Shot {
  /** "measure" is the way between two places. */
  kind: "ray" | "cast" | "measure";
  /** The distance that was measured. */
  distance?: number;
  from: Vec;
  to: Vec;
  hit: Hit | null;
  /** The body of a cast, and its motion. */
  body?: number;
  motion?: Vec;
  /** The question about the body that is hit, alone; none where none is. */
  question: Question | null;
}

const dimensionOf = (run: Run): Partial<Question> => (run.flat ? { dimension: 2 } : {});
const cut = (run: Run, v: Vec): Vec => v.slice(0, run.flat ? 2 : 3);

export function shootRay(run: Run, ray: { origin: Vec; direction: Vec }): Shot {
  const hit = run.raycast(ray);
  const question: Question | null = hit && { query: "raycast", ...dimensionOf(run), a: run.asked(hit.body),
    ray: { origin: cut(run, ray.origin), direction: cut(run, ray.direction) } };
  return { kind: "ray", from: ray.origin, to: hit?.point ?? add(ray.origin, ray.direction), hit, question };
}
/** The cast of a body to twice the distance of a place. */
export function castBody(run: Run, body: number, target: Vec): Shot {
  const place = run.place(body), motion = scale(sub(target, place.translation), 2);
  const hit = run.cast(body, motion), end = reached(place, motion, hit?.t ?? 1);
  const question: Question | null = hit && { query: "cast", ...dimensionOf(run), duration: 1,
    a: { ...run.asked(body), linear: cut(run, motion) }, b: run.asked(hit.body) };
  return { kind: "cast", from: place.translation, to: end.translation, hit, body, motion, question };
}
/** The distance of two places, as a question about two points. */
export function measure(run: Run, from: Vec, to: Vec): Shot {
  const at = (place: Vec): Body => ({ shape: run.flat ? circle(0) : sphere(0), translation: cut(run, place) });
  const question: Question = { query: "distance", ...dimensionOf(run), a: at(from), b: at(to) };
  return { kind: "measure", from, to, hit: null, question, distance: ask(question).distance };
}
/** Draws the way, the point and normal of the hit, and a body on its way; `size` is that of the picture. */
export function drawShot(d: Drawing, run: Run, shot: Shot, size: number): void {
  const { from, to, hit, body, motion } = shot, on = onto(d, { look: { wide: true }, size: size * 1.5 });
  if (shot.distance !== undefined) {
    drawDistance(d, { a: from, b: to }, { look: { wide: true }, as: { gap: "made", a: "made", b: "made" } });
    d.text(scale(add(from, to), 0.5), digits(shot.distance, 5), "made");
  } else if (body !== undefined) run.drawCast(body, { translation: from, rotation: run.place(body).rotation }, motion!, hit, on);
  else run.drawRay({ origin: from, direction: sub(to, from) }, hit, on);
}
