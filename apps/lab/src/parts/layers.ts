// The legend of a drawing, whose layers can be switched off and on.

import { h } from "./dom.ts";
import type { Meaning } from "./drawing.ts";

/** The meaning of a colour, and the sign that has it in the drawing. */
export interface Entry {
  meaning: Meaning;
  sign: "■" | "●" | "→" | "—" | "┄" | "□";
  says: string;
}
export interface Layer {
  id: string;
  label: string;
  entries: Entry[];
  /** A sentence below the entries. */
  says?: string;
  /** Whether it is not drawn before somebody switches it on. */
  off?: boolean;
}

export class Layers {
  readonly element: HTMLElement;
  private readonly boxes = new Map<string, HTMLInputElement>();
  private readonly layers: Layer[];

  constructor(layers: Layer[], onChange: () => void) {
    this.layers = layers;
    this.element = h("details", { class: "legend" }, h("summary", {}, "Legend and layers"), h("ul", {}, ...layers.map(({ id, label, entries, says, off }) => {
      const box = h("input", { type: "checkbox", checked: !off, "data-layer": id, onchange: onChange }) as HTMLInputElement;
      this.boxes.set(id, box);
      return h("li", {}, h("label", {}, box, ` ${label}`), ...entries.map(({ meaning, sign, says }) =>
        h("span", { class: "entry" }, h("span", { class: `sign of-${meaning}`, "aria-hidden": "true" }, sign), ` ${says}`)), says && h("span", { class: "entry" }, says));
    })));
  }
  has(id: string): boolean {
    return this.boxes.get(id)?.checked ?? false;
  }
  /** The layers that somebody has switched. */
  get switched(): string[] {
    return this.layers.filter(({ id, off }) => this.has(id) === Boolean(off)).map(({ id }) => id);
  }
  set switched(ids: string[]) {
    for (const { id, off } of this.layers) this.boxes.get(id)!.checked = ids.includes(id) === Boolean(off);
  }
}
