// A lesson: data, and for each step a drawing. CONTRIBUTING.md explains how to add one.

import { answered } from "../graze.ts";
import type { Bits, Choice } from "../parts/choices.ts";
import type { Programs } from "../parts/code.ts";
import { digits } from "../parts/dom.ts";
import type { Drawing, Handle, Meaning, View } from "../parts/drawing.ts";
import type { Graph } from "../parts/graph.ts";
import type { Numbers } from "../parts/table.ts";
import { drawDistance, drawManifold, type DrawnManifold } from "../parts/answers.ts";
import { add, rotate, quatBetween, quatMultiply, sub, unit, length } from "../parts/vec.ts";
import { sizeOf, withBody, type Body, type Question, type State, type Vec } from "../question.ts";

export interface Step {
  title: string;
  /** The words of the step, at most 120. */
  text: string;
  /** Formulas as text of parts/math.ts: with letters, then with the present numbers. */
  formula?: string[];
  numbers?: Numbers;
  graph?: Graph;
  /** The drawing in words, for those who do not see it. */
  says: string;
  /** The names of those `named` handles that this step has. */
  handles?: string[];
  draw(drawing: Drawing): void;
}

/** A step that is made when it is shown first: while another step is shown, a drag pays nothing for its queries. */
export const later = (make: () => Step): Step => new LaterStep(make);
class LaterStep implements Step {
  private readonly make: () => Step;
  private made?: Step;

  constructor(make: () => Step) {
    this.make = make;
  }
  private get step(): Step { return (this.made ??= this.make()); }
  get title(): string { return this.step.title; }
  get text(): string { return this.step.text; }
  get formula(): string[] | undefined { return this.step.formula; }
  get numbers(): Numbers | undefined { return this.step.numbers; }
  get graph(): Graph | undefined { return this.step.graph; }
  get says(): string { return this.step.says; }
  get handles(): string[] | undefined { return this.step.handles; }
  draw(drawing: Drawing): void { this.step.draw(drawing); }
}

export interface Example {
  label: string;
  /** A hint at what to look at. */
  note: string;
  state: State;
}

export interface Code {
  programs: Programs;
  /** The numbers and truths that each of them prints, in their order, for the test that runs them. */
  prints(): (number | boolean)[];
}

export interface Lesson {
  /** The name in the address. */
  id: string;
  number: number;
  title: string;
  /** The question that the lesson answers. */
  question: string;
  /** Two or three sentences before the first step. */
  intro: string;
  /** The dimension; where a function gives it, each change of its result brings another stage. */
  dimension: 2 | 3 | ((state: State) => 2 | 3);
  /** The view; where a function gives it, each change of its result moves the camera. */
  view: View | ((state: State) => View);
  start: State;
  choices?: Choice[];
  bits?: Bits[];
  handles(state: State): Handle[];
  /** The state after the handle was dragged to a point of the world. */
  drag(state: State, id: string, to: Vec): State;
  steps(state: State): Step[];
  tryThis: Example[];
  wrong: Example[];
  /** The question of "copy as a question" and "in code"; default: the state's. None where the protocol has no such
   *  query. */
  asks?(state: State): Question | undefined;
  /** The programs of "In code" where the lesson's question is none of the protocol; default: those of the question. */
  code?(state: State): Code;
  sources: string[];
}

// --- Handles that most lessons have ---

const bodyName = { a: "A", b: "B" };
export type Which = "a" | "b";

export const moveHandle = (state: State, which: Which): Handle => ({
  id: `move-${which}`, label: `Move ${bodyName[which]}`, kind: "move", meaning: which,
  at: state.q[which]?.translation ?? (state.q.dimension === 2 ? [0, 0] : [0, 0, 0]),
});

/** The handle that turns a body, at `arm` in the body's frame. */
export const turnHandle = (state: State, which: Which, arm: Vec): Handle => {
  const body = state.q[which]!;
  return {
    id: `turn-${which}`, label: `Turn ${bodyName[which]}`, kind: "turn", meaning: which,
    at: add(rotate(body.rotation, arm), body.translation ?? arm.map(() => 0)),
  };
};

/** The corner of a box that changes its size. */
export const sizeHandle = (state: State, which: Which): Handle => {
  const body = state.q[which]!;
  const corner = sizeOf(body.shape).map((x, i) => (i === 0 ? -x : x) / 2);
  return {
    id: `size-${which}`, label: `Size of ${bodyName[which]}`, kind: "size", meaning: which,
    at: add(rotate(body.rotation, corner), body.translation ?? corner.map(() => 0)),
  };
};

const tidy = (v: Vec): Vec => v.map((x) => Number(x.toPrecision(12)));

/** The state after a drag of one of the handles above. `arms` are those of `turnHandle`. */
export function dragBody(state: State, id: string, to: Vec, arms: Partial<Record<Which, Vec>> = {}): State {
  const [what, which] = id.split("-") as [string, Which];
  return withBody(state, which, (body) => {
    const center = body.translation ?? to.map(() => 0);
    if (what === "move") body.translation = tidy(to);
    else if (what === "turn") turnTo(body, arms[which] ?? [1, 0, 0], sub(to, center));
    else if (what === "size" && body.shape.type === "box") {
      const local = rotate(back(body.rotation), sub(to, center));
      body.shape = { ...body.shape, box: { size: tidy(local.map((x) => Math.max(0.1, 2 * Math.abs(x)))) } };
    }
  });
}
function back(rotation: Body["rotation"]): Body["rotation"] {
  if (rotation === undefined || typeof rotation === "number") return -(rotation ?? 0);
  return [-rotation[0], -rotation[1], -rotation[2], rotation[3]];
}
function turnTo(body: Body, arm: Vec, direction: Vec): void {
  if (length(direction) < 1e-9) return;
  if (direction.length === 2) {
    const angle = Math.atan2(direction[1], direction[0]) - Math.atan2(arm[1], arm[0]);
    body.rotation = Number(angle.toPrecision(12));
    return;
  }
  const now = (body.rotation as Vec | undefined) ?? [0, 0, 0, 1];
  body.rotation = tidy(unit(quatMultiply(quatBetween(rotate(now, arm), direction), now)));
}

/** The two bodies of a question; their handles bear their names. */
export function drawBodies(drawing: Drawing, q: Question, ghost = false): void {
  for (const which of ["a", "b"] as const)
    if (q[which]) drawing.shape(q[which]!, which as Meaning, { ghost });
}
/** The contact of two bodies: the point of either and the way between them, and the normal from a manifold's middle. */
export function drawContacts(drawing: Drawing, manifolds: DrawnManifold[]): void {
  for (const manifold of manifolds) {
    manifold.points.forEach((p, i) => drawDistance(drawing, p, { look: { key: `point-${i}` } }));
    drawManifold(drawing, manifold, { look: { wide: true }, points: (i) => ({ wide: true, key: `point-${i}` }), label: "n" });
  }
}

/** The height of a point along a unit vector: the scalar product, as the library measures the point's distance from the
 *  plane (in the plane: the line) through the origin across the vector. */
export function along(u: Vec, p: Vec): number {
  const flat = p.length === 2;
  const body: Body = { shape: { type: "plane" }, rotation: flat ? Math.atan2(-u[0], u[1]) : quatBetween([0, 1, 0], u) };
  return answered({ query: "closest", ...(flat ? { dimension: 2 as const } : {}), a: body, point: p }).distance!;
}
/** The numbers of the formula r = h·|n·e| + ... for the half shadow of a box on an axis. */
export function radiusWorked(name: string, body: Body, n: Vec, radius: number): string {
  const parts = sizeOf(body.shape).map((size, i, all) => {
    const far = Math.abs(along(n, rotate(body.rotation, all.map((_, k) => (k === i ? 1 : 0)))));
    return `${digits(size / 2, 4)} * ${digits(far < 1e-15 ? 0 : far, 4)}`;
  });
  return `${name} = ${parts.join(" + ")} = ${digits(radius, 5)}`;
}
/** A number among a state's choices; `usual` where an address has something else there. */
export function numberOf({ choice }: State, key: string, usual: number): number {
  const value = choice?.[key];
  return typeof value === "number" && Number.isFinite(value) ? value : usual;
}
export const dragTo = (x: number): number => Number(x.toPrecision(12));
