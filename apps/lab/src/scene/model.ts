// A scene: bodies with shapes and poses, as files and the built-in list give them.

import type { graze } from "../graze.ts";
import type { Body, Shape, Vec } from "../question.ts";

/** Poses and velocities are those of space in the plane too, with z = 0 and turns about Z. */
export interface SceneBody extends Body {
  name: string;
  shape: Shape;
  translation: Vec;
  rotation: Vec;
  /** Moves by the laws of motion; else it stands. */
  moves: boolean;
  mass?: number;
  dynamics?: { inertia?: number; gravityFactor?: number; kinematic?: boolean };
  trigger?: boolean;
  filter?: { category: number; mask: number };
  material?: graze.Material | graze.plane.Material;
}
export interface Scene {
  name: string;
  bodies: SceneBody[];
  /** Of the plane, whose shapes are those of the protocol there; of space where nothing is said. */
  dimension?: 2;
  gravity?: Vec;
  joints?: { a: number; b: number; kind: "ball" | "hinge" | "fixed" | "slider"; at: Vec }[];
  view?: { center: Vec; reach: number; from?: Vec };
  note?: string;
}

export const turned: Vec = [0, 0, 0, 1];
