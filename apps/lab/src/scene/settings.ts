// The settings of time in a scene, as fields.

import { h } from "../parts/dom.ts";
import { speedSelect } from "../parts/timeline.ts";
import type { Moment } from "./moment.ts";

type Time = Pick<Moment, "subSteps" | "gravity" | "speed">;

export class Settings {
  readonly elements: HTMLElement[];
  /** The field beside the button that plays. */
  readonly speed = speedSelect();
  private readonly steps: HTMLSelectElement;
  private readonly falls: HTMLInputElement;

  constructor(onChange: (of: Partial<Time>) => void) {
    this.steps = h("select", { onchange: () => onChange({ subSteps: Number(this.steps.value) }) },
      ...[8, 1, 2, 4, 16].map((n) => h("option", { value: n }, String(n)))) as HTMLSelectElement;
    this.falls = h("input", { type: "checkbox", checked: true, onchange: () => onChange({ gravity: this.falls.checked }) }) as HTMLInputElement;
    this.speed.addEventListener("change", () => onChange({ speed: Number(this.speed.value) }));
    this.elements = [h("label", {}, "Sub-steps ", this.steps), h("label", {}, this.falls, " Gravity")];
  }
  show({ subSteps, gravity, speed }: Time): void {
    this.steps.value = String(subSteps);
    this.falls.checked = gravity;
    this.speed.value = String(speed);
  }
}
