// The one door to the library: everything that is computed in the lab is computed behind these functions.

import * as graze from "graze/double";
import type { Question, Vec } from "./question.ts";

export interface Support { a: Vec; b: Vec; }
export type End = number | "infinity" | "-infinity";
export interface Axis { name: string; direction: Vec; a: [End, End]; b: [End, End]; overlap: number; }
export interface GjkStep { simplex: Support[]; direction: Vec; found: Support; lower: number; upper: number; }
export interface EpaStep { normal: Vec; faceDepth: number; foundDepth: number; faces: number; polygon?: Support[]; }
export interface CastStep { t: number; distance: number; normal: Vec; }
export interface Span { name: string; normal: Vec; span: [End, End]; }
export interface Trace {
  method: string;
  winner?: string;
  reason?: string;
  axes: Axis[];
  gjk: GjkStep[];
  epa: EpaStep[];
  steps?: CastStep[];
  spans?: Span[];
  difference?: Support[];
  polytope?: { points: Support[]; triangles: [number, number, number][] };
  rounding?: number;
  nodes?: number;
  // Of a response.
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

/** The library's answer with its trace. What is not answerable has `error`; the trace is then empty. */
export function ask(question: Question): Answer {
  const asked = line({ ...question, explain: true } as Question);
  const known = kept.get(asked);
  if (known) return known;
  const answer = JSON.parse(graze.query(asked)) as Answer;
  answer.trace = { ...empty, ...answer.trace };
  // A drag asks for hundreds of situations once, a page for its own several times.
  if (kept.size > 64) kept.clear();
  kept.set(asked, answer);
  return answer;
}
