// Rays and bodies on their way, and what they meet.

import type { Drawing } from "../parts/drawing.ts";
import { add, scale, sub } from "../parts/vec.ts";
import type { Question, Vec } from "../question.ts";
import type { Scene } from "./model.ts";
import { reached, type Hit, type Place, type Run } from "./run.ts";

export interface Shot {
  kind: "ray" | "cast";
  from: Vec;
  to: Vec;
  hit: Hit | null;
  /** Of a cast, the body and where it comes to. */
  body?: number;
  end?: Place;
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
  return { kind: "cast", from: place.translation, to: end.translation, hit, body, end, question };
}
/** The way, the point and normal of the hit, and the body where it comes to; `size` is that of what is seen. */
export function drawShot(d: Drawing, { from, to, hit, body, end }: Shot, scene: Scene, size: number): void {
  d.arrow(from, to, "made", { wide: true });
  if (hit) d.point(hit.point, "touch", { wide: true });
  if (hit) d.arrow(hit.point, add(hit.point, scale(hit.normal, size / 8)), "axis");
  if (end) d.shape({ shape: scene.bodies[body!].shape, ...end }, "made", { ghost: true });
}
