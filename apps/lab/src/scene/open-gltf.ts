// glTF files as scenes: plain, or with KHR_implicit_shapes and KHR_physics_rigid_bodies. The colliders below a node
// with a motion are one body.

import * as THREE from "three";
import { whole, type graze } from "../graze.ts";
import { quatMultiply, rotate } from "../parts/vec.ts";
import type { Body, Shape, Vec } from "../question.ts";
import { readAnimations } from "./gltf-animation.ts";
import { filtersOf, type NamedFilter } from "./filters.ts";
import { buffersOf, trianglesOf, type Drive, type Gltf, type Limit, type Motion, type Node } from "./gltf-data.ts";
import { meshShape, Unreadable } from "./meshes.ts";
import type { Scene, SceneBody, SceneJoint } from "./model.ts";
import { seenFrom, type Place } from "./run.ts";
import { scaled } from "./scaled.ts";

/** A node in its place, and the node above it, or itself, that moves it. */
interface Placed extends Place {
  node: Node;
  number: number;
  scale: Vec;
  mover: number | null;
  /** The node above it. */
  above: number | null;
}

const axes = ["x", "y", "z"] as const;
const limitOf = ({ linearAxes, angularAxes, min, max, stiffness, damping }: Limit): graze.JointLimit => ({
  min, max, stiffness, damping, space: linearAxes ? "linear" : "angular", axes: (linearAxes ?? angularAxes ?? []).map((i) => axes[i]) });
const materialOf = ({ staticFriction, dynamicFriction, restitution, frictionCombine, restitutionCombine }: graze.Material): graze.Material => ({
  staticFriction, dynamicFriction, restitution, frictionCombine, restitutionCombine });
const driveOf = ({ type, axis, mode, positionTarget, velocityTarget, stiffness, damping, maxForce }: Drive): graze.JointDrive => ({
  mode, positionTarget, velocityTarget, stiffness, damping, maxForce, space: type, axis: axes[axis] });

class GltfReader {
  private readonly gltf: Gltf;
  private readonly data: ArrayBuffer[];
  private readonly placed = new Map<number, Placed>();
  private readonly named: NamedFilter[];
  private readonly filter: (filter: NamedFilter) => SceneBody["filter"];
  private readonly plain: boolean;
  private readonly bodies: SceneBody[] = [];
  /** The fixed bodies, by the nodes of their colliders. */
  private readonly standing = new Map<number, number>();
  /** The node of each body, whose frame is the body's. */
  private readonly frames: number[] = [];
  /** The bodies of the nodes that move. */
  private readonly bodyOf = new Map<number, number>();

  constructor(gltf: Gltf, data: ArrayBuffer[]) {
    this.gltf = gltf;
    this.data = data;
    this.named = (this.physics?.collisionFilters ?? []).map((f) => ({
      systems: f.collisionSystems, collideWith: f.collideWithSystems, notCollideWith: f.notCollideWithSystems }));
    this.filter = filtersOf(this.named);
    this.plain = !(gltf.nodes ?? []).some((n) => n.extensions?.KHR_physics_rigid_bodies?.collider || n.extensions?.KHR_physics_rigid_bodies?.trigger);
    for (const root of gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? []) this.visit(root, new THREE.Matrix4(), null, null);
  }

  read(name: string): Scene {
    const groups = new Map<string, { at: Placed; shape: Shape }[]>();
    for (const at of this.placed.values()) {
      const shape = this.shapeOf(at);
      if (!shape) continue;
      // A trigger is a body by itself, and so is a collider that stands.
      const key = at.mover !== null && !this.rigid(at)?.trigger ? `body ${at.mover}` : `shape ${at.number}`;
      groups.set(key, [...(groups.get(key) ?? []), { at, shape }]);
    }
    for (const parts of groups.values()) this.bodies.push(this.bodyOfParts(parts));
    if (this.bodies.length === 0) throw new Unreadable("the scene has no colliders and no meshes");
    const joints = [...this.placed.values()].flatMap((at) => this.joint(at));
    const animations = readAnimations(this.gltf, this.data, this.frames.map((node) => this.chain(node)));
    for (const { moves } of animations) for (const { body } of moves) this.follow(this.bodies[body]);
    return { name, bodies: this.bodies, joints, ...(animations.length > 0 ? { animations } : {}) };
  }

  /** The nodes from the root to a node. */
  private chain(node: number): number[] {
    const { above } = this.placed.get(node)!;
    return above === null ? [node] : [...this.chain(above), node];
  }
  /** Makes a body that an animation moves one that nothing else does, unless it has a motion of its own. */
  private follow(body: SceneBody): void {
    if (body.moves) return;
    body.moves = true;
    body.dynamics = { kinematic: true };
  }
  private get physics() {
    return this.gltf.extensions?.KHR_physics_rigid_bodies;
  }
  private rigid({ node }: Placed) {
    return node.extensions?.KHR_physics_rigid_bodies;
  }
  private visit(number: number, above: THREE.Matrix4, moverAbove: number | null, parent: number | null): void {
    const node = this.gltf.nodes?.[number];
    if (!node || this.placed.has(number)) throw new Unreadable(`nodes[${number}]: missing, or a node has two parents`);
    const own = node.matrix ? new THREE.Matrix4().fromArray(node.matrix) : new THREE.Matrix4().compose(
      new THREE.Vector3(...(node.translation ?? [0, 0, 0])), new THREE.Quaternion(...(node.rotation ?? [0, 0, 0, 1])), new THREE.Vector3(...(node.scale ?? [1, 1, 1])));
    const matrix = above.clone().multiply(own), position = new THREE.Vector3(), turn = new THREE.Quaternion(), size = new THREE.Vector3();
    matrix.decompose(position, turn, size);
    const mover = node.extensions?.KHR_physics_rigid_bodies?.motion ? number : moverAbove;
    this.placed.set(number, { node, number, mover, above: parent, translation: position.toArray(), rotation: turn.toArray(), scale: size.toArray() });
    for (const child of node.children ?? []) this.visit(child, matrix, mover, number);
  }
  private shapeOf(at: Placed): Shape | null {
    const rigid = this.rigid(at), geometry = (rigid?.collider ?? rigid?.trigger)?.geometry;
    if (geometry?.shape !== undefined) {
      const shape = this.gltf.extensions?.KHR_implicit_shapes?.shapes[geometry.shape];
      if (!shape) throw new Unreadable(`nodes[${at.number}]: there is no shape ${geometry.shape}`);
      return scaled(whole({ type: shape.type, [shape.type]: shape[shape.type] ?? {} }), at.scale);
    }
    const mesh = geometry?.mesh ?? (geometry?.node === undefined ? undefined : this.gltf.nodes?.[geometry.node]?.mesh) ?? (this.plain ? at.node.mesh : undefined);
    if (mesh === undefined) return null;
    const { points, triangles } = trianglesOf(this.gltf, this.data, mesh, at.scale);
    // A mesh that moves is taken by its hull: an open one has no mass of its own.
    return geometry?.convexHull || at.mover !== null ? { type: "convex", convex: { points } } : meshShape(points, triangles);
  }

  /** The body of several shapes: children in the frame of the first. */
  private bodyOfParts(parts: { at: Placed; shape: Shape }[]): SceneBody {
    const [{ at, shape }] = parts;
    this.frames.push(at.number);
    const rigid = this.rigid(at), filter = (rigid?.collider ?? rigid?.trigger)?.collisionFilter;
    const material = rigid?.collider?.physicsMaterial, mover = rigid?.trigger ? null : at.mover;
    const children = parts.map((part): Body => ({ shape: part.shape, ...seenFrom(at, part.at) }));
    if (mover !== null) this.bodyOf.set(mover, this.bodies.length);
    else if (!rigid?.trigger) this.standing.set(at.number, this.bodies.length);
    return {
      name: (mover === null ? at.node.name : this.placed.get(mover)!.node.name) ?? `node ${at.number}`,
      shape: parts.length === 1 ? shape : { type: "compound", compound: { children } },
      translation: at.translation, rotation: at.rotation, moves: mover !== null, trigger: Boolean(rigid?.trigger),
      ...(filter !== undefined && this.named[filter] ? { filter: this.filter(this.named[filter]) } : {}),
      ...(material !== undefined ? { material: materialOf(this.physics?.physicsMaterials?.[material] ?? {}) } : {}),
      ...(mover === null ? {} : this.motion(this.placed.get(mover)!, at)),
    };
  }
  /** The motion that a node gives to a body with the frame of another one. Velocities are in the node's frame. */
  private motion(mover: Placed, frame: Placed): Partial<SceneBody> {
    const motion: Motion = this.rigid(mover)!.motion!, { mass, centerOfMass, inertiaDiagonal, inertiaOrientation } = motion;
    const endless = (x: number): number => (x === 0 ? Infinity : x); // as the format says it
    const inBody = seenFrom(frame, mover);
    return {
      ...(mass === undefined ? {} : { mass: endless(mass) }),
      aboutCenter: true, linear: rotate(mover.rotation, motion.linearVelocity ?? [0, 0, 0]), angular: rotate(mover.rotation, motion.angularVelocity ?? [0, 0, 0]),
      dynamics: {
        kinematic: motion.isKinematic ?? false, gravityFactor: motion.gravityFactor ?? 1,
        ...(centerOfMass ? { centerOfMass: rotate(inBody.rotation, centerOfMass.map((x, i) => x * mover.scale[i])).map((x, i) => x + inBody.translation[i]) } : {}),
        ...(inertiaDiagonal ? { inertiaDiagonal: inertiaDiagonal.map(endless), inertiaOrientation: quatMultiply(inBody.rotation, inertiaOrientation ?? [0, 0, 0, 1]) } : {}),
      },
    };
  }
  /** The body that a joint's node belongs to: the one that moves it, or a fixed collider at it or above; else the
   *  world. */
  private jointed({ mover, number, above }: Placed): number | null {
    if (mover !== null) return this.bodyOf.get(mover) ?? null;
    return this.standing.get(number) ?? (above === null ? null : this.jointed(this.placed.get(above)!));
  }
  /** The joint of a node, if it has one between bodies that can move against each other. */
  private joint(at: Placed): SceneJoint[] {
    const own = this.rigid(at)?.joint;
    if (!own) return [];
    const other = this.placed.get(own.connectedNode), described = this.physics?.physicsJoints?.[own.joint];
    if (!other || !described) throw new Unreadable(`nodes[${at.number}]: a joint without ${other ? "a description" : "another node"}`);
    const [a, b] = [this.jointed(at), this.jointed(other)];
    if (a === b) return [];
    return [{ a, b, frames: [at, other], limits: described.limits?.map(limitOf), drives: described.drives?.map(driveOf), enableCollision: own.enableCollision }];
  }
}

export async function readGltf(gltf: Gltf, binary: ArrayBuffer | null, name: string, beside: File[]): Promise<Scene> {
  if (!gltf.asset?.version?.startsWith("2")) throw new Unreadable("asset.version: expected 2.0");
  return new GltfReader(gltf, await buffersOf(gltf, binary, beside)).read(name);
}

export function readGlb(bytes: ArrayBuffer, name: string, beside: File[]): Promise<Scene> {
  const view = new DataView(bytes);
  if (bytes.byteLength < 20 || view.getUint32(0, true) !== 0x46546c67) throw new Unreadable("not a .glb file");
  const length = view.getUint32(12, true);
  if (20 + length > bytes.byteLength) throw new Unreadable("the file ends too early");
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Gltf;
  return readGltf(gltf, 28 + length <= bytes.byteLength ? bytes.slice(28 + length) : null, name, beside);
}
