// The materials of drawings, each made once and kept: a program lives as long as a material uses it, and to compile
// those of one picture takes a third of a second where a processor draws.

import type * as THREE from "three";

/** The number of materials above which those of old pictures are given up, some times the looks of all meanings in both
 *  themes: dashes have a length for each size of a picture. */
const most = 400;

export class Paints {
  private readonly made = new Map<string, THREE.Material>();

  /** The material of a kind and a look, which `make` makes where it is asked for the first time. */
  of<Look extends object, Paint extends THREE.Material>(kind: string, look: Look, make: (look: Look) => Paint): Paint {
    const key = kind + JSON.stringify(look), known = this.made.get(key);
    if (known) return known as Paint;
    const material = make(look);
    this.made.set(key, material);
    return material;
  }
  /** Frees what the graphics card holds of too many materials. To be called when none is in a picture. */
  limit(): void {
    if (this.made.size > most) this.dispose();
  }
  dispose(): void {
    for (const material of this.made.values()) material.dispose();
    this.made.clear();
  }
}
