// Surfaces of the protocol's shapes, to draw them.

import * as THREE from "three";
import { ConvexGeometry } from "three/examples/jsm/geometries/ConvexGeometry.js";
import { measures, pointsOf, radiusOf, sizeOf, type Body, type Shape, type Vec } from "../question.ts";

const triples = (list: Vec[]): number[] => list.flatMap((p) => [p[0], p[1], p[2]]);

function indexed(points: Vec[], triangles: number[][]): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(triples(points), 3));
  geometry.setIndex(triangles.flat());
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  return flat;
}

/** A surface of revolution about Y from the lower ball or disc to the upper. */
function round(profile: [number, number][]): THREE.BufferGeometry {
  return new THREE.LatheGeometry(profile.map(([r, y]) => new THREE.Vector2(r, y)), 40);
}

function hull(points: Vec[]): THREE.BufferGeometry {
  if (points.length > 3) {
    const geometry = new ConvexGeometry(points.map((p) => new THREE.Vector3(p[0], p[1], p[2])));
    if (geometry.getAttribute("position").count > 0) return geometry;
  }
  return indexed(points, points.length >= 3 ? points.slice(2).map((_, i) => [0, i + 1, i + 2]) : []);
}

function field(m: { columns: number; rows: number; spacing?: Vec; heights: (number | null)[] }): THREE.BufferGeometry {
  const [dx, dz] = m.spacing ?? [1, 1];
  const points: Vec[] = [], triangles: number[][] = [];
  for (let r = 0; r < m.rows; r++)
    for (let c = 0; c < m.columns; c++)
      points.push([(c - (m.columns - 1) / 2) * dx, m.heights[r * m.columns + c] ?? 0, (r - (m.rows - 1) / 2) * dz]);
  for (let r = 0; r + 1 < m.rows; r++)
    for (let c = 0; c + 1 < m.columns; c++) {
      const [i, j, k, l] = [r * m.columns + c, r * m.columns + c + 1, (r + 1) * m.columns + c, (r + 1) * m.columns + c + 1];
      if ([i, j, k, l].some((x) => m.heights[x] === null)) continue;
      triangles.push([i, l, j], [i, k, l]);
    }
  return indexed(points, triangles);
}

function compound(children: Body[]): THREE.BufferGeometry {
  const all: number[] = [];
  for (const child of children) {
    const geometry = geometryOf(child.shape).clone();
    if (Array.isArray(child.rotation))
      geometry.applyQuaternion(new THREE.Quaternion(...(child.rotation as [number, number, number, number])).normalize());
    if (child.translation) geometry.translate(...(child.translation as [number, number, number]));
    const flat = geometry.index ? geometry.toNonIndexed() : geometry;
    all.push(...(flat.getAttribute("position").array as Float32Array));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(all, 3));
  geometry.computeVertexNormals();
  return geometry;
}

export function geometryOf(shape: Shape): THREE.BufferGeometry {
  switch (shape.type) {
    case "sphere":
      return new THREE.SphereGeometry(radiusOf(shape) ?? 0.5, 40, 24);
    case "box": {
      const [x, y, z] = sizeOf(shape) ?? [1, 1, 1];
      return new THREE.BoxGeometry(x, y, z);
    }
    case "ellipsoid": {
      const [x, y, z] = measures<{ radii: Vec }>(shape).radii;
      return new THREE.SphereGeometry(1, 40, 24).scale(x, y, z);
    }
    case "cylinder": {
      const m = { height: 2, radiusBottom: 0.5, radiusTop: 0.5, ...measures<{ height?: number; radiusBottom?: number; radiusTop?: number }>(shape) };
      return new THREE.CylinderGeometry(m.radiusTop, m.radiusBottom, m.height, 40);
    }
    case "capsule": {
      const m = { height: 0.5, radiusBottom: 0.25, radiusTop: 0.25, ...measures<{ height?: number; radiusBottom?: number; radiusTop?: number }>(shape) };
      const lean = Math.asin(Math.max(-1, Math.min(1, (m.radiusBottom - m.radiusTop) / Math.max(1e-9, m.height))));
      const quarter = Math.PI / 2;
      const arc = (y: number, r: number, from: number, to: number): [number, number][] =>
        Array.from({ length: 13 }, (_, i) => {
          const angle = from + ((to - from) * i) / 12;
          return [Math.max(0, r * Math.cos(angle)), y + r * Math.sin(angle)];
        });
      return round([...arc(-m.height / 2, m.radiusBottom, -quarter, lean), ...arc(m.height / 2, m.radiusTop, lean, quarter)]);
    }
    case "plane": {
      const m = measures<{ sizeX?: number; sizeZ?: number }>(shape);
      return new THREE.PlaneGeometry(m.sizeX ?? 8, m.sizeZ ?? 8).rotateX(-Math.PI / 2);
    }
    case "convex":
      return hull(pointsOf(shape));
    case "triangle":
      return indexed(pointsOf(shape), [[0, 1, 2]]);
    case "mesh":
      return indexed(pointsOf(shape), measures<{ triangles: number[][] }>(shape).triangles);
    case "heightfield":
      return field(measures(shape));
    case "compound":
      return compound(measures<{ children: Body[] }>(shape).children);
    default:
      return new THREE.BufferGeometry();
  }
}
