// The handles of both stages: buttons over the drawing, so that a keyboard and a screen reader reach them.

import { h, set } from "./dom.ts";
import type { Handle } from "./drawing.ts";
import type { LabelPlaces } from "./labels.ts";
import type { Vec } from "../question.ts";

export interface Projection {
  /** The pixel of the stage at which a point is seen. */
  toScreen(p: Vec): [x: number, y: number];
  /** The point under the pixel; in space, on the plane through `near` that faces the viewer. */
  fromScreen(x: number, y: number, near: Vec): Vec;
  /** The length of a step of an arrow key. */
  step(): number;
}

const signs = { turn: "↻", size: "⤢" };
/** The sign of a handle; one that moves a body bears its name. */
const sign = (handle: Handle): string =>
  handle.sign ?? (handle.kind !== "move" ? signs[handle.kind] : handle.meaning === "a" ? "A" : handle.meaning === "b" ? "B" : "✥");

export class Handles {
  readonly element = h("div", { class: "handles" });
  private readonly buttons = new Map<string, HTMLButtonElement>();
  /** The places of the buttons: elements without a look of their own, which a browser styles in less time than a
   *  button, and where they are. */
  private readonly places = new Map<string, { element: HTMLElement; at: string }>();
  private handles: Handle[] = [];
  private readonly projection: Projection;
  private readonly onDrag: (id: string, to: Vec, done: boolean) => void;

  constructor(projection: Projection, onDrag: (id: string, to: Vec, done: boolean) => void) {
    this.projection = projection;
    this.onDrag = onDrag;
  }

  show(handles: Handle[]): void {
    this.handles = handles;
    const wanted = new Set(handles.map((x) => x.id));
    for (const id of this.buttons.keys())
      if (!wanted.has(id)) {
        this.places.get(id)!.element.remove();
        this.buttons.delete(id);
        this.places.delete(id);
      }
    for (const handle of handles) {
      let button = this.buttons.get(handle.id);
      if (!button) {
        button = this.make(handle);
        const element = h("div", { class: "place-of-handle" }, button);
        this.buttons.set(handle.id, button);
        this.places.set(handle.id, { element, at: "" });
        this.element.append(element);
      }
      set(button, "aria-label", `${handle.label} at ${handle.at.map((x) => x.toFixed(2)).join(", ")}`);
    }
    this.place();
  }

  place(): void {
    for (const handle of this.handles) {
      const [x, y] = this.projection.toScreen(handle.at);
      const there = `translate(${x}px, ${y}px)`, place = this.places.get(handle.id)!;
      if (place.at !== there) place.element.style.transform = place.at = there;
    }
  }

  /** Keeps labels off the handles. */
  keepFree(places: LabelPlaces): void {
    const half = 16; // as the style sheet has it
    for (const handle of this.handles) places.keep(this.projection.toScreen(handle.at), half);
  }

  private at(id: string): Vec {
    return this.handles.find((x) => x.id === id)?.at ?? [0, 0, 0];
  }

  private make(handle: Handle): HTMLButtonElement {
    const { id } = handle;
    const button = h(
      "button",
      { type: "button", class: `handle ${handle.kind} of-${handle.meaning}`, "data-handle": id, title: handle.label },
      sign(handle),
    ) as HTMLButtonElement;
    let grip: [number, number] | null = null;
    const target = (event: PointerEvent): Vec => {
      const frame = this.element.getBoundingClientRect();
      return this.projection.fromScreen(event.clientX - frame.left + grip![0], event.clientY - frame.top + grip![1],
        this.at(id));
    };
    button.addEventListener("pointerdown", (event) => {
      const frame = this.element.getBoundingClientRect();
      const [x, y] = this.projection.toScreen(this.at(id));
      grip = [x - (event.clientX - frame.left), y - (event.clientY - frame.top)];
      button.setPointerCapture(event.pointerId);
      button.focus();
      event.preventDefault();
      event.stopPropagation();
    });
    button.addEventListener("pointermove", (event) => grip && this.onDrag(id, target(event), false));
    const end = (event: PointerEvent): void => {
      if (!grip) return;
      const to = target(event);
      grip = null;
      this.onDrag(id, to, true);
    };
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
    button.addEventListener("keydown", (event) => {
      const by: Record<string, Vec> = {
        ArrowLeft: [-1, 0, 0], ArrowRight: [1, 0, 0], ArrowDown: [0, -1, 0], ArrowUp: [0, 1, 0],
        PageUp: [0, 0, -1], PageDown: [0, 0, 1],
      };
      const step = by[event.key];
      if (!step) return;
      event.preventDefault();
      const size = this.projection.step() * (event.shiftKey ? 0.1 : 1);
      const to = this.at(id).map((x, i) => x + step[i] * size);
      // Keys come faster than frames, after which `show` says where the handle has got to.
      this.handles = this.handles.map((x) => (x.id === id ? { ...x, at: to } : x));
      this.onDrag(id, to, true);
    });
    return button;
  }
}
