// The one door to the library: everything that the lab computes is computed behind these functions.

import * as graze from "graze/double";
import type { Body, Question, Shape, Vec } from "./question.ts";

export interface Support { a: Vec; b: Vec; }
export type End = number | "infinity" | "-infinity";
export interface Axis { name: string; direction: Vec; a: [End, End]; b: [End, End]; overlap: number; }
export interface GjkStep { simplex: Support[]; direction: Vec; found: Support; lower: number; upper: number; }
export interface EpaStep { normal: Vec; found?: Support; faceDepth: number; foundDepth: number; faces: number; polygon?: Support[]; }
export interface CastStep { t: number; distance: number; normal: Vec; }
/** A part of a shape, and from where to where a ray is inside of it; where it never is, an interval that ends before it
 *  begins. */
export interface Span { name: string; normal: Vec; span: [End, End]; }
export interface Cut { from: Vec; to: Vec; left: Vec[]; }
export interface Trace {
  method: string;
  winner?: string;
  reason?: string;
  axes: Axis[];
  gjk: GjkStep[];
  epa: EpaStep[];
  steps?: CastStep[];
  spans?: Span[];
  faces?: { a: Vec[]; b: Vec[] };
  cuts?: Cut[];
  difference?: Support[];
  polytope?: { points: Support[]; triangles: [number, number, number][] };
  rounding?: number;
  nodes?: number;
  // Members of a response.
  point?: Vec;
  normal?: Vec;
  relativeVelocity?: { whole: Vec; normal: number; tangential: Vec };
  effectiveMass?: number;
  normalImpulse?: number;
  friction?: { sliding: Vec; stopping: Vec; limit: number; impulse: Vec; holds: boolean };
  atFault?: "a" | "b" | "both" | "neither";
}
export interface ContactPoint { a: Vec; b: Vec; distance: number; feature: string; }
export interface Motion { linear: Vec; angular: Vec | number; }
export interface Answer {
  error?: string;
  overlap?: boolean;
  distance?: number;
  normal?: Vec;
  manifolds?: { normal: Vec; points: ContactPoint[] }[];
  hit?: boolean;
  t?: number;
  point?: Vec;
  normalImpulse?: number;
  impulse?: Vec;
  /** Closest points; of a response the motions after it. */
  a?: Vec & Motion;
  b?: Vec & Motion;
  trace: Trace;
}

export { graze };
export const load = (): Promise<void> => graze.init();

/** The line that `graze query` answers with the same bits. */
export const line = (question: Question): string => JSON.stringify(question);

const empty: Trace = { method: "", axes: [], gjk: [], epa: [] };
const kept = new Map<string, Answer>();

/** The library's answer with its trace. One to a question without an answer has `error`, and an empty trace. */
export function ask(question: Question): Answer {
  const asked = line({ ...question, explain: true } as Question);
  const known = kept.get(asked);
  if (known) return known;
  const answer = JSON.parse(graze.query(asked)) as Answer;
  answer.trace = { ...empty, ...answer.trace };
  for (const part of answer.trace.spans ?? []) part.span ??= ["infinity", "-infinity"]; // a ray that misses has no span
  // A drag asks for hundreds of situations once, a page for its own several times.
  if (kept.size > 64) kept.clear();
  kept.set(asked, answer);
  return answer;
}

/** The library's answer with its trace; throws what it says where there is none. */
export function answered(question: Question): Answer {
  const answer = ask(question);
  if (answer.error) throw new Error(answer.error);
  return answer;
}

// --- Objects of the library that the protocol cannot express: worlds, broad phases, simulations ---

/** The library's shape of a protocol's shape. */
export const shapeOf = (shape: Shape): graze.Shape => graze.shapeOfProtocol(shape);
/** The library's shape of a protocol's shape of the plane. */
export const planeShapeOf = (shape: Shape): graze.plane.Shape => graze.plane.shapeOfProtocol(shape);
/** A shape with the protocol's defaults for measures that it leaves out. */
export function whole(shape: Shape): Shape {
  const made = shapeOf(shape);
  try {
    return graze.protocolShape(made) as Shape;
  } finally {
    made.dispose();
  }
}
/** The pose of a protocol's body; the library requires a quaternion of unit length. */
export function poseOf(body: Body): { translation?: Vec; rotation?: Vec } {
  const pose: { translation?: Vec; rotation?: Vec } = {};
  if (body.translation) pose.translation = body.translation;
  if (Array.isArray(body.rotation)) {
    const l = Math.sqrt(body.rotation.reduce((s, x) => s + x * x, 0));
    pose.rotation = body.rotation.map((x) => x / l);
  }
  return pose;
}
/** The points of A's surface, `most` at most, that span most of the area of contact. */
export function fewest(q: Question, most: number): Vec[] {
  const a = shapeOf(q.a.shape), b = shapeOf(q.b!.shape);
  const found = graze.contacts(a, poseOf(q.a), b, poseOf(q.b!), q.margin ?? 0, most);
  a.dispose();
  b.dispose();
  return found.manifolds.flatMap((m) => m.points.map((p) => p.a as Vec));
}

/** The corners of a body in the world; of a curved one points of its surface, as finely as the library draws it. */
export function tessellated(body: Body): Vec[] {
  const shape = shapeOf(body.shape);
  try {
    return graze.tessellate(shape, poseOf(body)).points;
  } finally {
    shape.dispose();
  }
}

/** The library's quick answer, which may say that bodies overlap that do not, and never the other way round. */
export function mayOverlap(q: Question): boolean {
  const a = shapeOf(q.a.shape), b = shapeOf(q.b!.shape);
  try {
    return graze.mayOverlap(a, poseOf(q.a), b, poseOf(q.b!));
  } finally {
    a.dispose();
    b.dispose();
  }
}

/** The point of contact of two circles or balls, which divides the overlap or the gap as their radii are. */
export function weightedPoint(q: Question, distance: number): Vec {
  const flat = q.dimension === 2, library = (flat ? graze.plane : graze) as typeof graze;
  const [a, b] = [q.a, q.b!].map(({ shape }) => (flat ? planeShapeOf(shape) : shapeOf(shape)) as graze.Shape);
  const found = library.contacts(a, poseOf(q.a), b, poseOf(q.b!), Math.max(0, 2 * distance));
  a.dispose();
  b.dispose();
  const [p] = found.manifolds[0].points;
  return p.a.map((x, i) => x + (p.b[i] - x) * p.weight);
}
/** A body at time t of its motion, in the plane or in space. */
export function bodyAt(body: Body, t: number, flat = true): Body {
  const moving = flat
    ? { translation: body.translation ?? [0, 0], rotation: Number(body.rotation ?? 0), linear: body.linear ?? [0, 0], angular: Number(body.angular ?? 0) }
    : { ...poseOf(body), linear: body.linear, angular: body.angular };
  const { translation, rotation } = flat ? graze.plane.poseAt(moving as graze.plane.Moving, t) : graze.poseAt(moving as graze.Moving, t);
  return { ...body, translation, rotation };
}
