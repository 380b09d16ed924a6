// The settings of time in a scene, as fields.

import { h } from "../parts/dom.ts";
import { speedSelect } from "../parts/timeline.ts";
import type { Vec } from "../question.ts";
import { usualGravity } from "./model.ts";

const none: Vec = [0, 0, 0];
const falls = (gravity: Vec): boolean => gravity.some((x) => x !== 0);
/** The settings as they are now. */
interface Time {
  subSteps: number;
  warmStart: boolean;
  gravity: Vec;
  speed: number;
}

export class Settings {
  readonly elements: HTMLElement[];
  /** The field beside the button that plays. */
  readonly speed = speedSelect();
  private readonly steps: HTMLSelectElement;
  private readonly warm: HTMLInputElement;
  private readonly falls: HTMLInputElement;
  /** The gravity that is switched on: null for the scene's own. */
  private fall: Vec | null = null;
  private readonly along: HTMLInputElement[];

  /** `onChange` gets what was changed; a gravity of null is the scene's own. */
  constructor(onChange: (of: Partial<Omit<Time, "gravity"> & { gravity: Vec | null }>) => void) {
    this.steps = h("select", { onchange: () => onChange({ subSteps: Number(this.steps.value) }) },
      ...[8, 1, 2, 4, 16].map((n) => h("option", { value: n }, String(n)))) as HTMLSelectElement;
    this.warm = h("input", { type: "checkbox", checked: true, onchange: () => onChange({ warmStart: this.warm.checked }) }) as HTMLInputElement;
    this.falls = h("input", { type: "checkbox", checked: true, onchange: () => onChange({ gravity: this.falls.checked ? this.fall : none }) }) as HTMLInputElement;
    this.along = ["X", "Y", "Z"].map((axis) => h("input", { type: "number", step: "any", class: "short", "aria-label": `Gravity along ${axis}, in m/s²`,
      title: `Gravity along ${axis}, in m/s²`, onchange: () => onChange({ gravity: this.along.map(({ value }) => Number(value)) }) }) as HTMLInputElement);
    this.speed.addEventListener("change", () => onChange({ speed: Number(this.speed.value) }));
    this.elements = [h("label", {}, "Sub-steps ", this.steps),
      h("label", { title: "Each sub-step begins with the impulses of the last one; else with none" }, this.warm, " Warm start"),
      h("span", { class: "gravity" }, h("label", {}, this.falls, " Gravity"), ...this.along)];
  }
  /** Shows the settings of a scene with a gravity of its `own`; one of the plane has none along Z. */
  show({ subSteps, warmStart, gravity, speed }: Time, own: Vec, flat: boolean): void {
    this.fall = falls(own) ? null : usualGravity;
    this.steps.value = String(subSteps);
    this.warm.checked = warmStart;
    this.falls.checked = falls(gravity);
    this.along.forEach((field, i) => (field.value = String(gravity[i])));
    this.along[2].hidden = flat;
    this.speed.value = String(speed);
  }
}
