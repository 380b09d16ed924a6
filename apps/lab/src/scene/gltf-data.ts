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
interface Accessor { bufferView?: number; byteOffset?: number; componentType: number; normalized?: boolean; count: number; type: string }
export interface Gltf {
  asset?: { version?: string };
  nodes?: Node[]; scenes?: { nodes?: number[] }[]; scene?: number;
  meshes?: { primitives: { attributes: Record<string, number>; indices?: number; mode?: number }[] }[];
  animations?: { name?: string; channels: { sampler: number; target: { node?: number; path: string } }[]; samplers: { input: number; output: number; interpolation?: string }[] }[];
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

/** The kinds of numbers: their bytes, how one is read, and the largest of those that may stand for parts of one. */
const kinds: Record<number, [bytes: number, read: (view: DataView, at: number) => number, largest?: number]> = {
  5120: [1, (v, at) => v.getInt8(at), 127], 5121: [1, (v, at) => v.getUint8(at), 255], 5122: [2, (v, at) => v.getInt16(at, true), 32767], 5123: [2, (v, at) => v.getUint16(at, true), 65535],
  5125: [4, (v, at) => v.getUint32(at, true)], 5126: [4, (v, at) => v.getFloat32(at, true)] };
const sizes: Record<string, number> = { SCALAR: 1, VEC3: 3, VEC4: 4 };

/** The values of an accessor, each with its numbers. */
export function numbersOf(gltf: Gltf, data: ArrayBuffer[], number: number): Vec[] {
  const accessor = gltf.accessors?.[number], view = accessor && gltf.bufferViews?.[accessor.bufferView ?? -1], wide = accessor && kinds[accessor.componentType];
  if (!accessor || !view || !wide || !data[view.buffer]) throw new Unreadable(`accessors[${number}]: cannot be read`);
  const size = sizes[accessor.type] ?? 0, stride = view.byteStride ?? wide[0] * size;
  const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0), bytes = new DataView(data[view.buffer]);
  if (!size || accessor.count > 5e6 || start + stride * (accessor.count - 1) + wide[0] * size > bytes.byteLength) throw new Unreadable(`accessors[${number}]: reaches beyond its buffer`);
  const [width, read, largest] = wide, part = accessor.normalized && largest ? (x: number): number => Math.max(-1, x / largest) : (x: number): number => x;
  return Array.from({ length: accessor.count }, (_, i) => Array.from({ length: size }, (_, k) => part(read(bytes, start + i * stride + k * width))));
}

/** The triangles of a mesh under a scale; its other primitives are left out. */
export function trianglesOf(gltf: Gltf, data: ArrayBuffer[], mesh: number, scale: Vec): { points: Vec[]; triangles: number[][] } {
  const points: Vec[] = [], triangles: number[][] = [];
  for (const part of gltf.meshes?.[mesh]?.primitives ?? []) {
    if ((part.mode ?? 4) !== 4) continue;
    const from = points.length, own = numbersOf(gltf, data, part.attributes.POSITION);
    for (const p of own) points.push(p.map((x, k) => x * scale[k]));
    const index = part.indices === undefined ? own.map((_, i) => i) : numbersOf(gltf, data, part.indices).flat();
    for (let i = 0; i + 2 < index.length; i += 3) triangles.push([index[i] + from, index[i + 1] + from, index[i + 2] + from]);
  }
  return { points, triangles };
}
