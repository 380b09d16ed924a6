// Keyframes: a value that changes over time, as glTF 2.0 samples it (section 3.11, appendix C).

import * as THREE from "three";
import type { Vec } from "../question.ts";

export interface Keys {
  interpolation: "LINEAR" | "STEP" | "CUBICSPLINE";
  /** Seconds, which rise. */
  times: number[];
  /** One for each time; of a spline three: the tangent towards the key, the key, and the tangent away from it. */
  values: Vec[];
}

/** The thing that was expected of keys in place of what they are; null where they can be sampled. `width`: the numbers of
 *  a value, four of a rotation. */
export function expectedOf({ interpolation, times, values }: Keys, width: number): string | null {
  const spline = interpolation === "CUBICSPLINE", key = (i: number): boolean => !spline || i % 3 === 1;
  if (!spline && interpolation !== "LINEAR" && interpolation !== "STEP") return "one of STEP, LINEAR, CUBICSPLINE";
  if (times.length < (spline ? 2 : 1) || !(times[0] >= 0) || !times.every((t, i) => Number.isFinite(t) && (i === 0 || t > times[i - 1])))
    return "times that rise, from 0 or later";
  if (values.length !== times.length * (spline ? 3 : 1) || !values.every((value) => value.length === width && value.every(Number.isFinite)))
    return `${spline ? "three values" : "a value"} of ${width} finite numbers for each time`;
  return width === 4 && values.some((value, i) => key(i) && value.every((x) => x === 0)) ? "a quaternion that is not zero" : null;
}

const normal = (q: Vec): Vec => new THREE.Quaternion(...q).normalize().toArray();
const slerp = (from: Vec, to: Vec, part: number): Vec => new THREE.Quaternion(...from).slerp(new THREE.Quaternion(...to), part).normalize().toArray();

/** Hermite's cubic behind a key of a spline, by `part` of the `seconds` to the next; tangents are in units a second. */
function spline(values: Vec[], key: number, part: number, seconds: number): Vec {
  const [from, away, towards, to] = values.slice(3 * key + 1, 3 * key + 5), t2 = part * part, t3 = t2 * part;
  return from.map((x, k) => (2 * t3 - 3 * t2 + 1) * x + seconds * (t3 - 2 * t2 + part) * away[k] + (3 * t2 - 2 * t3) * to[k] + seconds * (t3 - t2) * towards[k]);
}

/** The value at a time: before the first key that of the first, behind the last that of the last. `turns`: it is a
 *  rotation, which comes out of unit length and takes the shorter way between two keys; where a spline passes through
 *  zero it is the nearer key. */
export function valueAt({ interpolation, times, values }: Keys, t: number, turns: boolean): Vec {
  const last = times.length - 1, first = Math.max(0, times.findLastIndex((time) => time <= t));
  const key = (i: number): Vec => {
    const value = values[interpolation === "CUBICSPLINE" ? 3 * i + 1 : i];
    return turns ? normal(value) : value;
  };
  if (interpolation === "STEP" || first === last || t <= times[first]) return key(first);
  const seconds = times[first + 1] - times[first], part = (t - times[first]) / seconds;
  if (interpolation === "LINEAR") {
    const [from, to] = [key(first), key(first + 1)];
    return turns ? slerp(from, to, part) : from.map((x, k) => x * (1 - part) + to[k] * part);
  }
  const value = spline(values, first, part, seconds);
  if (!turns) return value;
  return value.every((x) => x === 0) ? key(part < 0.5 ? first : first + 1) : normal(value);
}
