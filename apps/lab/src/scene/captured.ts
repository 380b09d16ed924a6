// A capture played again, as it is shown: its bodies, and for every frame their places, the pairs that touched, and what
// a simulation did with them.

import type { graze } from "../graze.ts";
import type { Solid } from "../parts/solid.ts";
import type { Shape, Vec } from "../question.ts";
import type { StepEvents } from "./events.ts";
import type { BodyFilter } from "./filters.ts";
import type { SceneBody, Tie } from "./model.ts";
import type { JointLine, Pair } from "./run.ts";

export interface CapturedBody {
  /** The name that the run gave it last; else its kind and its number in the world. */
  name: string;
  solid: Solid;
  /** Whether it is translucent: a shape without an end, or a trigger. */
  flat: boolean;
  trigger: boolean;
  /** Whether it is not fixed, or is somewhere else in a later frame than in the first in which it is. */
  moves: boolean;
  /** The shape for a question; or the reason why there is none. */
  shape: Shape | null;
  refused: string;
}
/** A pair that a frame found: the points of contact at the time of the search, which in a simulation is before bodies
 *  are moved. */
export interface CapturedPair extends Pair {
  manifolds: { normal: Vec; points: CapturedPoint[] }[];
}
export interface CapturedPoint {
  a: Vec;
  b: Vec;
  distance: number;
  /** The id in hexadecimal digits, as in the protocol. */
  feature: string;
  impulse: Vec;
}
/** The part of a frame that a simulation alone has. */
export interface CapturedMotion {
  energy: number;
  asleep: ReadonlySet<number>;
  joints: JointLine[];
  ties: Tie[];
}
export interface CapturedFrame {
  /** Seven numbers for each of `bodies`; those of bodies that are not there are without meaning. */
  poses: Float64Array;
  there: ReadonlySet<number>;
  /** The filters of `bodies`. */
  filters: readonly (BodyFilter | undefined)[];
  /** The first pairs, of which so many are kept as their points can be drawn one by one. */
  pairs: CapturedPair[];
  /** The points of all pairs where these are more: places and distances, as `cloudOf` gives them. */
  cloud: Float32Array | null;
  counts: { pairs: number; points: number };
  events: StepEvents;
  deepest: number;
  motion: CapturedMotion | null;
}
export interface Captured {
  report: graze.ReplayReport;
  scalar: "float" | "double";
  bodies: CapturedBody[];
  frames: CapturedFrame[];
  center: Vec;
  size: number;
}

/** Bodies of a frame as those of a scene, to be queried. Throws the reason where a question cannot have one of them. */
export function bodiesAt(captured: Captured, frame: number, numbers: number[]): SceneBody[] {
  const { poses, filters } = captured.frames[frame];
  return numbers.map((i) => {
    const { name, moves, trigger, shape, refused } = captured.bodies[i], pose = Array.from(poses.subarray(7 * i, 7 * i + 7)), filter = filters[i];
    if (!shape) throw new Error(`${name}: ${refused}`);
    return { name, shape, translation: pose.slice(0, 3), rotation: pose.slice(3), moves, ...(trigger ? { trigger } : {}), ...(filter ? { filter } : {}) };
  });
}
