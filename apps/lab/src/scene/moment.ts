// The state of the viewer in the address and in undo: the places of bodies, the selected ones, and how time runs.

import { speeds } from "../parts/timeline.ts";
import type { Vec } from "../question.ts";
import { areAnimations, type Animated } from "./animation.ts";
import { asksMore } from "./asked.ts";
import { isPlace, isVector } from "./checks.ts";
import { areInputs, type Input } from "./inputs.ts";
import type { Scene, SceneBody } from "./model.ts";
import type { Place } from "./run.ts";
import { isAim, type Aim } from "./shots.ts";

/** The questions whose answer is explained. */
const explained = ["overlap", "distance", "contacts", "cast", "raycast", "closest", "response"] as const;
export type Explained = (typeof explained)[number];
/** What scenes and captures have in common. */
export interface Shown {
  selected: number[];
  /** What is explained of the selected bodies, and the step of it that is drawn: -1 for none. */
  explained: Explained;
  traceStep: number;
  /** How many times as fast as usual it plays. */
  speed: number;
  /** The layers that somebody has switched. */
  layers: string[];
}
type Material = NonNullable<SceneBody["material"]>;
export interface Moment extends Shown {
  /** The places of the bodies that do not stand where the scene has them, by number. */
  places: Record<number, Place>;
  /** The animation and its time, with which the run began; null for the first one's beginning. */
  animated: Animated | null;
  subSteps: number;
  warmStart: boolean;
  /** The gravity that somebody set, with which the run began; null for the scene's own. */
  gravity: Vec | null;
  /** The materials that somebody set before it began, by number. */
  materials: Record<number, Material>;
  /** The number of steps that were made, and what was done in them. */
  steps: number;
  inputs: Input[];
  /** What was shot or measured last, and whether nothing was selected since: the words are about it then. */
  aim: Aim | null;
  aimed: boolean;
}

export const firstShown: Shown = { selected: [], explained: "distance", traceStep: -1, speed: 1, layers: [] };
export const beginning: Moment = { ...firstShown, places: {}, animated: null, subSteps: 8, warmStart: true, gravity: null, materials: {}, steps: 0, inputs: [], aim: null, aimed: true };
/** The moment at which a scene is opened: one that was made of a question answers it. */
export function opening({ question, bodies }: Scene): Moment {
  if (!question) return beginning;
  const asked = explained.find((one) => one === question.query) ?? beginning.explained;
  return { ...beginning, explained: asked, ...(asksMore(question) ? { aim: { kind: "question" } } : { selected: bodies.map((_, i) => i) }) };
}

/** Whether a value of an address, where it has members of `Shown`, has them with the right types. */
export function isShown(value: unknown): boolean {
  const { selected, speed, layers, ...trace } = { ...firstShown, ...(value as Partial<Shown> | null) };
  return Array.isArray(selected) && selected.length <= 2 && selected.every(Number.isInteger) && speeds.includes(speed) &&
    Array.isArray(layers) && layers.every((layer) => typeof layer === "string") &&
    explained.includes(trace.explained) && Number.isInteger(trace.traceStep) && trace.traceStep >= -1;
}
/** The number of steps of a run that an address may ask to be repeated: ten minutes. */
const mostSteps = 36000;
/** Whether a value of an address is one of a scene's moment, likewise. */
export function isMoment(value: unknown): boolean {
  const { places, animated, subSteps, warmStart, gravity, materials, steps, inputs, aim, aimed } = { ...beginning, ...(value as Partial<Moment> | null) };
  return isShown(value) && typeof places === "object" && places !== null && Object.values(places).every(isPlace) &&
    (animated === null || (Number.isInteger(animated.number) && animated.number >= 0 && Number.isFinite(animated.time) && animated.time >= 0)) &&
    [1, 2, 4, 8, 16].includes(subSteps) && typeof warmStart === "boolean" && (gravity === null || isVector(gravity)) && isAim(aim) && typeof aimed === "boolean" &&
    typeof materials === "object" && materials !== null && Object.values(materials).every((one) => typeof one === "object") &&
    Number.isInteger(steps) && steps >= 0 && steps <= mostSteps && areInputs(inputs);
}

/** The moved bodies of a scene that began as `before`. */
export function movedBodies(scene: Scene, before: Place[]): Record<number, Place> {
  const same = (a: Vec, b: Vec): boolean => a.every((x, k) => x === b[k]);
  return Object.fromEntries(scene.bodies.map(({ translation, rotation }, i): [number, Place] => [i, { translation, rotation }])
    .filter(([i, { translation, rotation }]) => !same(translation, before[i].translation) || !same(rotation, before[i].rotation)));
}

/** The bodies whose material is another than at first. */
export const changedMaterials = (materials: (Material | undefined)[], before: (Material | undefined)[]): Record<number, Material> =>
  Object.fromEntries([...materials.entries()].filter(([i, now]) => JSON.stringify(now) !== JSON.stringify(before[i])).map(([i, now]) => [i, now ?? {}]));

/** The lengths of the longest scene and the longest list of inputs that an address takes. */
const longest = 6000, longestInputs = 60000;
/** Whether an address takes the run of a moment. */
export const isRepeated = ({ steps, inputs }: Moment): boolean => steps <= mostSteps && JSON.stringify(inputs).length <= longestInputs;
/** A scene as the value of an address, if it is that short. */
export function packed(scene: Scene): string | null {
  const text = JSON.stringify(scene);
  return text.length <= longest ? text : null;
}
/** Whether a value of an address is a scene, as far as `Run` does not refuse it by itself. */
export function isScene(value: unknown): boolean {
  const { name, bodies, question, animations = [] } = (value ?? {}) as Partial<Scene>;
  const asked = (which: "a" | "b"): boolean => typeof (question?.[which] ?? {}) === "object";
  return typeof name === "string" && Array.isArray(bodies) && (question === undefined || (asked("a") && asked("b") && bodies.length > 0)) &&
    bodies.every((b) => typeof b?.name === "string" && typeof b.shape?.type === "string" && isPlace(b)) &&
    areAnimations(animations, bodies.length);
}
