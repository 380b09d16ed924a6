// A capture played again: the places of the bodies in every frame, and the pairs that touched.

import { graze } from "../graze.ts";
import { flatSolidDrawn, solidDrawn, type Solid } from "../parts/solid.ts";
import type { Shape, Vec } from "../question.ts";
import { sorted, type ContactEvent, type StepEvents } from "./events.ts";
import type { SceneBody } from "./model.ts";
import { placesOfPlane, type Pair } from "./run.ts";

export interface CapturedBody {
  /** The name that the run gave it last; else its kind and its number in the world. */
  name: string;
  solid: Solid;
  flat: boolean;
  /** Whether it is somewhere else in a later frame than in the first in which it is. */
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
export interface CapturedFrame {
  /** Seven numbers for each of `bodies`; those of bodies that are not there are without meaning. */
  poses: Float64Array;
  there: ReadonlySet<number>;
  pairs: CapturedPair[];
  events: StepEvents;
  deepest: number;
}
export interface Captured {
  report: graze.ReplayReport;
  scalar: "float" | "double";
  bodies: CapturedBody[];
  frames: CapturedFrame[];
  center: Vec;
  size: number;
}

/** The number of pairs above which points are counted and not kept. */
const mostPairs = 200;

function movesIn(frames: CapturedFrame[], body: number): boolean {
  const poses = frames.filter(({ there }) => there.has(body)).map((frame) => frame.poses.subarray(7 * body, 7 * body + 7));
  return poses.some((pose) => pose.some((x, i) => x !== poses[0][i]));
}

/** Bodies of a frame as those of a scene, to be queried. Throws the reason where a question cannot have one of them. */
export function bodiesAt(captured: Captured, frame: number, numbers: number[]): SceneBody[] {
  const { poses } = captured.frames[frame];
  return numbers.map((i) => {
    const { name, moves, shape, refused } = captured.bodies[i], pose = Array.from(poses.subarray(7 * i, 7 * i + 7));
    if (!shape) throw new Error(`${name}: ${refused}`);
    return { name, shape, translation: pose.slice(0, 3), rotation: pose.slice(3), moves, captured: true };
  });
}

/** The part of the library that plays a capture and draws it. */
type Library = Pick<typeof graze, "replay" | "draw" | "plane" | "protocolShape">;

/** The library in the scalar of a capture; that of float, which nothing else needs, is fetched at the first use. */
async function libraryFor(bytes: ArrayBuffer): Promise<Library> {
  if (graze.captureHead(bytes).scalar === "double") return graze;
  const single = await import("graze");
  await single.init();
  return single;
}

/** Plays a capture. Throws as `graze.replay` does. */
export async function readCapture(bytes: ArrayBuffer): Promise<Captured> {
  const library = await libraryFor(bytes), { plane: flat, scalar } = graze.captureHead(bytes);
  const bodies: CapturedBody[] = [], frames: CapturedFrame[] = [];
  const known = new Map<string, number>();
  let area: { center: Vec; size: number } | null = null;
  const solid = (shape: graze.Shape | graze.plane.Shape): Solid =>
    flat
      ? flatSolidDrawn((on) => library.plane.draw.shape(shape as graze.plane.Shape, {}, on), area!.size)
      : solidDrawn((on) => library.draw.shape(shape as graze.Shape, {}, on), area!.size);
  const words = (shape: graze.Shape | graze.plane.Shape): { shape: Shape | null; refused: string } => {
    try {
      const made = flat ? library.plane.protocolShape(shape as graze.plane.Shape) : library.protocolShape(shape as graze.Shape);
      return { shape: made, refused: "" };
    } catch (error) {
      return { shape: null, refused: (error as Error).message };
    }
  };
  /** The number of a body with its present look: one that gets another shape is drawn as another. */
  const place = (world: graze.WorldQueries | graze.plane.WorldQueries, index: number, id: graze.BodyId): number => {
    const shape = world.shape(id);
    try {
      const { lower, upper } = shape.bounds();
      const key = [index, id.generation, shape.kind, ...lower, ...upper].join();
      let at = known.get(key);
      if (at === undefined) {
        const endless = shape.kind === "halfSpace" || shape.kind === "halfPlane";
        at = bodies.push({ name: `${shape.kind} ${index}`, solid: solid(shape), flat: endless, moves: false, ...words(shape) }) - 1;
        known.set(key, at);
      }
      bodies[at].name = world.name(id) || bodies[at].name;
      return at;
    } finally {
      shape.dispose();
    }
  };
  const report = library.replay(bytes, (world) => {
    area ??= flat ? library.plane.draw.area(world as graze.plane.WorldQueries) : library.draw.area(world as graze.WorldQueries);
    const poses = Float64Array.from(flat ? placesOfPlane(world.poses()) : world.poses()), there = new Map<number, number>();
    for (let i = 0; 7 * i < poses.length; i++) {
      const id = world.bodyAt(i);
      if (id) there.set(place(world, i, id), i);
    }
    const kept = new Float64Array(7 * bodies.length);
    for (const [body, i] of there) kept.set(poses.subarray(7 * i, 7 * i + 7), 7 * body);
    const numbers = new Map([...there].map(([body, i]) => [i, body]));
    const pairs = world.contacts().map(({ a, b, overlap, manifolds }): CapturedPair => ({
      a: numbers.get(a)!, b: numbers.get(b)!, overlap, manifolds: manifolds.map((m) => ({ normal: m.normal,
        points: m.points.map((p) => ({ a: p.a, b: p.b, distance: p.distance, impulse: p.impulse, feature: (p.feature >>> 0).toString(16) })) })),
    }));
    // A body that is not there any more has no number in this frame, and none of its events.
    const events = world.events().flatMap(({ kind, trigger, a, b }): ContactEvent[] => {
      const [one, other] = [a, b].map(({ index, generation }) => (world.bodyAt(index)?.generation === generation ? numbers.get(index) : undefined));
      return one === undefined || other === undefined ? [] : [{ kind, trigger, a: one, b: other }];
    });
    const deepest = Math.max(0, ...pairs.flatMap((pair) => pair.manifolds.flatMap((m) => m.points.map((p) => -p.distance))));
    frames.push({ poses: kept, there: new Set(there.keys()), pairs: pairs.slice(0, mostPairs), events: sorted(events), deepest });
  });
  if (!area) throw new Error("the capture has no whole frame");
  for (const [i, body] of bodies.entries()) body.moves = movesIn(frames, i);
  return { report, scalar, bodies, frames, ...(area as { center: Vec; size: number }) };
}
