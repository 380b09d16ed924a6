// Vectors, rotations and poses for drawing and dragging. Answers are the library's: nothing here decides anything.

import type { Body, Vec } from "../question.ts";

export const add = (a: Vec, b: Vec): Vec => a.map((x, i) => x + (b[i] ?? 0));
export const sub = (a: Vec, b: Vec): Vec => a.map((x, i) => x - (b[i] ?? 0));
export const scale = (a: Vec, s: number): Vec => a.map((x) => x * s);
export const dot = (a: Vec, b: Vec): number => a.reduce((sum, x, i) => sum + x * (b[i] ?? 0), 0);
export const length = (a: Vec): number => Math.sqrt(dot(a, a));
export const unit = (a: Vec): Vec => {
  const l = length(a);
  return l > 0 ? scale(a, 1 / l) : a.map((_, i) => (i === 0 ? 1 : 0));
};
export const mix = (a: Vec, b: Vec, t: number): Vec => a.map((x, i) => x + ((b[i] ?? 0) - x) * t);
export const cross = (a: Vec, b: Vec): Vec => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];
/** A vector of the plane as one of space. */
export const three = (a: Vec): Vec => [a[0], a[1], a[2] ?? 0];
export const two = (a: Vec): Vec => [a[0], a[1]];

export const quatMultiply = (p: Vec, q: Vec): Vec => [
  p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1],
  p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
  p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3],
  p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2],
];
export function quatAbout(axis: Vec, angle: number): Vec {
  return [...scale(unit(axis), Math.sin(angle / 2)), Math.cos(angle / 2)];
}
/** The shortest rotation that takes the direction of `from` to that of `to`. */
export function quatBetween(from: Vec, to: Vec): Vec {
  const f = unit(from), t = unit(to);
  const q = [...cross(f, t), 1 + dot(f, t)];
  if (length(q) < 1e-9) return [0, 0, 1, 0];
  return unit(q);
}
export function rotate(rotation: Vec | number | undefined, v: Vec): Vec {
  if (rotation === undefined) return v;
  if (typeof rotation === "number") {
    const c = Math.cos(rotation), s = Math.sin(rotation);
    return [c * v[0] - s * v[1], s * v[0] + c * v[1]];
  }
  const [x, y, z, w] = unit(rotation);
  const t = scale(cross([x, y, z], v), 2);
  return add(add(v, scale(t, w)), cross([x, y, z], t));
}
export function inverse(rotation: Vec | number | undefined): Vec | number | undefined {
  if (rotation === undefined) return undefined;
  return typeof rotation === "number" ? -rotation : [-rotation[0], -rotation[1], -rotation[2], rotation[3]];
}
const origin = (v: Vec): Vec => v.map(() => 0);
/** A point of the body's frame in the world. */
export const toWorld = (body: Body, p: Vec): Vec => add(rotate(body.rotation, p), body.translation ?? origin(p));
export const toLocal = (body: Body, p: Vec): Vec =>
  rotate(inverse(body.rotation), sub(p, body.translation ?? origin(p)));
