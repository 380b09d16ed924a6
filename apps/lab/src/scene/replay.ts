// A capture's file, played again into what is shown of it.

import { graze } from "../graze.ts";
import { flatSolidDrawn, solidDrawn, type Solid } from "../parts/solid.ts";
import type { Shape, Vec } from "../question.ts";
import type { Captured, CapturedBody, CapturedFrame, CapturedMotion, CapturedPair } from "./captured.ts";
import { sorted, type ContactEvent, type StepEvents } from "./events.ts";
import { filterWritten, type AnsweredFilter, type BodyFilter } from "./filters.ts";
import { cloudOf, energyOf, jointLinesOf, placesOfPlane } from "./run.ts";

/** The number of pairs that are kept of a frame; of others only their points. */
const mostPairs = 200;

type World = graze.WorldQueries | graze.plane.WorldQueries;
type Simulation = graze.SimulationQueries | graze.plane.SimulationQueries;
type AnyShape = graze.Shape | graze.plane.Shape;
/** The part of the library that plays a capture and draws it. */
type Library = Pick<typeof graze, "replay" | "draw" | "plane" | "protocolShape">;

/** The library in the scalar of a capture; that of float, which nothing else needs, is fetched at the first use. */
async function libraryFor(bytes: ArrayBuffer): Promise<Library> {
  if (graze.captureHead(bytes).scalar === "double") return graze;
  const single = await import("graze");
  await single.init();
  return single;
}

function movesIn(frames: CapturedFrame[], body: number): boolean {
  const poses = frames.filter(({ there }) => there.has(body)).map((frame) => frame.poses.subarray(7 * body, 7 * body + 7));
  return poses.some((pose) => pose.some((x, i) => x !== poses[0][i]));
}

/** Takes down one frame after the other. */
class Recorder {
  readonly bodies: CapturedBody[] = [];
  readonly frames: CapturedFrame[] = [];
  area: { center: Vec; size: number } | null = null;
  private readonly library: Library;
  private readonly flat: boolean;
  /** The numbers of the bodies by their looks. */
  private readonly known = new Map<string, number>();
  /** The filters in the present frame, shared with the frames before it as long as they stay. */
  private filters: (BodyFilter | undefined)[] = [];

  constructor(library: Library, flat: boolean) {
    this.library = library;
    this.flat = flat;
  }
  frame(world: World, simulation: Simulation | null): void {
    this.area ??= this.flat ? this.library.plane.draw.area(world as graze.plane.WorldQueries) : this.library.draw.area(world as graze.WorldQueries);
    const poses = Float64Array.from(this.flat ? placesOfPlane(world.poses()) : world.poses());
    /** The places in the world of the bodies that are there, by their numbers. */
    const ids = new Map<number, graze.BodyId>();
    for (let i = 0; 7 * i < poses.length; i++) {
      const id = world.bodyAt(i);
      if (id) ids.set(this.body(world, id), id);
    }
    const kept = new Float64Array(7 * this.bodies.length);
    for (const [body, { index }] of ids) kept.set(poses.subarray(7 * index, 7 * index + 7), 7 * body);
    const numbers = new Map([...ids].map(([body, { index }]) => [index, body]));
    const pairs = this.pairs(world, numbers);
    const points = world.points(), cloud = cloudOf(points);
    let deepest = 0;
    for (let i = 3; i < cloud.length; i += 4) deepest = Math.max(deepest, -cloud[i]);
    this.frames.push({ poses: kept, there: new Set(ids.keys()), filters: this.filters, pairs: pairs.slice(0, mostPairs),
      cloud: pairs.length > mostPairs ? cloud : null, counts: { pairs: pairs.length, points: points.length },
      events: this.events(world, numbers), deepest, motion: simulation && this.motion(simulation, ids, numbers) });
  }

  /** The number of a body with its present look: one that gets another shape is drawn as another. */
  private body(world: World, id: graze.BodyId): number {
    const { shape, fixed, trigger, filter } = world.body(id) as Required<graze.Body>;
    try {
      const { lower, upper } = shape.bounds();
      const key = [id.index, id.generation, shape.kind, ...lower, ...upper].join();
      let at = this.known.get(key);
      if (at === undefined) {
        const endless = ["halfSpace", "halfPlane"].includes(shape.kind);
        at = this.bodies.push({ name: `${shape.kind} ${id.index}`, solid: this.solid(shape), flat: endless || trigger, trigger, moves: !fixed && !trigger, ...this.words(shape) }) - 1;
        this.known.set(key, at);
      }
      this.bodies[at].name = world.name(id) || this.bodies[at].name;
      this.keepFilter(at, filterWritten(filter as AnsweredFilter));
      return at;
    } finally {
      shape.dispose();
    }
  }
  private keepFilter(body: number, filter: BodyFilter | undefined): void {
    if (JSON.stringify(filter) === JSON.stringify(this.filters[body])) return;
    this.filters = [...this.filters];
    this.filters[body] = filter;
  }
  private solid(shape: AnyShape): Solid {
    const { library, area } = this;
    return this.flat
      ? flatSolidDrawn((on) => library.plane.draw.shape(shape as graze.plane.Shape, {}, on), area!.size)
      : solidDrawn((on) => library.draw.shape(shape as graze.Shape, {}, on), area!.size);
  }
  private words(shape: AnyShape): { shape: Shape | null; refused: string } {
    const { library } = this;
    try {
      const made = this.flat ? library.plane.protocolShape(shape as graze.plane.Shape) : library.protocolShape(shape as graze.Shape);
      return { shape: made, refused: "" };
    } catch (error) {
      return { shape: null, refused: (error as Error).message };
    }
  }
  private pairs(world: World, numbers: Map<number, number>): CapturedPair[] {
    return world.contacts().map(({ a, b, overlap, manifolds }): CapturedPair => ({
      a: numbers.get(a)!, b: numbers.get(b)!, overlap, manifolds: manifolds.map((m) => ({ normal: m.normal,
        points: m.points.map((p) => ({ a: p.a, b: p.b, distance: p.distance, impulse: p.impulse, feature: (p.feature >>> 0).toString(16) })) })),
    }));
  }
  /** A body that is not there any more has no number in this frame, and none of its events. */
  private events(world: World, numbers: Map<number, number>): StepEvents {
    return sorted(world.events().flatMap(({ kind, trigger, a, b }): ContactEvent[] => {
      const [one, other] = [a, b].map(({ index, generation }) => (world.bodyAt(index)?.generation === generation ? numbers.get(index) : undefined));
      return one === undefined || other === undefined ? [] : [{ kind, trigger, a: one, b: other }];
    }));
  }
  private motion(simulation: Simulation, ids: Map<number, graze.BodyId>, numbers: Map<number, number>): CapturedMotion {
    const joints = simulation.joints(), { draw } = this.flat ? this.library.plane : this.library;
    return {
      energy: energyOf(simulation.report()),
      asleep: new Set([...ids].filter(([body, id]) => this.bodies[body].moves && simulation.asleep(id)).map(([body]) => body)),
      joints: joints.length > 0 ? jointLinesOf((on) => draw.simulation(simulation as never, on)) : [],
      ties: joints.map((id) => {
        const { a, b, enableCollision } = simulation.joint(id);
        return { a: numbers.get(a.index) ?? null, b: numbers.get(b.index) ?? null, enableCollision };
      }),
    };
  }
}

/** Plays a capture. Throws as `graze.replay` does. */
export async function readCapture(bytes: ArrayBuffer): Promise<Captured> {
  const library = await libraryFor(bytes), { plane, scalar } = graze.captureHead(bytes), recorder = new Recorder(library, plane);
  const report = library.replay(bytes, (world, _frame, _plane, simulation) => recorder.frame(world, simulation));
  const { bodies, frames, area } = recorder;
  if (!area) throw new Error("the capture has no whole frame");
  for (const [i, body] of bodies.entries()) body.moves ||= movesIn(frames, i);
  return { report, scalar, bodies, frames, ...area };
}
