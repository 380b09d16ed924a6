// Rays and bodies on their way, and what they meet.

import { onto } from "../parts/answers.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, scale, sub } from "../parts/vec.ts";
import type { Question, Vec } from "../question.ts";
import { reached, type Hit, type Run } from "./run.ts";

export interface Shot {
  kind: "ray" | "cast";
  from: Vec;
  to: Vec;
  hit: Hit | null;
  /** Of a cast, the body and how far it was thrown. */
  body?: number;
  motion?: Vec;
  /** The same of what is hit alone; none where nothing is. */
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
/** A body thrown twice as far as a place. */
export function castBody(run: Run, body: number, target: Vec): Shot {
  const place = run.place(body), motion = scale(sub(target, place.translation), 2);
  const hit = run.cast(body, motion), end = reached(place, motion, hit?.t ?? 1);
  const question: Question | null = hit && { query: "cast", ...dimensionOf(run), duration: 1,
    a: { ...run.asked(body), linear: cut(run, motion) }, b: run.asked(hit.body) };
  return { kind: "cast", from: place.translation, to: end.translation, hit, body, motion, question };
}
/** The way, the point and normal of the hit, and where a body is on its way; `size` is that of what is seen. */
export function drawShot(d: Drawing, run: Run, shot: Shot, size: number): void {
  const { from, to, hit, body, motion } = shot, on = onto(d, { look: { wide: true }, size: size * 1.5 });
  if (body !== undefined) run.drawCast(body, { translation: from, rotation: run.place(body).rotation }, motion!, hit, on);
  else run.drawRay({ origin: from, direction: sub(to, from) }, hit, on);
}
