// A question of the query protocol (docs/protocol.md) as the lab holds it: the state of a lesson is one, and so is the
// content of a permalink and of "copy as a question".

export type Vec = number[];

export interface Shape {
  type: string;
  margin?: number;
  [measures: string]: unknown;
}
export interface Body {
  shape: Shape;
  translation?: Vec;
  /** A quaternion [x, y, z, w]; in the plane an angle. */
  rotation?: Vec | number;
  linear?: Vec;
  angular?: Vec | number;
  mass?: number | "infinity";
}
export interface Question {
  query: "overlap" | "distance" | "contacts" | "raycast" | "cast" | "closest" | "response";
  dimension?: 2 | 3;
  a: Body;
  b?: Body;
  margin?: number;
  ray?: { origin: Vec; direction: Vec; length?: number };
  point?: Vec;
  duration?: number;
  contact?: { point: Vec; normal: Vec };
  restitution?: number;
  friction?: number;
}

/** The state of a lesson's page: its question, and the choices that are no part of one. */
export interface State {
  q: Question;
  choice?: Record<string, number | string | boolean>;
}

export const box = (...size: number[]): Shape => ({ type: "box", box: { size } });
export const sphere = (radius: number): Shape => ({ type: "sphere", sphere: { radius } });
export const circle = (radius: number): Shape => ({ type: "circle", circle: { radius } });
export const convex = (points: Vec[]): Shape => ({ type: "convex", convex: { points } });
export const plane = (): Shape => ({ type: "plane" });
export const triangle = (...points: Vec[]): Shape => ({ type: "triangle", triangle: { points } });

/** The measures of a shape: the object that has its type's name. */
export function measures<T = Record<string, never>>(shape: Shape): T {
  return (shape[shape.type] ?? {}) as T;
}
export const sizeOf = (shape: Shape): Vec => measures<{ size: Vec }>(shape).size;
export const radiusOf = (shape: Shape): number => measures<{ radius: number }>(shape).radius;
export const pointsOf = (shape: Shape): Vec[] => measures<{ points: Vec[] }>(shape).points;

export const copy = <T>(value: T): T => structuredClone(value);

/** The state with one of its bodies changed. */
export function withBody(state: State, which: "a" | "b", change: (body: Body) => void): State {
  const next = copy(state);
  const body = next.q[which];
  if (body) change(body);
  return next;
}
