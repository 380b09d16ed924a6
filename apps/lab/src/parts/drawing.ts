// The canvas of a lesson: the same words in the plane (stage2) and in space (stage3). Colours are named by what they
// mean, never by their value, so that both themes and every lesson agree.

import type { Body, Vec } from "../question.ts";

/** a, b: the two bodies. touch: contacts and overlaps. axis: normals and axes. out: ruled out. made: built by an
 *  algorithm. trigger: bodies that only report contacts. asleep: bodies that rest until something wakes them. ink:
 *  neutral. */
export type Meaning = "a" | "b" | "touch" | "axis" | "out" | "made" | "trigger" | "asleep" | "ink";

export interface Look {
  label?: string;
  /** Drawn thinner and pale. */
  ghost?: boolean;
  dashed?: boolean;
  /** In space: without its edges. */
  bare?: boolean;
  /** In space: all that a shape of many points is made of, as a text that names it in place of its measures. */
  made?: string;
  wide?: boolean;
  /** In space: of a point of many, half as wide as usual, and hidden by what is before it. */
  small?: boolean;
  /** Lights up with the rows of the table that have the key. */
  key?: string;
  /** Lies below everything else. */
  fill?: boolean;
}

export interface Drawing {
  shape(body: Body, meaning: Meaning, look?: Look): void;
  point(at: Vec, meaning: Meaning, look?: Look): void;
  line(from: Vec, to: Vec, meaning: Meaning, look?: Look): void;
  arrow(from: Vec, to: Vec, meaning: Meaning, look?: Look): void;
  /** A polygon of the plane, a flat face in space. */
  polygon(points: Vec[], meaning: Meaning, look?: Look): void;
  text(at: Vec, text: string, meaning: Meaning): void;
}

/** Something that can be dragged: by pointer, touch, or the arrow keys once it has the focus. */
export interface Handle {
  id: string;
  label: string;
  kind: "move" | "turn" | "size";
  meaning: Meaning;
  at: Vec;
  /** The sign that stands on it in place of that of its kind. */
  sign?: string;
  /** Only in the steps that name it: in others nothing that is drawn follows it. */
  named?: boolean;
}

export interface View {
  center: Vec;
  /** Half of the height that is seen at least. */
  reach: number;
  /** The place of the camera in space, seen from the centre. */
  from?: Vec;
  /** Whether the scene lies in the plane z = 0, is looked at from its front, and never turned. */
  flat?: boolean;
}

export interface Stage {
  readonly element: HTMLElement;
  /** Draws anew. Handles are kept as elements, so that a drag and the focus go on. */
  draw(paint: (drawing: Drawing) => void, handles: Handle[], says: string): void;
  onDrag: (id: string, to: Vec, done: boolean) => void;
  onPoint: (key: string | null) => void;
  light(key: string | null): void;
  look(view: View): void;
  /** The camera where somebody moved it, as numbers for the address; null where it is that of the view. */
  camera: Vec | null;
  /** Called after somebody moved the camera. */
  onCamera: () => void;
  dispose(): void;
}
