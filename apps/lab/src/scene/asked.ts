// A question of the protocol as a scene: its bodies, and everything else that it says, answered anew wherever the
// bodies are.

import { ask, type Answer } from "../graze.ts";
import { drawCast, drawDistance, drawRay, onto, type Marks } from "../parts/answers.ts";
import { digits, vector } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, length, scale, three } from "../parts/vec.ts";
import { circle, sphere, type Body, type Question, type Vec } from "../question.ts";
import { Unreadable } from "./meshes.ts";
import { turned, type Scene, type SceneBody } from "./model.ts";
import { about, type Place, type Run } from "./run.ts";
import type { Shot } from "./shots.ts";

/** The bodies of a question, the first of which is A. */
const bodiesOf = (q: Question): ("a" | "b")[] => (["a", "b"] as const).filter((which) => q[which]);

/** The place of a question's body in space. */
function placeOf({ translation, rotation }: Body): Place {
  const turn = Array.isArray(rotation) ? rotation : rotation ? about(rotation) : turned;
  return { translation: three(translation ?? [0, 0]), rotation: turn };
}
/** A body of a response may have no shape: a point stands for it. */
const pointOf = ({ dimension }: Question): Body["shape"] => (dimension === 2 ? circle(0) : sphere(0));

function bodyOf(q: Question, which: "a" | "b"): SceneBody {
  const { mass, linear, angular, shape = pointOf(q) } = q[which]!;
  const moves = mass !== "infinity" && (which === "b" || linear !== undefined || angular !== undefined);
  return {
    name: which.toUpperCase(), shape, ...placeOf(q[which]!), moves, ...(typeof mass === "number" ? { mass } : {}),
    ...(linear ? { linear: three(linear) } : {}),
    ...(angular === undefined ? {} : { angular: typeof angular === "number" ? [0, 0, angular] : angular }) };
}
/** A question as a scene of its bodies, which keeps it. */
export function sceneOfQuestion(q: Question): Scene {
  const bodies = bodiesOf(q).map((which) => bodyOf(q, which));
  if (bodies.length === 0) throw new Unreadable("expected a question about bodies");
  return { name: `a question: ${q.query}`, bodies, question: q, ...(q.dimension === 2 ? { dimension: 2 as const } : {}) };
}
const isPoint = (value: unknown): boolean => Array.isArray(value) && value.length >= 2 && value.every(Number.isFinite);
/** The places that a question names beside its bodies, and those that bodies on their way come to. */
export function placesIn(q: Question): Vec[] {
  const { ray, point, contact, duration = 1 } = q;
  const ways = q.query === "cast" ? bodiesOf(q).map((which) => q[which]!).map(({ translation = [0, 0, 0], linear }) => linear && add(translation, scale(linear, duration))) : [];
  return [ray?.origin, point, contact?.point, ...ways].filter((place): place is Vec => isPoint(place)).map(three);
}

/** Whether a question is about more than how two bodies lie. */
export const asksMore = ({ query }: Question): boolean => !["overlap", "distance", "contacts"].includes(query);

/** The scene's question about its bodies where they are now. A body that was never moved stands as it was written, so
 *  that the answer has the same bits. */
export function questionNow(run: Run, { question, bodies }: Scene): Question {
  const now: Question = { ...question! };
  bodiesOf(now).forEach((which, i) => {
    const written = now[which]!, { translation, rotation } = placeOf(written), here = run.played ? run.place(i) : bodies[i];
    const still = [...translation, ...rotation].join() === [...here.translation, ...here.rotation].join();
    const { shape: _, ...place } = run.asked(i);
    if (!still) now[which] = { ...written, ...place };
  });
  return now;
}

const atRest = (q: Question): Vec => (q.dimension === 2 ? [0, 0] : [0, 0, 0]);

/** The answer in words: a title, and a sentence. */
function said({ query }: Question, answer: Answer): [string, string] {
  const at = `at ${vector(answer.point, 4)}, normal ${vector(answer.normal, 3)}`;
  if (answer.error) return ["There is no answer", answer.error];
  if (query === "closest") return [`${digits(answer.distance, 6)} from A's surface`, `The nearest point of it is ${at}.`];
  if (query === "response") {
    const [a, b] = [answer.a!, answer.b!].map(({ linear, angular }) => `(linear ${vector(linear, 4)}, angular ${typeof angular === "number" ? digits(angular, 4) : vector(angular, 4)})`);
    return ["After the blow", `The impulse on B is ${vector(answer.impulse, 4)}, ${digits(answer.normalImpulse, 5)} along the normal. A goes on with ${a}, B with ${b}.`];
  }
  const [hits, misses] = query === "raycast" ? ["The ray hits A", "The ray hits nothing"] : ["A meets B on its way", "A meets B nowhere on its way"];
  return answer.hit ? [hits, `${query === "raycast" ? "after" : "at"} ${digits(answer.t, 6)}, ${at}`] : [misses, ""];
}
/** The velocities of a response's bodies, as they were and as they are. */
export function drawMotions(d: Drawing, q: Question, answer: Answer, after = true): void {
  for (const which of ["a", "b"] as const) {
    const { translation = atRest(q), linear } = q[which]!, now = answer[which]!.linear;
    if (linear) d.arrow(translation, add(translation, linear), after ? "out" : which, after ? { ghost: true } : { wide: true });
    if (after && length(now) > 0) d.arrow(translation, add(translation, now), which, { wide: true });
  }
}
/** Draws those bodies of a cast that move, on their way for so long. */
export function drawWays(d: Drawing, q: Question, duration: number, marks: Marks): void {
  for (const moving of [q.a, q.b!]) if (moving.linear || moving.angular) drawCast(d, { ...q, a: moving }, duration, marks);
}
function drawAnswer(d: Drawing, q: Question, answer: Answer, size: number): void {
  const look = { wide: true }, marks = { look, size: 1.5 * size };
  if (answer.error) return;
  if (q.query === "raycast") return drawRay(d, q.ray as never, answer.hit ? (answer as never) : null, marks);
  if (q.query === "closest") {
    drawDistance(d, { a: answer.point, b: q.point }, { look, as: { gap: "made", a: "touch", b: "made" } });
    return d.text(scale(add(answer.point!, q.point!), 0.5), digits(answer.distance, 5), "made");
  }
  if (q.query === "response") {
    drawMotions(d, q, answer);
    d.point(q.contact!.point, "touch", look);
    return d.arrow(q.contact!.point, add(q.contact!.point, scale(q.contact!.normal, size / 4)), "axis", { label: "n" });
  }
  const duration = answer.hit ? answer.t! : (q.duration ?? 1);
  drawWays(d, q, duration, marks);
  if (!answer.hit) return;
  onto(d, marks).point!(three(answer.point!), "casts", "contact");
  d.arrow(answer.point!, add(answer.point!, scale(answer.normal!, size / 4)), "axis", look);
}
/** The scene's question, answered and drawn. */
export function answeredQuestion(run: Run, scene: Scene): Shot {
  const question = questionNow(run, scene), answer = ask(question), [title, words] = said(question, answer);
  return { question, title, words, draw: (d, size) => drawAnswer(d, question, answer, size) };
}
