// The materials of drawings, each made once and kept: a program lives as long as a material uses it, and takes tens of
// milliseconds to compile, a third of a second where a processor draws.

import type * as THREE from "three";

/** Some times the looks of all meanings in both themes: dashes have a length for each size of a picture. */
const most = 400;

export class Paints {
  private readonly made = new Map<string, THREE.Material>();

  /** The material of a kind and a look, which `make` makes where it is asked for the first time. */
  of<Look extends object, Paint extends THREE.Material>(kind: string, look: Look, make: (look: Look) => Paint): Paint {
    const key = kind + JSON.stringify(look), known = this.made.get(key);
    if (known) return known as Paint;
    if (this.made.size >= most) this.dispose();
    const material = make(look);
    this.made.set(key, material);
    return material;
  }
  /** Frees what the graphics card holds; a material that is drawn again takes it again. */
  dispose(): void {
    for (const material of this.made.values()) material.dispose();
    this.made.clear();
  }
}
