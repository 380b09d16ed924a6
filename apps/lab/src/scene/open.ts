// Files as scenes: glTF, OBJ, STL, PLY, scenes of the plane, and questions.

import * as THREE from "three";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { PLYLoader } from "three/examples/jsm/loaders/PLYLoader.js";
import { STLLoader } from "three/examples/jsm/loaders/STLLoader.js";
import type { graze } from "../graze.ts";
import type { Question, Shape, Vec } from "../question.ts";
import { sceneOfQuestion } from "./asked.ts";
import type { Gltf } from "./gltf-data.ts";
import { meshShape, Unreadable } from "./meshes.ts";
import { turned, type Scene, type SceneBody } from "./model.ts";
import { readGlb, readGltf } from "./open-gltf.ts";
import { readSvg, sceneOfPlane } from "./open-plane.ts";

function fromGeometry(geometry: THREE.BufferGeometry): Shape {
  const position = geometry.getAttribute("position");
  if (!position) throw new Unreadable("the file has no points");
  const points = Array.from({ length: position.count }, (_, i): Vec => [position.getX(i), position.getY(i), position.getZ(i)]);
  if (!points.every((p) => p.every(Number.isFinite))) throw new Unreadable("a coordinate is not a finite number");
  const index = geometry.index ? Array.from(geometry.index.array) : points.map((_, i) => i);
  return meshShape(points, Array.from({ length: Math.floor(index.length / 3) }, (_, i) => index.slice(3 * i, 3 * i + 3)));
}
const still = (name: string, shape: Shape): SceneBody => ({ name, shape, translation: [0, 0, 0], rotation: turned, moves: false });

/** The scene of one question, the first of many, or a scene of the plane. */
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

/** The kind of a file by its name: "gltf". */
export const kindOf = (file: File): string => file.name.toLowerCase().split(".").pop() ?? "";

/** Reads a file that was dropped; `beside` are the files that came with it. Throws `Unreadable`, whose message names
 *  the fault. */
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
