// The plane: SVG, so that it is sharp at any size, can be printed, and its text can be selected.

import { isSeen } from "./camera.ts";
import { h, set, svg } from "./dom.ts";
import type { Drawing, Handle, Look, Meaning, Stage, View } from "./drawing.ts";
import { Handles } from "./handles.ts";
import { LabelPlaces } from "./labels.ts";
import { outlines, type Outline } from "./outline.ts";
import { Pen } from "./pen.ts";
import { roundStep, scaleBar } from "./scale-bar.ts";
import { add, length, scale, sub, unit } from "./vec.ts";
import type { Vec } from "../question.ts";

export class Stage2 implements Stage, Drawing {
  readonly element = h("div", { class: "stage stage2" });
  onDrag: (id: string, to: Vec, done: boolean) => void = () => {};
  onPoint: (key: string | null) => void = () => {};
  onCamera: () => void = () => {};
  private readonly picture = svg("svg", { role: "img", tabindex: 0 });
  private readonly handles: Handles;
  private readonly observer: ResizeObserver;
  private view: View = { center: [0, 0], reach: 3 };
  private moved = false;
  private size: [number, number] = [600, 480];
  private readonly layers = Array.from({ length: 4 }, () => new Pen());
  private behind: { of: string; drawn: SVGElement[] } = { of: "", drawn: [] };
  private texts: { at: Vec; text: string; meaning: Meaning; from?: Vec }[] = [];
  /** The pixels of the points that are drawn, and their radii. */
  private dots: { at: [number, number]; radius: number }[] = [];
  /** The pixels between which wide lines are drawn. */
  private wide: [[number, number], [number, number]][] = [];
  private last: { paint: (d: Drawing) => void; handles: Handle[]; says: string } | null = null;
  private lit: string | null = null;

  constructor() {
    this.handles = new Handles(
      {
        toScreen: (p) => this.pixel(p),
        fromScreen: (x, y) => this.world(x, y),
        step: () => this.view.reach / 50,
      },
      (id, to, done) => this.onDrag(id, [to[0], to[1]], done),
    );
    this.element.append(this.picture, this.handles.element);
    this.observer = new ResizeObserver(() => {
      const frame = this.element.getBoundingClientRect();
      if (frame.width > 0) this.size = [frame.width, frame.height];
      this.redraw();
    });
    this.observer.observe(this.element);
    this.picture.addEventListener("pointerover", (event) => {
      const key = (event.target as Element).closest?.("[data-key]")?.getAttribute("data-key") ?? null;
      if (key !== this.lit) this.onPoint(key);
    });
    this.picture.addEventListener("pointerleave", () => this.lit !== null && this.onPoint(null));
    this.picture.addEventListener("keydown", (event) => this.moveCamera(event));
    this.panAndZoom();
  }

  dispose(): void {
    this.observer.disconnect();
  }

  look(view: View): void {
    this.view = { ...view };
    this.moved = false;
    this.redraw();
  }
  /** The middle of the picture, and half of its height. */
  get camera(): Vec | null {
    return this.moved ? [...this.view.center, this.view.reach] : null;
  }
  set camera(of: Vec | null) {
    if (of?.length === 3) this.see(of.slice(0, 2), of[2]);
  }
  /** Moves the camera, unless nothing could be told apart there; says whether it did. */
  private see(center: Vec, reach: number): boolean {
    if (!isSeen(center, reach)) return false;
    this.view = { center, reach };
    this.moved = true;
    this.redraw();
    return true;
  }
  private moveTo(center: Vec, reach = this.view.reach): void {
    if (this.see(center, reach)) this.onCamera();
  }

  light(key: string | null): void {
    this.lit = key;
    for (const element of this.picture.querySelectorAll("[data-key]"))
      element.classList.toggle("lit", element.getAttribute("data-key") === key);
  }

  draw(paint: (drawing: Drawing) => void, handles: Handle[], says: string): void {
    this.last = { paint, handles, says };
    this.redraw();
  }

  private unitPixels(): number {
    return Math.min(this.size[0], this.size[1] * 1.25) / (2 * this.view.reach);
  }
  private pixel(p: Vec): [number, number] {
    const s = this.unitPixels();
    return [
      this.size[0] / 2 + (p[0] - this.view.center[0]) * s,
      this.size[1] / 2 - (p[1] - this.view.center[1]) * s,
    ];
  }
  private world(x: number, y: number): Vec {
    const s = this.unitPixels();
    return [
      this.view.center[0] + (x - this.size[0] / 2) / s,
      this.view.center[1] - (y - this.size[1] / 2) / s,
    ];
  }

  private redraw(): void {
    if (!this.last) return;
    const { paint, handles, says } = this.last;
    set(this.picture, "viewBox", `0 0 ${this.size[0]} ${this.size[1]}`);
    set(this.picture, "aria-label", says);
    for (const layer of this.layers) layer.begin();
    this.texts = [];
    this.dots = [];
    this.wide = [];
    paint(this);
    this.handles.show(handles);
    this.placeTexts();
    for (const layer of this.layers) layer.end();
    const behind = this.background();
    if (behind[0].parentNode !== this.picture) this.picture.replaceChildren(...behind, ...this.layers.map((layer) => layer.element));
  }
  private placeTexts(): void {
    const places = new LabelPlaces(this.size);
    this.handles.keepFree(places);
    for (const { at, radius } of this.dots) places.keep(at, radius);
    for (const ends of this.wide) places.keepLine(...ends, 3);
    for (const { at, text, meaning, from } of this.texts) {
      const { left, bottom } = places.place(this.pixel(at), text, from && this.pixel(from));
      this.layers[3].put("text", { x: left, y: bottom - 4, class: `of-${meaning}` }, text);
    }
  }

  /** The hatches and the grid, which are made anew only when the camera or the size of the stage has changed. */
  private background(): SVGElement[] {
    const of = JSON.stringify([this.view, this.size]);
    if (this.behind.of !== of) this.behind = { of, drawn: [hatches(), this.grid()] };
    return this.behind.drawn;
  }
  private grid(): SVGElement {
    const group = svg("g", { class: "grid", "aria-hidden": "true" });
    const step = roundStep(2 * this.view.reach);
    const [left, top] = this.world(0, 0), [right, bottom] = this.world(...this.size);
    for (const n of multiples(left, right, step)) {
      const [px] = this.pixel([n * step, 0]);
      group.append(svg("line", { x1: px, x2: px, y1: 0, y2: this.size[1], class: n === 0 ? "zero" : "" }));
    }
    for (const n of multiples(bottom, top, step)) {
      const [, py] = this.pixel([0, n * step]);
      group.append(svg("line", { x1: 0, x2: this.size[0], y1: py, y2: py, class: n === 0 ? "zero" : "" }));
    }
    group.append(...scaleBar(step, step * this.unitPixels(), this.size[1] - 14));
    return group;
  }

  /** The attributes of an element that say how it looks; of the `kind` of element that its class names first. */
  private attributes(meaning: Meaning, look: Look = {}, kind = ""): { class: string; "data-key"?: string } {
    const lit = look.key !== undefined && look.key === this.lit;
    const kinds = [kind, `of-${meaning}`, look.ghost && "ghost", look.dashed && "dashed", look.wide && "wide", lit && "lit"];
    return { class: kinds.filter(Boolean).join(" "), "data-key": look.key };
  }
  private label(at: Vec, look: Look | undefined, meaning: Meaning): void {
    if (look?.label) this.text(at, look.label, meaning);
  }

  shape(body: Parameters<Drawing["shape"]>[0], meaning: Meaning, look?: Look): void {
    const found = outlines(body, this.view.reach * 8), attributes = this.attributes(meaning, look, "shape");
    const places = ({ points }: Outline): string[] => points.map((p) => this.pixel(p).map((x) => x.toFixed(2)).join(" "));
    // The points of a polygon are no style, as the path of several pieces is: a browser changes them in less time.
    if (found.length === 1 && found[0].closed) this.layers[0].put("polygon", { ...attributes, points: places(found[0]).join(" ") });
    else this.layers[0].put("path", { ...attributes, d: found.map((piece) => `M${places(piece).join("L")}${piece.closed ? "Z" : ""}`).join("") });
    if (look?.label) this.label(body.translation ?? [0, 0], look, meaning);
  }
  point(at: Vec, meaning: Meaning, look?: Look): void {
    const [cx, cy] = this.pixel(at), r = look?.wide ? 6 : 4;
    this.layers[2].put("circle", { ...this.attributes(meaning, look), cx, cy, r });
    this.dots.push({ at: [cx, cy], radius: r });
    this.label(at, look, meaning);
  }
  line(from: Vec, to: Vec, meaning: Meaning, look?: Look): void {
    const [x1, y1] = this.pixel(from), [x2, y2] = this.pixel(to);
    this.layers[1].put("line", { ...this.attributes(meaning, look), x1, y1, x2, y2 });
    if (look?.wide) this.wide.push([[x1, y1], [x2, y2]]);
    this.label(scale(add(from, to), 0.5), look, meaning);
  }
  arrow(from: Vec, to: Vec, meaning: Meaning, look?: Look): void {
    this.line(from, to, meaning, { ...look, label: undefined });
    const [x1, y1] = this.pixel(from), [x2, y2] = this.pixel(to);
    const along = sub([x2, y2], [x1, y1]);
    if (length(along) > 1) {
      const u = unit(along), n = [-u[1], u[0]], size = Math.min(10, length(along));
      const corner = (side: number): Vec => add(sub([x2, y2], scale(u, size)), scale(n, side * size * 0.4));
      const points = [[x2, y2], corner(1), corner(-1)].join(" ");
      this.layers[2].put("polygon", { ...this.attributes(meaning, look, "head"), points });
    }
    if (look?.label) this.texts.push({ at: to, text: look.label, meaning, from });
  }
  polygon(points: Vec[], meaning: Meaning, look?: Look): void {
    const list = points.map((p) => this.pixel(p).join(",")).join(" ");
    this.layers[look?.fill ? 0 : 1].put("polygon", { ...this.attributes(meaning, look, "area"), points: list });
    if (look?.label) this.label(scale(points.reduce((s, p) => add(s, p), [0, 0]), 1 / points.length), look, meaning);
  }
  text(at: Vec, text: string, meaning: Meaning): void {
    this.texts.push({ at, text, meaning });
  }

  /** Arrows push the picture about, + and − bring it nearer and further away. */
  private moveCamera(event: KeyboardEvent): void {
    const pushes: Record<string, Vec> = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] };
    const push = pushes[event.key];
    const { center, reach } = this.view;
    if (push) this.moveTo(add(center, scale(push, reach)));
    else if (event.key === "+" || event.key === "-") this.moveTo(center, reach * (event.key === "+" ? 0.9 : 1.1));
    else return;
    event.preventDefault();
  }
  private panAndZoom(): void {
    const pointers = new Map<number, [number, number]>();
    const spread = (): number => {
      const [p, q] = [...pointers.values()];
      return Math.hypot(p[0] - q[0], p[1] - q[1]);
    };
    this.picture.addEventListener("pointerdown", (event) => {
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
    });
    this.picture.addEventListener("pointermove", (event) => {
      const before = pointers.get(event.pointerId);
      if (!before) return;
      const was = pointers.size === 2 ? spread() : 0;
      pointers.set(event.pointerId, [event.clientX, event.clientY]);
      const { center: [x, y], reach } = this.view, s = this.unitPixels();
      if (pointers.size === 2) this.moveTo([x, y], (reach * was) / Math.max(1, spread()));
      else if (event.pointerType === "mouse" || pointers.size === 1)
        this.moveTo([x - (event.clientX - before[0]) / s, y + (event.clientY - before[1]) / s]);
    });
    const end = (event: PointerEvent): void => void pointers.delete(event.pointerId);
    for (const name of ["pointerup", "pointercancel", "pointerleave"])
      this.picture.addEventListener(name, end as EventListener);
    this.element.addEventListener("wheel", (event) => {
      if (!event.ctrlKey && !event.shiftKey) return; // the page scrolls
      event.preventDefault();
      this.moveTo(this.view.center, this.view.reach * Math.exp(event.deltaY / 500));
    }, { passive: false });
  }
}

/** The most lines of a grid to one side: several times as many as a picture shows of round steps. */
const mostLines = 100;
/** The whole numbers whose multiples of `step` lie between two places. They are counted, as where a step is less than
 *  the rounding of a place, adding it leads nowhere. */
function multiples(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step), count = Math.min(mostLines, Math.floor(to / step) - first + 1);
  return Array.from({ length: count > 0 ? count : 0 }, (_, i) => first + i);
}

/** The hatches of A to the left and of B to the right, so that nobody depends on colours. */
function hatches(): SVGElement {
  const made = svg("defs");
  for (const [name, turn] of [["a", -45], ["b", 45]] as const)
    made.append(
      svg("pattern",
        { id: `hatch-${name}`, width: 7, height: 7, patternUnits: "userSpaceOnUse", patternTransform: `rotate(${turn})` },
        svg("rect", { width: 7, height: 7, class: `ground-${name}` }),
        svg("line", { x1: 0, x2: 0, y1: 0, y2: 7, class: `hatch-${name}` })),
    );
  return made;
}
