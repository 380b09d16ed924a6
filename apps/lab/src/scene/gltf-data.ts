// The parts of a glTF file that the lab reads, and the numbers in its buffers.

import type { Shape, Vec } from "../question.ts";
import { Unreadable } from "./meshes.ts";

export interface Geometry { shape?: number; mesh?: number; node?: number; convexHull?: boolean }
export interface Motion {
  mass?: number; isKinematic?: boolean; linearVelocity?: Vec; angularVelocity?: Vec; gravityFactor?: number;
  centerOfMass?: Vec; inertiaDiagonal?: Vec; inertiaOrientation?: Vec;
}
export interface Limit { linearAxes?: number[]; angularAxes?: number[]; min?: number; max?: number; stiffness?: number; damping?: number }
export interface Drive {
  type: "linear" | "angular"; mode: "force" | "acceleration"; axis: number; maxForce?: number; positionTarget?: number;
  velocityTarget?: number; stiffness?: number; damping?: number;
}
export interface Node {
  name?: string; children?: number[]; mesh?: number; matrix?: number[]; translation?: number[]; rotation?: number[]; scale?: number[];
  extensions?: { KHR_physics_rigid_bodies?: {
    motion?: Motion;
    collider?: { geometry?: Geometry; collisionFilter?: number; physicsMaterial?: number };
    trigger?: { geometry?: Geometry; collisionFilter?: number };
    joint?: { connectedNode: number; joint: number; enableCollision?: boolean };
  } };
}
interface Accessor { bufferView?: number; byteOffset?: number; componentType: number; count: number; type: string }
export interface Gltf {
  asset?: { version?: string };
  nodes?: Node[]; scenes?: { nodes?: number[] }[]; scene?: number;
  meshes?: { primitives: { attributes: Record<string, number>; indices?: number; mode?: number }[] }[];
  accessors?: Accessor[]; bufferViews?: { buffer: number; byteOffset?: number; byteStride?: number; byteLength: number }[]; buffers?: { uri?: string; byteLength: number }[];
  extensions?: {
    KHR_implicit_shapes?: { shapes: Shape[] };
    KHR_physics_rigid_bodies?: {
      collisionFilters?: { collisionSystems?: string[]; collideWithSystems?: string[]; notCollideWithSystems?: string[] }[];
      physicsMaterials?: { staticFriction?: number; dynamicFriction?: number; restitution?: number }[];
      physicsJoints?: { limits?: Limit[]; drives?: Drive[] }[];
    };
  };
}

/** The bytes of all buffers; those in files of their own are among `beside`, the files opened with the scene. */
export function buffersOf(gltf: Gltf, binary: ArrayBuffer | null, beside: File[]): Promise<ArrayBuffer[]> {
  return Promise.all((gltf.buffers ?? []).map(async (b, i) => {
    if (b.uri === undefined && i === 0 && binary) return binary;
    const text = /^data:[^,]*;base64,(.*)$/.exec(b.uri ?? "")?.[1];
    if (text) return Uint8Array.from(atob(text), (c) => c.charCodeAt(0)).buffer as ArrayBuffer;
    const name = decodeURIComponent(b.uri ?? "").split("/").pop(), file = beside.find((f) => f.name === name);
    if (!file) throw new Unreadable(`buffers[${i}]: lies in ${name || "no file"}: open it together with the scene, or by graze view`);
    return file.arrayBuffer();
  }));
}

const widths: Record<number, [number, (view: DataView, at: number) => number]> = {
  5121: [1, (v, at) => v.getUint8(at)], 5123: [2, (v, at) => v.getUint16(at, true)], 5125: [4, (v, at) => v.getUint32(at, true)], 5126: [4, (v, at) => v.getFloat32(at, true)] };

function readAccessor(gltf: Gltf, data: ArrayBuffer[], number: number): Vec[] {
  const accessor = gltf.accessors?.[number], view = accessor && gltf.bufferViews?.[accessor.bufferView ?? -1], wide = accessor && widths[accessor.componentType];
  if (!accessor || !view || !wide || !data[view.buffer]) throw new Unreadable(`accessors[${number}]: cannot be read`);
  const size = accessor.type === "SCALAR" ? 1 : accessor.type === "VEC3" ? 3 : 0, stride = view.byteStride ?? wide[0] * size;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0), bytes = new DataView(data[view.buffer]);
  if (!size || accessor.count > 5e6 || start + stride * (accessor.count - 1) + wide[0] * size > bytes.byteLength) throw new Unreadable(`accessors[${number}]: reaches beyond its buffer`);
  return Array.from({ length: accessor.count }, (_, i) => Array.from({ length: size }, (_, k) => wide[1](bytes, start + i * stride + k * wide[0])));
}

/** The triangles of a mesh under a scale; its other primitives are left out. */
export function trianglesOf(gltf: Gltf, data: ArrayBuffer[], mesh: number, scale: Vec): { points: Vec[]; triangles: number[][] } {
  const points: Vec[] = [], triangles: number[][] = [];
  for (const part of gltf.meshes?.[mesh]?.primitives ?? []) {
    if ((part.mode ?? 4) !== 4) continue;
    const from = points.length, own = readAccessor(gltf, data, part.attributes.POSITION);
    for (const p of own) points.push(p.map((x, k) => x * scale[k]));
    const index = part.indices === undefined ? own.map((_, i) => i) : readAccessor(gltf, data, part.indices).flat();
    for (let i = 0; i + 2 < index.length; i += 3) triangles.push([index[i] + from, index[i + 1] + from, index[i + 2] + from]);
  }
  return { points, triangles };
}
