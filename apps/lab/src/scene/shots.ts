// Rays, bodies on their way, and measures: what was aimed at, and the answers for the scene as it is now.

import { ask } from "../graze.ts";
import { drawDistance, onto } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, scale } from "../parts/vec.ts";
import { circle, sphere, type Body, type Question, type Vec } from "../question.ts";
import { answeredQuestion } from "./asked.ts";
import { isVector } from "./checks.ts";
import type { Scene } from "./model.ts";
import type { Hit, Run } from "./run.ts";

/** What is asked of a scene beyond its pairs. The question that a scene was made of is its own. */
export type Aim =
  | { kind: "ray"; origin: Vec; direction: Vec }
  | { kind: "cast"; body: number; motion: Vec }
  | { kind: "measure"; from: Vec; to: Vec }
  | { kind: "question" };

/** The answer to an aim. */
export interface Shot {
  /** The question about the body that is hit, alone; none where none is. */
  question: Question | null;
  title: string;
  words: string;
  /** Draws the way, the point and normal of the hit, and a body on its way; `size` is that of the picture. */
  draw(d: Drawing, size: number): void;
}

/** Whether a value of an address is an aim, or none. */
export function isAim(value: unknown): value is Aim | null {
  if (value === null) return true;
  const { kind, ...of } = value as Record<string, unknown>;
  return kind === "question" || (kind === "ray" && isVector(of.origin) && isVector(of.direction)) ||
    (kind === "cast" && Number.isInteger(of.body) && isVector(of.motion)) || (kind === "measure" && isVector(of.from) && isVector(of.to));
}
/** Whether a scene has what an aim is about. */
export const aimsAt = (aim: Aim | null, { bodies, question }: Scene): boolean =>
  aim !== null && (aim.kind === "question" ? question !== undefined : aim.kind !== "cast" || (aim.body >= 0 && aim.body < bodies.length));

const dimensionOf = (run: Run): Partial<Question> => (run.flat ? { dimension: 2 } : {});
const cut = (run: Run, v: Vec): Vec => v.slice(0, run.flat ? 2 : 3);
const met = (hit: Hit | null, scene: Scene): string => (hit ? scene.bodies[hit.body].name : "nothing");
const where = ({ t, point, normal }: Hit, preposition: string): string =>
  `${preposition} ${digits(t, 6)}, at ${vector(point, 4)}, normal ${vector(normal, 3)}`;
const wide = (d: Drawing, size: number): ReturnType<typeof onto> => onto(d, { look: { wide: true }, size: size * 1.5 });

function shotRay(run: Run, scene: Scene, ray: { origin: Vec; direction: Vec }): Shot {
  const hit = run.raycast(ray);
  const question: Question | null = hit && { query: "raycast", ...dimensionOf(run), a: run.asked(hit.body),
    ray: { origin: cut(run, ray.origin), direction: cut(run, ray.direction) } };
  return { question, title: `The ray hits ${met(hit, scene)}`, words: hit ? where(hit, "after") : "", draw: (d, size) => run.drawRay(ray, hit, wide(d, size)) };
}
function castBody(run: Run, scene: Scene, body: number, motion: Vec): Shot {
  const hit = run.cast(body, motion), from = run.place(body);
  const question: Question | null = hit && { query: "cast", ...dimensionOf(run), duration: 1,
    a: { ...run.asked(body), linear: cut(run, motion) }, b: run.asked(hit.body) };
  return { question, title: `${scene.bodies[body].name} meets ${met(hit, scene)} on its way`, words: hit ? where(hit, "at") : "",
    draw: (d, size) => run.drawCast(body, from, motion, hit, wide(d, size)) };
}
/** The distance of two places, as a question about two points. */
function measured(run: Run, from: Vec, to: Vec): Shot {
  const at = (place: Vec): Body => ({ shape: run.flat ? circle(0) : sphere(0), translation: cut(run, place) });
  const question: Question = { query: "distance", ...dimensionOf(run), a: at(from), b: at(to) }, { distance } = ask(question);
  return { question, title: `${digits(distance, 6)} apart`, words: `From ${vector(from, 4)} to ${vector(to, 4)}.`, draw(d) {
    drawDistance(d, { a: from, b: to }, { look: { wide: true }, as: { gap: "made", a: "made", b: "made" } });
    d.text(scale(add(from, to), 0.5), digits(distance, 5), "made");
  } };
}
/** The answer to an aim for the scene as it is now. Throws where the library refuses it: a ray without a direction. */
export function shotOf(aim: Aim, run: Run, scene: Scene): Shot {
  switch (aim.kind) {
    case "ray": return shotRay(run, scene, aim);
    case "cast": return castBody(run, scene, aim.body, aim.motion);
    case "measure": return measured(run, aim.from, aim.to);
    case "question": return answeredQuestion(run, scene);
  }
}
