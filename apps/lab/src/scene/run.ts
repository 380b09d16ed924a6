// A scene as the library's objects: a world, and a simulation once it is played; of space or of the plane. Poses go in
// and out as those of space, in the plane with z = 0, so that both are drawn alike.

import { graze, planeShapeOf, poseOf, shapeOf } from "../graze.ts";
import { add, cross, inverse, length, quatMultiply, scale, sub, toLocal, toWorld } from "../parts/vec.ts";
import type { Body, Shape, Vec } from "../question.ts";
import type { ContactEvent } from "./events.ts";
import { filterTaken } from "./filters.ts";
import type { Scene, SceneBody } from "./model.ts";

export interface Place {
  translation: Vec;
  rotation: Vec;
}
export interface Pair {
  a: number;
  b: number;
  overlap: boolean;
  manifolds: { normal: Vec; points: { a: Vec; b: Vec; distance: number }[] }[];
}
export interface Hit {
  body: number;
  t: number;
  point: Vec;
  normal: Vec;
}

type PointRows = Pick<graze.Rows<unknown>, "view" | "length" | "stride" | "offset">;
/** The places and distances of points of contact, four numbers for each. */
export function cloudOf({ view, length, stride, offset }: PointRows): Float32Array {
  const cloud = new Float32Array(4 * length), { a, b, distance, weight } = offset, dimension = b - a;
  for (let i = 0, p = 0; i < length; i++, p += stride) {
    for (let k = 0; k < dimension; k++) cloud[4 * i + k] = view[p + a + k] + (view[p + b + k] - view[p + a + k]) * view[p + weight];
    cloud[4 * i + 3] = view[p + distance];
  }
  return cloud;
}
/** A line from a body of a joint to its anchor, or the gap between its two anchors. */
export interface JointLine {
  from: Vec;
  to: Vec;
  gap: boolean;
}
/** The lines of joints as the library draws a simulation by `draw`. */
export function jointLinesOf(draw: (on: graze.Renderer) => void): JointLine[] {
  const lines: JointLine[] = [];
  draw({ layers: ["joints"], line: (from, to, _, meaning) => lines.push({ from, to, gap: meaning === "gap" }) });
  return lines;
}
/** The energy of all bodies. */
export const energyOf = ({ kineticEnergy, potentialEnergy }: { kineticEnergy: number; potentialEnergy: number }): number => kineticEnergy + potentialEnergy;

/** The times of the parts of a step, in milliseconds. */
export interface Stages {
  collideMs: number;
  prepareMs: number;
  solveMs: number;
  continuousMs: number;
}

/** The settings that a simulation is made with. */
export interface Laws {
  subSteps: number;
  warmStart: boolean;
  gravity: Vec;
}

/** The part of the objects of either dimension that is used here, with poses and vectors in their own form. */
interface AnyQueries {
  pose(id: graze.BodyId): { translation: Vec; rotation: Vec | number };
  poses(): ArrayLike<number>;
  contacts(): Pair[];
  points(): PointRows;
  events(): graze.ContactEvent[];
  raycast(ray: object, options?: object): { body: graze.BodyId; hit: Omit<Hit, "body"> } | null;
  cast(moving: object, options?: object): { body: graze.BodyId; hit: Omit<Hit, "body"> } | null;
}
interface AnyWorld extends AnyQueries {
  add(body: object): graze.BodyId;
  move(id: graze.BodyId, pose: object): void;
  setShape(id: graze.BodyId, shape: AnyShape): void;
  update(): void;
  dispose(): void;
}
interface AnySimulation {
  readonly world: AnyQueries;
  add(body: object, dynamics: object, material: object): graze.BodyId;
  addJoint(joint: object): unknown;
  step(dt: number): void;
  save(): graze.State;
  restore(state: graze.State): void;
  report(): { kineticEnergy: number; potentialEnergy: number; deepest: number } & Stages;
  setPose(id: graze.BodyId, pose: object): void;
  moveTo(id: graze.BodyId, pose: object, dt: number): void;
  setVelocity(id: graze.BodyId, velocity: object): void;
  setMaterial(id: graze.BodyId, material: object): void;
  setGravity(gravity: Vec): void;
  wake(id: graze.BodyId): void;
  asleep(id: graze.BodyId): boolean;
  setName(id: graze.BodyId, name: string): void;
  applyForce(id: graze.BodyId, force: Vec): void;
  motion(id: graze.BodyId): { linear: Vec; center: Vec };
  mass(id: graze.BodyId): number;
  dispose(): void;
}
type AnyShape = graze.Shape | graze.plane.Shape;
interface Dimension {
  world(): AnyWorld;
  simulation(settings: object): AnySimulation;
  shape(of: Shape): AnyShape;
  contactMargin(a: AnyShape, b: AnyShape): number;
  /** Answers as the library draws them. */
  draws: Pick<typeof graze.draw, "ray" | "cast">;
  draw(world: AnyQueries, on: graze.Renderer): void;
  drawSimulation(simulation: AnySimulation, on: graze.Renderer): void;
  /** Numbers of a vector of space. */
  vector(of: Vec): Vec;
  turning(of: Vec): Vec | number;
  pose(of: Place): { translation: Vec; rotation: Vec | number };
  place(of: { translation: Vec; rotation: Vec | number }): Place;
  places(poses: ArrayLike<number>): ArrayLike<number>;
}

/** A place of the world as seen from `frame`. */
export function seenFrom(frame: Place, { translation, rotation }: Place): Place {
  return { translation: toLocal(frame as Body, translation), rotation: quatMultiply(inverse(frame.rotation) as Vec, rotation) };
}

const angleOf = ([, , z, w]: Vec): number => 2 * Math.atan2(z, w);
/** The rotation about Z by an angle. */
export const about = (angle: number): Vec => [0, 0, Math.sin(angle / 2), Math.cos(angle / 2)];

const space: Dimension = {
  world: () => new graze.World() as unknown as AnyWorld,
  simulation: (settings) => new graze.Simulation(settings) as unknown as AnySimulation,
  shape: shapeOf,
  contactMargin: (a, b) => graze.contactMargin(a as graze.Shape, b as graze.Shape),
  get draws() { return graze.draw; },
  draw: (world, on) => graze.draw.world(world as unknown as graze.WorldQueries, on),
  drawSimulation: (simulation, on) => graze.draw.simulation(simulation as unknown as graze.Simulation, on),
  vector: (v) => v,
  turning: (v) => v,
  pose: (place) => ({ translation: place.translation, rotation: poseOf(place as Body).rotation! }),
  place: (pose) => pose as Place,
  places: (poses) => poses,
};
const plane: Dimension = {
  world: () => new graze.plane.World() as unknown as AnyWorld,
  simulation: (settings) => new graze.plane.Simulation(settings) as unknown as AnySimulation,
  shape: planeShapeOf,
  contactMargin: (a, b) => graze.plane.contactMargin(a as graze.plane.Shape, b as graze.plane.Shape),
  get draws() { return graze.plane.draw as unknown as Dimension["draws"]; },
  draw: (world, on) => graze.plane.draw.world(world as unknown as graze.plane.WorldQueries, on),
  drawSimulation: (simulation, on) => graze.plane.draw.simulation(simulation as unknown as graze.plane.Simulation, on),
  vector: ([x, y]) => [x, y],
  turning: (v) => v[2],
  pose: ({ translation: [x, y], rotation }) => ({ translation: [x, y], rotation: angleOf(rotation) }),
  place: ({ translation: [x, y], rotation }) => ({ translation: [x, y, 0], rotation: about(rotation as number) }),
  places: placesOfPlane,
};

/** Poses of the plane (place, and cosine and sine of the turn) as poses of space, of seven numbers each. */
export function placesOfPlane(poses: ArrayLike<number>): Float64Array {
  const made = new Float64Array((poses.length / 4) * 7);
  for (let i = 0; 4 * i < poses.length; i++)
    made.set([poses[4 * i], poses[4 * i + 1], 0, ...about(Math.atan2(poses[4 * i + 3], poses[4 * i + 2]))], 7 * i);
  return made;
}

/** The number of shapes that are known at most: one that grows is another at every moment. */
const mostShapes = 2000;

export class Run {
  readonly flat: boolean;
  private readonly scene: Scene;
  private readonly own: Dimension;
  private readonly shapes = new Map<string, AnyShape>();
  private world: AnyWorld | null;
  private simulation: AnySimulation | null = null;
  private ids: graze.BodyId[];

  /** Makes the world of a scene. Throws `InvalidValue` where the library does. */
  constructor(scene: Scene) {
    this.scene = scene;
    this.flat = scene.dimension === 2;
    this.own = this.flat ? plane : space;
    this.world = this.own.world();
    try {
      this.ids = scene.bodies.map((body) => this.world!.add(this.body(body)));
      this.world.update();
    } catch (error) {
      this.dispose();
      throw error;
    }
  }
  dispose(): void {
    this.simulation?.dispose();
    this.world?.dispose();
    this.forgetShapes();
  }

  // --- The present state ---

  get played(): boolean {
    return this.simulation !== null;
  }
  /** Seven numbers for each of the scene's bodies: translation and quaternion. */
  poses(): ArrayLike<number> {
    return this.own.places(this.questions().poses());
  }
  place(body: number): Place {
    return this.own.place(this.questions().pose(this.ids[body]));
  }
  /** A body where it is now, in the form of a question. */
  asked(body: number): Body {
    return { shape: this.scene.bodies[body].shape, ...this.own.pose(this.place(body)) };
  }
  contacts(): Pair[] {
    return this.questions().contacts();
  }
  /** All points of contact without their pairs, which large scenes have no time to copy. */
  cloud(): Float32Array {
    return cloudOf(this.questions().points());
  }
  /** The events of the last step, but for those of what is no body of the scene. */
  events(): ContactEvent[] {
    return this.questions().events().map(({ kind, trigger, a, b }) => ({ kind, trigger, a: a.index, b: b.index }));
  }
  /** The bodies that sleep, while the scene is played. */
  sleeping(): Set<number> {
    const { simulation, scene } = this;
    return new Set(simulation ? this.ids.flatMap((id, i) => (scene.bodies[i].moves && simulation.asleep(id) ? [i] : [])) : []);
  }
  /** The velocity and mass of a body while the scene is played. */
  motion(body: number): { linear: Vec; mass: number } | null {
    const id = this.ids[body];
    return this.simulation && { linear: this.simulation.motion(id).linear, mass: this.simulation.mass(id) };
  }
  /** A margin with which two bodies at rest keep their points. */
  margin(a: number, b: number): number {
    return this.own.contactMargin(this.shape(this.scene.bodies[a].shape), this.shape(this.scene.bodies[b].shape));
  }
  raycast(ray: { origin: Vec; direction: Vec }): Hit | null {
    const { vector } = this.own;
    return this.hit(this.questions().raycast({ origin: vector(ray.origin), direction: vector(ray.direction) }));
  }
  /** The first hit of a body on its way by `motion`, unturned; one that it touches already and leaves is none. */
  cast(body: number, motion: Vec): Hit | null {
    const moving = { shape: this.shape(this.scene.bodies[body].shape), ...this.own.pose(this.place(body)), linear: this.own.vector(motion) };
    const accept = (id: graze.BodyId): boolean => id.index !== this.ids[body].index;
    return this.hit(this.questions().cast(moving, { accept, separating: "ignored" }));
  }
  /** Draws a ray up to its hit, and the normal there. */
  drawRay(ray: { origin: Vec; direction: Vec }, hit: Hit | null, on: graze.Renderer): void {
    const { vector, draws } = this.own;
    draws.ray({ origin: vector(ray.origin), direction: vector(ray.direction), length: length(ray.direction) } as unknown as graze.Ray, hit as graze.RayHit | null, on);
  }
  /** Draws a body on its way from a place, up to its hit. */
  drawCast(body: number, from: Place, motion: Vec, hit: Hit | null, on: graze.Renderer): void {
    const moving = { shape: this.shape(this.scene.bodies[body].shape), ...this.own.pose(from), linear: this.own.vector(motion) };
    this.own.draws.cast(moving as unknown as graze.Moving, hit as graze.CastHit | null, on);
  }
  /** The box around a body in its own frame, or around where it is now. */
  bounds(body: number, placed = false): { lower: Vec; upper: Vec } {
    const shape = this.shape(this.scene.bodies[body].shape) as graze.Shape;
    const { lower, upper } = shape.bounds(placed ? (this.own.pose(this.place(body)) as graze.PoseLike) : undefined);
    return { lower: [...lower, 0].slice(0, 3), upper: [...upper, 0].slice(0, 3) };
  }
  /** Draws the boxes of the broad phase: the one around each body, and those of its tree. */
  drawBroadPhase(line: (from: Vec, to: Vec, leaf: boolean) => void): void {
    this.own.draw(this.questions(), { layers: ["bounds", "tree"], line: (from, to, layer) => line(from, to, layer === "bounds") });
  }

  /** The lines of the joints, which exist while it is played. */
  jointLines(): JointLine[] {
    const { simulation } = this;
    return simulation && this.scene.joints?.length ? jointLinesOf((on) => this.own.drawSimulation(simulation, on)) : [];
  }
  /** The features of two bodies at each point of contact, by corners in the world: of the first, and of the other. A
   *  round shape has none. In the plane the points of a manifold name the ends of the sides that they lie on: one for
   *  all. */
  features(a: number, b: number, margin: number): [Vec[], Vec[]][] {
    if (this.flat) return this.flatFeatures(a, b, margin);
    const [shapeA, shapeB] = [a, b].map((i) => this.shape(this.scene.bodies[i].shape) as graze.Shape);
    const [poseA, poseB] = [a, b].map((i) => space.pose(this.place(i)) as graze.PoseLike);
    const corners = (shape: graze.Shape, pose: graze.PoseLike, feature: number, piece: number): Vec[] =>
      graze.featureCorners(shape, feature, piece).map((p) => toWorld(pose as Body, p));
    return graze.contacts(shapeA, poseA, shapeB, poseB, margin).manifolds.flatMap((m) =>
      m.points.map(({ feature }): [Vec[], Vec[]] => [corners(shapeA, poseA, feature >>> 16, m.pieceA), corners(shapeB, poseB, feature & 0xffff, m.pieceB)]));
  }

  private flatFeatures(a: number, b: number, margin: number): [Vec[], Vec[]][] {
    const of = (i: number): [graze.plane.Shape, graze.plane.PoseLike] =>
      [this.shape(this.scene.bodies[i].shape) as graze.plane.Shape, plane.pose(this.place(i)) as graze.plane.PoseLike];
    const [shapeA, poseA] = of(a), [shapeB, poseB] = of(b);
    const ends = (shape: graze.plane.Shape, body: number, piece: number, features: number[]): Vec[] => {
      const named = features.flatMap((feature) => graze.plane.featureCorners(shape, feature, piece));
      return named.filter((p, i) => named.findIndex((q) => q[0] === p[0] && q[1] === p[1]) === i)
        .map(([x, y]) => toWorld(this.place(body) as Body, [x, y, 0]));
    };
    return graze.plane.contacts(shapeA, poseA, shapeB, poseB, margin).manifolds.map((m): [Vec[], Vec[]] =>
      [ends(shapeA, a, m.pieceA, m.points.map((p) => p.feature >>> 16)), ends(shapeB, b, m.pieceB, m.points.map((p) => p.feature & 0xffff))]);
  }

  // --- Changes ---

  /** Puts a body somewhere else; contacts are found anew, while nothing is played. */
  put(body: number, place: Place): void {
    const pose = this.own.pose(place);
    if (this.simulation) return this.simulation.setPose(this.ids[body], pose);
    this.world!.move(this.ids[body], pose);
    this.world!.update();
  }
  /** Puts many bodies somewhere, also with other shapes, while nothing is played. */
  putAll(places: ReadonlyMap<number, Place & { shape: Shape }>): void {
    const { world, ids } = this;
    if (!world) return;
    for (const [body, place] of places) {
      world.move(ids[body], this.own.pose(place));
      if (place.shape !== this.scene.bodies[body].shape) world.setShape(ids[body], this.shape(place.shape));
    }
    world.update();
  }
  /** Moves kinematic bodies to places, at which they are after a step of that length. */
  follow(places: ReadonlyMap<number, Place>, dt: number): void {
    for (const [body, place] of places) if (this.scene.bodies[body].dynamics?.kinematic) this.simulation!.moveTo(this.ids[body], this.own.pose(place), dt);
  }
  /** Begins the simulation: from here on the laws of motion hold. `capture` gets the bytes of its frames. */
  play({ gravity, ...how }: Laws, capture?: graze.Capture): void {
    if (this.simulation) return;
    const made = this.own.simulation({ gravity: this.own.vector(gravity), ...how, ...(capture ? { capture } : {}) });
    try {
      const ids = this.scene.bodies.map((body) =>
        made.add(this.body(body), body.moves ? { ...(body.mass ? { mass: body.mass } : {}), ...body.dynamics } : {}, body.material ?? {}));
      if (capture) ids.forEach((id, i) => made.setName(id, this.scene.bodies[i].name));
      for (const [i, { aboutCenter, translation, linear = [0, 0, 0], angular }] of this.scene.bodies.entries()) {
        if (!aboutCenter || !Array.isArray(angular)) continue;
        const arm = sub(translation, made.motion(ids[i]).center);
        made.setVelocity(ids[i], { linear: this.own.vector(add(linear, cross(angular, arm))), angular: this.own.turning(angular) });
      }
      const joints = this.scene.joints ?? [], world = joints.some(({ a, b }) => a === null || b === null) ? this.anchor(made) : null;
      for (const { a, b, frames, ...joint } of joints) {
        const id = (body: number | null): graze.BodyId => (body === null ? world! : ids[body]);
        const frame = (body: number | null, of: Place): object => this.own.pose(body === null ? of : seenFrom(this.scene.bodies[body], of));
        made.addJoint({ ...joint, a: id(a), b: id(b), frameA: frame(a, frames[0]), frameB: frame(b, frames[1]) });
      }
      this.ids = ids;
    } catch (error) {
      made.dispose();
      throw error;
    }
    this.simulation = made;
    this.world!.dispose();
    this.world = null;
  }
  /** Sets a material, from here on, and when the scene is begun anew. */
  setMaterial(body: number, material: graze.Material | graze.plane.Material, wakes = true): void {
    this.simulation?.setMaterial(this.ids[body], material);
    if (wakes) this.simulation?.wake(this.ids[body]);
    this.scene.bodies[body].material = material;
  }
  setGravity(gravity: Vec): void {
    this.simulation?.setGravity(this.own.vector(gravity));
  }
  step(dt: number): { energy: number; deepest: number; stages: Stages } {
    this.simulation!.step(dt);
    const report = this.simulation!.report();
    return { energy: energyOf(report), deepest: report.deepest, stages: report };
  }
  save(): graze.State {
    return this.simulation!.save();
  }
  restore(state: graze.State): void {
    this.simulation!.restore(state);
  }
  /** Pulls a body by a spring, critically damped at three hertz, from the centre of mass to a place. */
  pull(body: number, to: Vec): void {
    const simulation = this.simulation!, id = this.ids[body], omega = 2 * Math.PI * 3;
    const { linear, center } = simulation.motion(id), mass = simulation.mass(id);
    const force = sub(scale(sub(to, center), omega * omega * mass), scale(linear, 2 * omega * mass));
    simulation.wake(id);
    simulation.applyForce(id, this.own.vector(force));
  }

  /** A body at the origin that stands and meets nobody: the world, for joints. */
  private anchor(simulation: AnySimulation): graze.BodyId {
    const point: Shape = this.flat ? { type: "circle", circle: { radius: 0 } } : { type: "sphere", sphere: { radius: 0 } };
    return simulation.add({ shape: this.shape(point), fixed: true, filter: { category: 0, mask: 0 } }, {}, {});
  }
  private questions(): AnyQueries {
    return this.simulation?.world ?? this.world!;
  }
  private hit(found: { body: graze.BodyId; hit: Omit<Hit, "body"> } | null): Hit | null {
    return found && { ...found.hit, body: found.body.index };
  }
  /** Forgets the shapes, of which bodies have shares of their own. */
  private forgetShapes(): void {
    for (const shape of this.shapes.values()) shape.dispose();
    this.shapes.clear();
  }
  private shape(of: Shape): AnyShape {
    const key = JSON.stringify(of);
    let known = this.shapes.get(key);
    if (!known) {
      if (this.shapes.size > mostShapes) this.forgetShapes();
      known = this.own.shape(of);
      this.shapes.set(key, known);
    }
    return known;
  }
  private body(body: SceneBody): object {
    const { own } = this;
    return {
      shape: this.shape(body.shape), ...own.pose(body), fixed: !body.moves, trigger: body.trigger ?? false,
      ...(body.linear ? { linear: own.vector(body.linear) } : {}), ...(Array.isArray(body.angular) ? { angular: own.turning(body.angular) } : {}),
      ...(body.filter ? { filter: filterTaken(body.filter) } : {}),
    };
  }
}

/** The place that a body reaches by its motion in the time t. */
export const reached = (place: Place, motion: Vec, t: number): Place => ({ ...place, translation: add(place.translation, scale(motion, t)) });
/** Half of the diagonal of a box. */
export const reachOf = ({ lower, upper }: { lower: Vec; upper: Vec }): number => length(sub(upper, lower)) / 2;
