// Files as scenes: glTF with KHR_implicit_shapes and KHR_physics_rigid_bodies or plain, OBJ, STL, PLY, and questions.

import * as THREE from "three";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import type { graze } from "../graze.ts";
import { three } from "../parts/vec.ts";
import type { Question, Shape, Vec } from "../question.ts";
import { filtersOf, type NamedFilter } from "./filters.ts";
import { turned, type Scene, type SceneBody } from "./model.ts";
import { readSvg, sceneOfPlane } from "./open-plane.ts";
import { about } from "./run.ts";

/** What is wrong with a file, in words for its owner. */
export class Unreadable extends Error {}

interface Node {
  name?: string; children?: number[]; mesh?: number; matrix?: number[]; translation?: number[]; rotation?: number[]; scale?: number[];
  extensions?: { KHR_physics_rigid_bodies?: {
    motion?: { mass?: number; isKinematic?: boolean; linearVelocity?: Vec; angularVelocity?: Vec };
    collider?: { geometry?: Geometry; collisionFilter?: number; physicsMaterial?: number };
    trigger?: { geometry?: Geometry; collisionFilter?: number };
  } };
}
interface Geometry { shape?: number; mesh?: number; node?: number; convexHull?: boolean }
interface Accessor { bufferView?: number; byteOffset?: number; componentType: number; count: number; type: string }
interface Gltf {
  asset?: { version?: string };
  nodes?: Node[]; scenes?: { nodes?: number[] }[]; scene?: number;
  meshes?: { primitives: { attributes: Record<string, number>; indices?: number; mode?: number }[] }[];
  accessors?: Accessor[]; bufferViews?: { buffer: number; byteOffset?: number; byteStride?: number; byteLength: number }[]; buffers?: { uri?: string; byteLength: number }[];
  extensions?: {
    KHR_implicit_shapes?: { shapes: Shape[] };
    KHR_physics_rigid_bodies?: { collisionFilters?: { collisionSystems?: string[]; collideWithSystems?: string[]; notCollideWithSystems?: string[] }[]; physicsMaterials?: { staticFriction?: number; dynamicFriction?: number; restitution?: number }[] };
  };
}

/** Points that coincide exactly become one. */
function meshShape(points: Vec[], triangles: number[][]): Shape {
  const places = new Map<string, number>(), kept: Vec[] = [];
  const place = points.map((p) => {
    const key = p.join();
    let at = places.get(key);
    if (at === undefined) {
      at = kept.push(p) - 1;
      places.set(key, at);
    }
    return at;
  });
  const list = triangles.map((t) => t.map((i) => place[i])).filter(([i, j, k]) => i !== j && j !== k && i !== k);
  if (list.length === 0) throw new Unreadable("the file has no triangles");
  return { type: "mesh", mesh: { points: kept, triangles: list } };
}
function fromGeometry(geometry: THREE.BufferGeometry): Shape {
  const position = geometry.getAttribute("position");
  if (!position) throw new Unreadable("the file has no points");
  const points = Array.from({ length: position.count }, (_, i): Vec => [position.getX(i), position.getY(i), position.getZ(i)]);
  if (!points.every((p) => p.every(Number.isFinite))) throw new Unreadable("a coordinate is not a finite number");
  const index = geometry.index ? Array.from(geometry.index.array) : points.map((_, i) => i);
  return meshShape(points, Array.from({ length: Math.floor(index.length / 3) }, (_, i) => index.slice(3 * i, 3 * i + 3)));
}
const still = (name: string, shape: Shape): SceneBody => ({ name, shape, translation: [0, 0, 0], rotation: turned, moves: false });

const defaults: Record<string, object> = {
  sphere: { radius: 0.5 }, box: { size: [1, 1, 1] }, capsule: { height: 0.5, radiusBottom: 0.25, radiusTop: 0.25 },
  cylinder: { height: 0.5, radiusBottom: 0.25, radiusTop: 0.25 } };
/** A shape of KHR_implicit_shapes under its node's scale, where the result is such a shape, or an ellipsoid. */
function scaled(shape: Shape, scale: Vec, node: number): Shape {
  const [x, y, z] = scale.map(Math.abs), near = (p: number, q: number): boolean => Math.abs(p - q) <= 1e-6 * Math.max(p, q);
  if ([x, y, z].every((s) => near(s, 1))) return shape;
  const m = shape[shape.type] as { radius: number; size: Vec; height: number; radiusBottom: number; radiusTop: number };
  const round = { height: m.height * y, radiusBottom: m.radiusBottom * x, radiusTop: m.radiusTop * x };
  if (shape.type === "box") return { type: "box", box: { size: [m.size[0] * x, m.size[1] * y, m.size[2] * z] } };
  if (shape.type === "sphere") return near(x, y) && near(y, z) ? { type: "sphere", sphere: { radius: m.radius * x } } : { type: "ellipsoid", ellipsoid: { radii: [m.radius * x, m.radius * y, m.radius * z] } };
  if (shape.type === "cylinder" && near(x, z)) return { type: "cylinder", cylinder: round };
  if (shape.type === "capsule" && near(x, y) && near(y, z)) return { type: "capsule", capsule: round };
  throw new Unreadable(`nodes[${node}]: a ${shape.type} scaled by ${scale.join(", ")}; graze collide reads it`);
}

/** The bytes of all buffers; those in files of their own are among `beside`, the files opened with the scene. */
function buffers(gltf: Gltf, binary: ArrayBuffer | null, beside: File[]): Promise<ArrayBuffer[]> {
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

async function readGltf(gltf: Gltf, binary: ArrayBuffer | null, name: string, beside: File[]): Promise<Scene> {
  if (!gltf.asset?.version?.startsWith("2")) throw new Unreadable("asset.version: expected 2.0");
  const data = await buffers(gltf, binary, beside), nodes = gltf.nodes ?? [];
  const read = (number: number): Vec[] => {
    const accessor = gltf.accessors?.[number], view = accessor && gltf.bufferViews?.[accessor.bufferView ?? -1], wide = accessor && widths[accessor.componentType];
    if (!accessor || !view || !wide || !data[view.buffer]) throw new Unreadable(`accessors[${number}]: cannot be read`);
    const size = accessor.type === "SCALAR" ? 1 : accessor.type === "VEC3" ? 3 : 0, stride = view.byteStride ?? wide[0] * size;
    const start = (view.byteOffset ?? 0) + (accessor.byteOffset ?? 0), bytes = new DataView(data[view.buffer]);
    if (!size || accessor.count > 5e6 || start + stride * (accessor.count - 1) + wide[0] * size > bytes.byteLength) throw new Unreadable(`accessors[${number}]: reaches beyond its buffer`);
    return Array.from({ length: accessor.count }, (_, i) => Array.from({ length: size }, (_, k) => wide[1](bytes, start + i * stride + k * wide[0])));
  };
  const meshOf = (number: number, scale: Vec): { points: Vec[]; triangles: number[][] } => {
    const points: Vec[] = [], triangles: number[][] = [];
    for (const part of gltf.meshes?.[number]?.primitives ?? []) {
      if ((part.mode ?? 4) !== 4) continue;
      const from = points.length, own = read(part.attributes.POSITION);
      points.push(...own.map((p) => p.map((x, k) => x * scale[k])));
      const index = part.indices === undefined ? own.map((_, i) => i) : read(part.indices).flat();
      for (let i = 0; i + 2 < index.length; i += 3) triangles.push([index[i] + from, index[i + 1] + from, index[i + 2] + from]);
    }
    return { points, triangles };
  };
  const physics = gltf.extensions?.KHR_physics_rigid_bodies, shapes = gltf.extensions?.KHR_implicit_shapes?.shapes ?? [];
  const named = (physics?.collisionFilters ?? []).map((f): NamedFilter => ({
    systems: f.collisionSystems, collideWith: f.collideWithSystems, notCollideWith: f.notCollideWithSystems }));
  const filter = filtersOf(named);
  const filterOf = (number: number | undefined): SceneBody["filter"] => (number !== undefined && named[number] ? filter(named[number]) : undefined);
  const bodies: SceneBody[] = [], seen = new Set<number>();
  const anyCollider = nodes.some((n) => n.extensions?.KHR_physics_rigid_bodies?.collider || n.extensions?.KHR_physics_rigid_bodies?.trigger);
  const visit = (number: number, above: THREE.Matrix4, motionAbove: { mass?: number } | null): void => {
    const node = nodes[number];
    if (!node || seen.has(number)) throw new Unreadable(`nodes[${number}]: missing, or a node has two parents`);
    seen.add(number);
    const own = node.matrix ? new THREE.Matrix4().fromArray(node.matrix) : new THREE.Matrix4().compose(
      new THREE.Vector3(...(node.translation ?? [0, 0, 0])), new THREE.Quaternion(...(node.rotation ?? [0, 0, 0, 1])), new THREE.Vector3(...(node.scale ?? [1, 1, 1])));
    const matrix = above.clone().multiply(own), rigid = node.extensions?.KHR_physics_rigid_bodies;
    const motion = rigid?.motion ?? motionAbove;
    const where = rigid?.collider ?? rigid?.trigger;
    const position = new THREE.Vector3(), turn = new THREE.Quaternion(), size = new THREE.Vector3();
    matrix.decompose(position, turn, size);
    const scale = size.toArray();
    let shape: Shape | undefined;
    if (where?.geometry?.shape !== undefined) {
      shape = structuredClone(shapes[where.geometry.shape]);
      if (!shape) throw new Unreadable(`nodes[${number}]: there is no shape ${where.geometry.shape}`);
      shape = scaled({ ...shape, [shape.type]: { ...defaults[shape.type], ...(shape[shape.type] as object) } }, scale, number);
    } else {
      const mesh = where?.geometry?.mesh ?? (where?.geometry?.node !== undefined ? nodes[where.geometry.node]?.mesh : undefined) ?? (anyCollider ? undefined : node.mesh);
      if (mesh !== undefined) {
        const { points, triangles } = meshOf(mesh, scale);
        shape = where?.geometry?.convexHull || motion ? { type: "convex", convex: { points } } : meshShape(points, triangles);
      }
    }
    if (shape) {
      const material = rigid?.collider?.physicsMaterial;
      bodies.push({
        name: node.name ?? `node ${number}`, shape, translation: position.toArray(), rotation: turn.toArray(), moves: Boolean(motion) && !rigid?.motion?.isKinematic,
        ...(motion?.mass ? { mass: motion.mass } : {}), ...(rigid?.motion?.linearVelocity ? { linear: rigid.motion.linearVelocity } : {}),
        ...(rigid?.trigger ? { trigger: true } : {}), ...(material !== undefined ? { material: physics?.physicsMaterials?.[material] ?? {} } : {}),
        ...(filterOf(where?.collisionFilter) ? { filter: filterOf(where?.collisionFilter) } : {}),
      });
    }
    for (const child of node.children ?? []) visit(child, matrix, motion);
  };
  for (const root of gltf.scenes?.[gltf.scene ?? 0]?.nodes ?? []) visit(root, new THREE.Matrix4(), null);
  if (bodies.length === 0) throw new Unreadable("the scene has no colliders and no meshes");
  return { name, bodies };
}

function readGlb(bytes: ArrayBuffer, name: string, beside: File[]): Promise<Scene> {
  const view = new DataView(bytes);
  if (bytes.byteLength < 20 || view.getUint32(0, true) !== 0x46546c67) throw new Unreadable("not a .glb file");
  const length = view.getUint32(12, true);
  if (20 + length > bytes.byteLength) throw new Unreadable("the file ends too early");
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, length))) as Gltf;
  return readGltf(gltf, 28 + length <= bytes.byteLength ? bytes.slice(28 + length) : null, name, beside);
}

/** A question as a scene of its two bodies. */
export function sceneOfQuestion(q: Question): Scene {
  const bodies = (["a", "b"] as const).filter((w) => q[w]).map((w): SceneBody => {
    const { translation, rotation } = q[w]!, turn = Array.isArray(rotation) ? rotation : rotation ? about(rotation) : turned;
    return { ...q[w]!, name: w.toUpperCase(), translation: three(translation ?? [0, 0]), rotation: turn, moves: w === "b", mass: undefined };
  });
  if (bodies.length === 0) throw new Unreadable("expected a question about bodies");
  return { name: `a question: ${q.query}`, bodies, ...(q.dimension === 2 ? { dimension: 2 as const } : {}) };
}
/** One question, the first of many, or a scene of the plane. */
function readJson(text: string, name: string): Scene {
  const whole = ((): unknown => {
    try {
      return JSON.parse(text);
    } catch {
      return JSON.parse(text.split("\n").find((l) => l.trim()) ?? "{}");
    }
  })();
  return Array.isArray((whole as graze.PlaneScene).bodies) ? sceneOfPlane(whole as graze.PlaneScene, name) : sceneOfQuestion(whole as Question);
}

/** What a file's name says that it is: "gltf". */
export const kindOf = (file: File): string => file.name.toLowerCase().split(".").pop() ?? "";

/** Reads what somebody dropped; `beside` are the files that came with it. Throws `Unreadable`, whose message names what is
 *  wrong. */
export async function openFile(file: File, beside: File[] = []): Promise<Scene> {
  try {
    switch (kindOf(file)) {
      case "gltf": return await readGltf(JSON.parse(await file.text()) as Gltf, null, file.name, beside);
      case "glb": return await readGlb(await file.arrayBuffer(), file.name, beside);
      case "json": case "jsonl": return readJson(await file.text(), file.name);
      case "svg": return readSvg(await file.text(), file.name);
      case "stl": return { name: file.name, bodies: [still(file.name, fromGeometry(new STLLoader().parse(await file.arrayBuffer())))] };
      case "ply": return { name: file.name, bodies: [still(file.name, fromGeometry(new PLYLoader().parse(await file.arrayBuffer())))] };
      case "obj": {
        const bodies: SceneBody[] = [];
        new OBJLoader().parse(await file.text()).traverse((part) => {
          if ((part as THREE.Mesh).isMesh) bodies.push(still(part.name || `part ${bodies.length + 1}`, fromGeometry((part as THREE.Mesh).geometry)));
        });
        if (bodies.length === 0) throw new Unreadable("the file has no faces");
        return { name: file.name, bodies };
      }
      default: throw new Unreadable("expected .gltf, .glb, .obj, .stl, .ply, .svg, .json, .jsonl or .capture");
    }
  } catch (error) {
    throw new Unreadable(`${file.name}: ${(error as Error).message}`);
  }
}
