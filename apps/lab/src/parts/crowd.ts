// Many bodies, drawn together: one instanced mesh for each shape, whose matrices alone change from frame to frame.

import * as THREE from "three";
import { color } from "./theme.ts";
import { solidOf } from "./solid.ts";
import type { Meaning } from "./drawing.ts";
import type { Shape } from "../question.ts";

interface Batch { mesh: THREE.InstancedMesh; bodies: number[] }

export class Crowd {
  readonly group = new THREE.Group();
  private batches: Batch[] = [];
  private meanings: Meaning[] = [];

  /** Other bodies than before. */
  set(shapes: Shape[], meanings: Meaning[]): void {
    this.dispose();
    this.meanings = meanings;
    const kinds = new Map<string, number[]>();
    shapes.forEach((shape, i) => {
      const key = JSON.stringify(shape);
      const known = kinds.get(key);
      if (known) known.push(i);
      else kinds.set(key, [i]);
    });
    for (const bodies of kinds.values()) {
      const flat = shapes[bodies[0]].type === "plane";
      const material = new THREE.MeshLambertMaterial({ side: THREE.DoubleSide, transparent: flat, opacity: flat ? 0.4 : 1 });
      const mesh = new THREE.InstancedMesh(solidOf(shapes[bodies[0]]).faces, material, bodies.length);
      mesh.frustumCulled = false;
      mesh.userData.bodies = bodies;
      this.batches.push({ mesh, bodies });
      this.group.add(mesh);
    }
    this.paint();
  }
  /** Seven numbers a body: translation and quaternion. */
  move(poses: ArrayLike<number>): void {
    const matrix = new THREE.Matrix4(), at = new THREE.Vector3(), turn = new THREE.Quaternion(), one = new THREE.Vector3(1, 1, 1);
    for (const { mesh, bodies } of this.batches) {
      bodies.forEach((body, i) => {
        const p = body * 7;
        matrix.compose(at.set(poses[p], poses[p + 1], poses[p + 2]), turn.set(poses[p + 3], poses[p + 4], poses[p + 5], poses[p + 6]), one);
        mesh.setMatrixAt(i, matrix);
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    }
  }
  /** The meaning of bodies other than usual. */
  paint(special: ReadonlyMap<number, Meaning> = new Map()): void {
    const shade = new THREE.Color();
    for (const { mesh, bodies } of this.batches) {
      bodies.forEach((body, i) => mesh.setColorAt(i, shade.set(color(special.get(body) ?? this.meanings[body]))));
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }
  pick(caster: THREE.Raycaster): number | null {
    const [first] = caster.intersectObjects(this.batches.map((b) => b.mesh), false);
    return first?.instanceId === undefined ? null : (first.object.userData.bodies as number[])[first.instanceId];
  }
  dispose(): void {
    for (const { mesh } of this.batches) {
      mesh.geometry.dispose();
      (mesh.material as THREE.Material).dispose();
      mesh.dispose();
    }
    this.group.clear();
    this.batches = [];
  }
}
