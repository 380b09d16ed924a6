// The facts about two bodies: their distance, the lessons that explain them, and the features with which they touch.

import { ask, type Answer, type Trace } from "../graze.ts";
import { drawDistance, drawManifold } from "../parts/answers.ts";
import { digits } from "../parts/dom.ts";
import type { Drawing, Meaning } from "../parts/drawing.ts";
import { add, scale } from "../parts/vec.ts";
import { circle, radiusOf, type Body, type Question, type State, type Vec } from "../question.ts";
import { keyOf } from "./pairs.ts";
import type { Pair, Run } from "./run.ts";

/** The question about two bodies where they are now, up to the margin that was asked for, else the one with which they
 *  keep their points at rest. */
function questionOf(run: Run, i: number, j: number, asked?: Question): Question {
  const margin = asked?.query === "contacts" ? (asked.margin ?? 0) : run.margin(i, j);
  return { query: "contacts", ...(run.flat ? { dimension: 2 as const } : {}), a: run.asked(i), b: run.asked(j), margin };
}
/** Two bodies by their places in a run, the question about them, and their signed distance, which does not depend on a
 *  margin. */
export interface AskedPair {
  bodies: [number, number];
  question: Question;
  distance: Answer;
}
/** The pair of two selected bodies, computed once for its facts and its drawing; none unless two are selected. `asked`
 *  is the question that the scene was made of. */
export function askPair(run: Run, [i, j]: number[], asked?: Question): AskedPair | null {
  if (i === undefined || j === undefined) return null;
  const question = questionOf(run, i, j, asked);
  return { bodies: [i, j], question, distance: ask({ ...question, query: "distance", margin: undefined } as Question) };
}

/** Shapes of the plane that GJK's and EPA's lessons draw. */
const convexInPlane = ["circle", "box", "capsule", "convex", "ellipse", "segment"];

/** A lesson that goes through a pair step by step, by its subject, and the state in which it begins. */
export interface PairLesson {
  lesson: string;
  shows: string;
  state: State;
}
/** Two balls as the lesson has them: circles, and how far their centres lie before the plane of the screen. */
function ballsState({ a, b, dimension }: Question): State {
  if (dimension === 2) return { q: { query: "contacts", dimension, a, b } };
  const cut = ({ shape, translation }: Body): Body => ({ shape: circle(radiusOf(shape)), translation: translation!.slice(0, 2) });
  return { q: { query: "contacts", dimension: 2, a: cut(a), b: cut(b!) }, choice: { view: "space", az: a.translation![2], bz: b!.translation![2] } };
}
/** The lessons for a pair whose distance was found by a trace; none for what none draws. */
export function lessonsOf(q: Question, { gjk, epa }: Trace): PairLesson[] {
  const pair = { dimension: q.dimension, a: q.a, b: q.b }, flat = q.dimension === 2, { type } = q.a.shape;
  const contacts: State = { q: { query: "contacts", margin: q.margin, ...pair } }, distance: State = { q: { query: "distance", ...pair } };
  const both = (one: string, other = one): boolean => type === one && q.b!.shape.type === other, rounded = q.a.shape.margin || q.b!.shape.margin;
  if (both("box") && flat) return [{ lesson: "separating-axes-plane", shows: "its axes", state: contacts }];
  if (both("box")) return [{ lesson: "fifteen-axes", shows: "its axes", state: contacts }, { lesson: "contact-set", shows: "its contacts", state: contacts }];
  if (both("sphere") || both("circle")) return [{ lesson: "spheres", shows: "its balls", state: ballsState(q) }];
  if (!flat && !rounded && both("plane", "box")) return [{ lesson: "planes-boxes", shows: "its corners", state: distance }];
  if (!flat && !rounded && both("box", "plane")) return [{ lesson: "planes-boxes", shows: "its corners", state: { q: { query: "distance", a: q.b!, b: q.a } } }];
  if (flat && ![type, q.b!.shape.type].every((one) => convexInPlane.includes(one))) return [];
  return [...(gjk.length ? [{ lesson: flat ? "gjk" : "gjk-space", shows: "GJK", state: distance }] : []),
    ...(epa.length ? [{ lesson: flat ? "epa" : "epa-space", shows: "EPA", state: distance }] : [])];
}

/** A vertex, an edge or a face, to be lit up with the point that it belongs to. */
function drawFeature(d: Drawing, corners: Vec[], meaning: Meaning, key: string): void {
  if (corners.length === 1) d.point(corners[0], meaning, { key });
  const ends = corners.length > 2 ? corners.length : corners.length - 1;
  for (let i = 0; i < ends; i++) d.line(corners[i], corners[(i + 1) % corners.length], meaning, { key });
}
/** Draws the corners, edges and faces with which two bodies touch at each point, and the gap between the two. */
export function drawPair(d: Drawing, run: Run, pair: AskedPair): void {
  run.features(...pair.bodies, pair.question.margin!).forEach((of, point) =>
    of.forEach((corners, k) => drawFeature(d, corners, k ? "b" : "made", `point ${point}`)));
  const { distance, a, b } = pair.distance;
  if (!(distance! > 0)) return;
  const [from, to] = [a, b] as unknown as [Vec, Vec];
  drawDistance(d, pair.distance, { look: { dashed: true }, as: { gap: "axis", a: null, b: null } });
  d.text(scale(add(from, to), 0.5), digits(distance, 4), "axis");
}

/** The state of a picture as far as contacts depend on it. */
export interface Contacts {
  selected: number[];
  /** Whether a layer is drawn. */
  draws: (layer: string) => boolean;
  /** Half of the height that is seen. */
  seen: number;
}
/** The meaning of a point of contact by its distance. */
const meaningOf = (distance: number): Meaning => (distance <= 0 ? "touch" : "axis");
/** Draws points of contact without their pairs, as `cloudOf` gives them. */
export function drawCloud(d: Drawing, cloud: Float32Array): void {
  for (let i = 0; i < cloud.length; i += 4) d.point([cloud[i], cloud[i + 1], cloud[i + 2]], meaningOf(cloud[i + 3]), { small: true });
}
/** Draws the points of contact, each pair by the key of its row, and the normal from the middle of each manifold; where
 *  bodies are selected, only theirs. */
export function drawFound(d: Drawing, pairs: Pair[], { selected, draws, seen }: Contacts): void {
  for (const pair of pairs) {
    const normals = draws("normals") && (selected.length === 0 || [pair.a, pair.b].some((body) => selected.includes(body)));
    for (const manifold of pair.manifolds)
      drawManifold(d, manifold, {
        size: 1.2 * seen, look: { key: keyOf(pair) }, as: { normal: normals ? "axis" : null },
        contact: (i) => (!draws("contacts") ? null : meaningOf(manifold.points[i].distance)) });
  }
}
