// A scene: bodies with shapes and poses, as files and the built-in list give them.

import type { graze } from "../graze.ts";
import type { Body, Question, Shape, Vec } from "../question.ts";
import type { Animation } from "./animation.ts";
import type { BodyFilter } from "./filters.ts";

/** Poses and velocities are those of space in the plane too, with z = 0 and turns about Z. Velocities are of the
 *  origin. */
export interface SceneBody extends Body {
  name: string;
  shape: Shape;
  translation: Vec;
  rotation: Vec;
  /** Whether it moves by the laws of motion; else it stands. */
  moves: boolean;
  mass?: number;
  /** Whether velocities are those of the centre of mass, which the shapes decide, as in glTF. */
  aboutCenter?: boolean;
  dynamics?: graze.Dynamics | graze.plane.Dynamics;
  trigger?: boolean;
  /** Whether others are seen through it. */
  clear?: boolean;
  filter?: BodyFilter;
  material?: graze.Material | graze.plane.Material;
}
/** Two bodies that are tied, or one that is tied to the world where the other is null. */
export interface Tie {
  a: number | null;
  b: number | null;
  enableCollision?: boolean;
}
export interface SceneJoint extends Tie {
  /** The joint's frame on either, in the world, when the scene begins. */
  frames: [{ translation: Vec; rotation: Vec }, { translation: Vec; rotation: Vec }];
  kind?: "ball" | "hinge" | "fixed" | "slider";
  limits?: graze.JointLimit[];
  drives?: graze.JointDrive[];
}
export interface Scene {
  name: string;
  bodies: SceneBody[];
  /** 2 in the plane, whose shapes are those of the protocol there; in space it is left out. */
  dimension?: 2;
  gravity?: Vec;
  joints?: SceneJoint[];
  animations?: Animation[];
  /** The question that the scene was made of, whose bodies are its own in their order. */
  question?: Question;
  view?: { center: Vec; reach: number; from?: Vec };
  note?: string;
}

export const turned: Vec = [0, 0, 0, 1];
/** The gravity of a scene that says nothing of it. */
export const usualGravity: Vec = [0, -9.81, 0];
