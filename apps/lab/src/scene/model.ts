// A scene: bodies with shapes and poses, as files and the built-in list give them, and as the library's objects.

import { graze, poseOf, shapeOf } from "../graze.ts";
import type { Body, Shape, Vec } from "../question.ts";

export interface SceneBody extends Body {
  name: string;
  shape: Shape;
  translation: Vec;
  rotation: Vec;
  /** Moves by the laws of motion; else it stands. */
  moves: boolean;
  mass?: number;
  trigger?: boolean;
  filter?: { category: number; mask: number };
  material?: graze.Material;
}
export interface Scene {
  name: string;
  bodies: SceneBody[];
  joints?: { a: number; b: number; kind: "ball" | "hinge" | "fixed" | "slider"; at: Vec }[];
  view?: { center: Vec; reach: number; from?: Vec };
  note?: string;
}

export const turned: Vec = [0, 0, 0, 1];

/** The library's shapes of a scene, one for each that differs. */
export class Shapes {
  private readonly made = new Map<string, graze.Shape>();
  of(shape: Shape): graze.Shape {
    const key = JSON.stringify(shape);
    let known = this.made.get(key);
    if (!known) {
      known = shapeOf(shape);
      this.made.set(key, known);
    }
    return known;
  }
  dispose(): void {
    for (const shape of this.made.values()) shape.dispose();
  }
}

const libraryBody = (body: SceneBody, shapes: Shapes): graze.Body => ({
  shape: shapes.of(body.shape), ...poseOf(body), fixed: !body.moves, trigger: body.trigger ?? false,
  ...(body.linear ? { linear: body.linear } : {}), ...(Array.isArray(body.angular) ? { angular: body.angular } : {}),
  ...(body.filter ? { filter: body.filter } : {}),
});

export function worldOf(scene: Scene, shapes: Shapes): { world: graze.World; ids: graze.BodyId[] } {
  const world = new graze.World();
  const ids = scene.bodies.map((body) => world.add(libraryBody(body, shapes)));
  world.update();
  return { world, ids };
}

export function simulationOf(scene: Scene, shapes: Shapes, settings: graze.SimulationSettings): { simulation: graze.Simulation; ids: graze.BodyId[] } {
  const simulation = new graze.Simulation(settings);
  const ids = scene.bodies.map((body) =>
    simulation.add(libraryBody(body, shapes), body.moves ? (body.mass ? { mass: body.mass } : { density: 1 }) : {}, body.material ?? {}));
  for (const joint of scene.joints ?? []) {
    const frame = (body: SceneBody): graze.PoseLike => {
      // Where the joint is in the frame of the body: bodies with joints stand unturned in the scenes here.
      return { translation: joint.at.map((x, i) => x - body.translation[i]) };
    };
    simulation.addJoint({ a: ids[joint.a], b: ids[joint.b], kind: joint.kind, frameA: frame(scene.bodies[joint.a]), frameB: frame(scene.bodies[joint.b]) });
  }
  return { simulation, ids };
}
