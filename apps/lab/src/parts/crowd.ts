// Many bodies, drawn together: one instanced mesh for each shape, whose matrices alone change from frame to frame, and
// one for the outlines of those that have one.

import * as THREE from "three";
import { Paints } from "./paints.ts";
import { rimMaterial } from "./rim.ts";
import { color } from "./theme.ts";
import type { Solid } from "./solid.ts";
import type { Meaning } from "./drawing.ts";
import type { Vec } from "../question.ts";

/** The look of a body; bodies with the same key share one. */
export interface Looks {
  key: string;
  make: () => Solid;
  /** Whether it is translucent: a shape without an end, or a trigger. */
  flat: boolean;
}
interface Batch { mesh: THREE.InstancedMesh; rim: THREE.InstancedMesh<THREE.BufferGeometry, THREE.ShaderMaterial>; bodies: number[] }

export class Crowd {
  readonly group = new THREE.Group();
  private readonly paints = new Paints();
  private batches: Batch[] = [];
  private meanings: Meaning[] = [];
  private special: ReadonlyMap<number, Meaning> = new Map();

  /** Replaces the bodies. */
  set(looks: Looks[], meanings: Meaning[]): void {
    this.clear();
    this.meanings = meanings;
    const kinds = new Map<string, number[]>();
    looks.forEach(({ key }, i) => {
      const known = kinds.get(key);
      if (known) known.push(i);
      else kinds.set(key, [i]);
    });
    for (const bodies of kinds.values()) {
      const { flat, make } = looks[bodies[0]];
      const solid = make(), plane = solid.rim !== solid.faces;
      const material = this.paints.of("faces", { flat },
        () => new THREE.MeshLambertMaterial({ side: THREE.DoubleSide, transparent: flat, opacity: flat ? 0.4 : 1 }));
      const mesh = new THREE.InstancedMesh(solid.faces, material, bodies.length);
      const rim = new THREE.InstancedMesh(solid.rim, this.paints.of("rim", { plane }, () => rimMaterial(plane)), bodies.length);
      mesh.frustumCulled = rim.frustumCulled = rim.visible = false;
      mesh.userData.bodies = bodies;
      this.batches.push({ mesh, rim, bodies });
      this.group.add(mesh, rim);
    }
    this.paint();
  }
  /** Moves the bodies: seven numbers each, translation and quaternion. With `there`, bodies not in it are hidden; those in
   *  `growths` are so many times as large along their axes. */
  move(poses: ArrayLike<number>, there?: ReadonlySet<number>, growths?: ReadonlyMap<number, Vec>): void {
    const matrix = new THREE.Matrix4(), at = new THREE.Vector3(), turn = new THREE.Quaternion();
    const one = new THREE.Vector3(1, 1, 1), size = new THREE.Vector3(), none = new THREE.Vector3(0, 0, 0);
    for (const { mesh, bodies } of this.batches) {
      bodies.forEach((body, i) => {
        const p = body * 7;
        if (there && !there.has(body)) matrix.compose(at.set(0, 0, 0), turn.identity(), none);
        else matrix.compose(at.set(poses[p], poses[p + 1], poses[p + 2]), turn.set(poses[p + 3], poses[p + 4], poses[p + 5], poses[p + 6]), growths?.has(body) ? size.fromArray(growths.get(body)!) : one);
        mesh.setMatrixAt(i, matrix);
      });
      mesh.instanceMatrix.needsUpdate = true;
      mesh.boundingSphere = null;
    }
  }
  /** Paints bodies whose meaning is another than usual. */
  paint(special: ReadonlyMap<number, Meaning> = new Map()): void {
    this.special = special;
    this.repaint();
  }
  /** Draws outlines round these bodies, where they are now, and round no others. */
  outline(outlined: ReadonlySet<number>): void {
    const matrix = new THREE.Matrix4();
    for (const { mesh, rim, bodies } of this.batches) {
      rim.count = 0;
      bodies.forEach((body, i) => {
        if (!outlined.has(body)) return;
        mesh.getMatrixAt(i, matrix);
        rim.setMatrixAt(rim.count++, matrix);
      });
      rim.visible = rim.count > 0;
      rim.instanceMatrix.needsUpdate = true;
    }
  }
  /** Paints all bodies once more, in the colours of another theme. */
  repaint(): void {
    const shade = new THREE.Color();
    for (const { mesh, rim, bodies } of this.batches) {
      (rim.material.uniforms.shade.value as THREE.Color).set(color("touch"));
      bodies.forEach((body, i) => mesh.setColorAt(i, shade.set(color(this.special.get(body) ?? this.meanings[body]))));
      if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
    }
  }
  pick(caster: THREE.Raycaster): number | null {
    const [first] = caster.intersectObjects(this.batches.map((b) => b.mesh), false);
    return first?.instanceId === undefined ? null : (first.object.userData.bodies as number[])[first.instanceId];
  }
  private clear(): void {
    for (const { mesh, rim } of this.batches)
      for (const drawn of [mesh, rim]) {
        drawn.geometry.dispose();
        drawn.dispose();
      }
    this.group.clear();
    this.batches = [];
  }
  dispose(): void {
    this.clear();
    this.paints.dispose();
  }
}
