// Files as scenes: glTF, OBJ, STL, PLY, scenes of the plane, and questions.

import { graze } from "../graze.ts";
import type { Question, Shape } from "../question.ts";
import { sceneOfQuestion } from "./asked.ts";
import type { Gltf } from "./gltf-data.ts";
import { Unreadable } from "./meshes.ts";
import { turned, type Scene } from "./model.ts";
import { readGlb, readGltf } from "./open-gltf.ts";
import { readSvg, sceneOfPlane } from "./open-plane.ts";

/** The scene of a mesh that lies still. */
async function readMesh(file: File, format: "obj" | "ply" | "stl"): Promise<Scene> {
  const mesh = graze.meshOfFile(new Uint8Array(await file.arrayBuffer()), format);
  try {
    const shape = graze.protocolShape(mesh) as Shape;
    return { name: file.name, bodies: [{ name: file.name, shape, translation: [0, 0, 0], rotation: turned, moves: false }] };
  } finally {
    mesh.dispose();
  }
}

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
      case "obj": case "ply": case "stl": return await readMesh(file, kindOf(file) as "obj" | "ply" | "stl");
      default: throw new Unreadable("expected .gltf, .glb, .obj, .stl, .ply, .svg, .json, .jsonl or .capture");
    }
  } catch (error) {
    throw new Unreadable(`${file.name}: ${(error as Error).message}`);
  }
}
