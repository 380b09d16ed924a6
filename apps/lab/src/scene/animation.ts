// Animations: bodies that follow the nodes of a file, which keyframes move, turn and scale.

import * as THREE from "three";
import type { Shape, Vec } from "../question.ts";
import { isNumbers } from "./checks.ts";
import { expectedOf, valueAt, type Keys } from "./keyframes.ts";
import type { Place } from "./run.ts";
import { scaled } from "./scaled.ts";

export const properties = ["translation", "rotation", "scale"] as const;
type Property = (typeof properties)[number];
/** The count of numbers of a property. */
export const widthOf = (property: Property): number => (property === "rotation" ? 4 : 3);
/** A part of a node's transformation, and the keys that change it. */
export interface Channel {
  property: Property;
  keys: Keys;
}
/** A node on the way from the root of a file to a body. */
export interface Link {
  /** The transformation of a node that no channel can move. */
  matrix?: number[];
  translation: Vec;
  rotation: Vec;
  scale: Vec;
  channels: Channel[];
}
export interface Animation {
  name: string;
  /** Seconds. */
  duration: number;
  moves: { body: number; chain: Link[] }[];
}
/** The animation that a scene shows, by its number, and the time in it. */
export interface Animated {
  number: number;
  time: number;
}
/** The place of a body, its shape there, and how many times as large along its axes it is as at rest. */
export interface Follower extends Place {
  shape: Shape;
  growth: Vec;
}

type Decomposed = [at: THREE.Vector3, turn: THREE.Quaternion, size: THREE.Vector3];
/** The transformation of the last node of a chain at a time; at rest without one. */
function placed(chain: Link[], t?: number): Decomposed {
  const whole = new THREE.Matrix4();
  for (const { matrix, channels, ...rest } of chain) {
    const own = { ...rest };
    if (t !== undefined) for (const { property, keys } of channels) own[property] = valueAt(keys, t, property === "rotation");
    const { translation, rotation, scale } = own;
    whole.multiply(matrix ? new THREE.Matrix4().fromArray(matrix)
      : new THREE.Matrix4().compose(new THREE.Vector3(...translation), new THREE.Quaternion(...rotation), new THREE.Vector3(...scale)));
  }
  const parts: Decomposed = [new THREE.Vector3(), new THREE.Quaternion(), new THREE.Vector3()];
  whole.decompose(...parts);
  return parts;
}

/** The followers of an animation at a time, by their bodies, whose shapes at rest are given. */
export function followersAt({ moves }: Animation, t: number, shapes: readonly { shape: Shape }[]): Map<number, Follower> {
  return new Map(moves.map(({ body, chain }) => {
    const [at, turn, size] = placed(chain, t), [, , rest] = placed(chain), growth = size.divide(rest).toArray();
    return [body, { translation: at.toArray(), rotation: turn.normalize().toArray(), shape: scaled(shapes[body].shape, growth), growth }];
  }));
}

function isLink({ matrix, channels, ...parts }: Link): boolean {
  return properties.every((one) => isNumbers(parts[one], widthOf(one))) && (matrix === undefined || isNumbers(matrix, 16)) &&
    channels.every(({ property, keys }) => properties.includes(property) && expectedOf(keys, widthOf(property)) === null);
}
/** Whether a value of an address is a list of animations of so many bodies. */
export function areAnimations(value: unknown, bodies: number): boolean {
  try {
    return (value as Animation[]).every(({ name, duration, moves }) => typeof name === "string" && Number.isFinite(duration) && duration >= 0 &&
      moves.every(({ body, chain }) => Number.isInteger(body) && body >= 0 && body < bodies && chain.every(isLink)));
  } catch {
    return false; // something is no list, or no object
  }
}
