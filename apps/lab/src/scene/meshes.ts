// Meshes of files as shapes.

import type { Shape, Vec } from "../question.ts";

/** A fault of a file, in words for its owner. */
export class Unreadable extends Error {}

/** Points that coincide exactly become one. */
export function meshShape(points: Vec[], triangles: number[][]): Shape {
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
