// The drawing of a scene: its bodies together, and on top of them contacts, shots, and bodies that are held or
// selected.

import { digits } from "../parts/dom.ts";
import type { Looks } from "../parts/crowd.ts";
import type { Drawing, Handle, Meaning, View } from "../parts/drawing.ts";
import { drawGraph } from "../parts/graph.ts";
import { solidOf } from "../parts/solid.ts";
import { add, length, rotate, scale, sub } from "../parts/vec.ts";
import type { Vec } from "../question.ts";
import { placesIn } from "./asked.ts";
import { axes } from "./drag.ts";
import type { Scene } from "./model.ts";
import { drawCloud, drawFound, drawPair, type AskedPair, type Contacts } from "./pair.ts";
import type { Play } from "./play.ts";
import { reachOf, type JointLine, type Pair, type Run, type Stages } from "./run.ts";
import type { Shot } from "./shots.ts";

/** A view of everything. */
function whole(run: Run, scene: Scene): View {
  let lower: Vec = [Infinity, Infinity, Infinity], upper: Vec = [-Infinity, -Infinity, -Infinity];
  for (const [i, body] of scene.bodies.entries()) {
    if (body.shape.type === "plane") continue;
    const bounds = run.bounds(i, true);
    lower = lower.map((x, k) => Math.min(x, bounds.lower[k]));
    upper = upper.map((x, k) => Math.max(x, bounds.upper[k]));
  }
  for (const place of scene.question ? placesIn(scene.question) : []) {
    lower = lower.map((x, k) => Math.min(x, place[k]));
    upper = upper.map((x, k) => Math.max(x, place[k]));
  }
  if (!lower.every(Number.isFinite)) return { center: [0, 0, 0], reach: 3 };
  return { center: scale(add(lower, upper), 0.5), reach: Math.max(1e-6, length(sub(upper, lower)) * 0.47) };
}
/** The view of the stage when the scene is opened. */
export const viewOf = (run: Run, scene: Scene): View => ({ ...(scene.view ?? whole(run, scene)), flat: run.flat });

/** The bodies of a scene for the crowd, by shape, and the meanings of their colours. */
export function crowdOf({ bodies }: Scene, flat: boolean, reach: number): [Looks[], Meaning[]] {
  return [
    bodies.map(({ shape, trigger = false, clear = shape.type === "plane" || trigger }) => ({ key: `${clear}${JSON.stringify(shape)}`, make: () => solidOf(shape, flat, reach), flat: clear })),
    bodies.map((b) => (b.trigger ? "trigger" : b.moves ? "a" : "out"))];
}
/** The number of bodies above which those that sleep have their colour alone. */
const mostSigned = 40;
/** The things that a step came to: pairs that touch, lines of joints, and bodies that sleep, with the place of each. */
export interface Outcome {
  found: Pair[];
  /** In place of the points of pairs where there are too many of these: places and distances, as `cloudOf` gives them. */
  cloud: Float32Array | null;
  joints: JointLine[];
  asleep: ReadonlySet<number>;
  place: (body: number) => Vec;
}
/** Draws the outcome of a step of a simulation, which is played or was captured. */
export function drawOutcome(d: Drawing, { found, cloud, joints, asleep, place }: Outcome, drawn: Contacts): void {
  if (!cloud) drawFound(d, found, drawn);
  else if (drawn.draws("contacts")) drawCloud(d, cloud);
  if (drawn.draws("joints")) for (const { from, to, gap } of joints) d.line(from, to, gap ? "touch" : "ink", { wide: gap });
  if (drawn.draws("sleep") && asleep.size <= mostSigned) for (const body of asleep) d.text(place(body), "z", "ink");
}
/** The things that are drawn on top of the bodies of a scene. */
export interface Overlay extends Outcome, Contacts {
  /** The facts about two selected bodies. */
  pair: AskedPair | null;
  shot: Shot | null;
}
export function drawOverlay(d: Drawing, play: Play, overlay: Overlay): void {
  const { run, pull } = play, { selected, pair, shot, draws, seen } = overlay;
  drawOutcome(d, overlay, overlay);
  if (draws("broad")) run.drawBroadPhase((from, to, leaf) => d.line(from, to, leaf ? "ink" : "out", { ghost: !leaf }));
  const [first, other] = selected;
  for (const { id, at } of handlesOf(play, first, seen)) if (axes[id]) d.line(run.place(first).translation, at, "made", { ghost: true });
  if (pair && draws("pair")) drawPair(d, run, pair);
  if (other !== undefined) d.text(run.place(other).translation, "B", "b");
  if (pull) d.line(run.place(pull.body).translation, pull.to, "made", { wide: true });
  if (shot && draws("shots")) shot.draw(d, seen);
}
/** The handles of the first selected body: it is moved freely and along the axes, and turned while it stands still. */
export function handlesOf({ run, scene, pull, running }: Play, body: number | undefined, seen: number): Handle[] {
  if (body === undefined) return [];
  const { translation, rotation } = run.place(body), { name, shape } = scene.bodies[body], from = pull?.to ?? translation;
  const reach = shape.type === "plane" ? 1 : Math.min(seen, reachOf(run.bounds(body)) * 1.2 + seen / 20);
  const turn: Handle = { id: "turn", label: `Turn ${name}`, kind: "turn", meaning: "made", at: add(translation, scale(rotate(rotation, [1, 0, 0]), reach)) };
  // Beyond the handle that turns the body, which may lie on an axis, there is room for another.
  const along = Object.entries(axes).slice(0, run.flat ? 2 : 3).map(([id, axis]): Handle =>
    ({ id, label: `Move ${name} along ${id}`, kind: "move", meaning: "made", sign: id, at: add(from, scale(axis, reach + seen / 5)) }));
  return [{ id: "move", label: `Move ${name}`, kind: "move", meaning: "made", sign: "A", at: from }, ...along, ...(running ? [] : [turn])];
}
/** The time of a step by its parts: "collide 1.2, prepare 0.1, solve 2". */
export function stagesOf({ collideMs, prepareMs, solveMs, continuousMs }: Stages): string {
  const parts: [string, number][] = [["collide", collideMs], ["prepare", prepareMs], ["solve", solveMs], ["continuous", continuousMs]];
  return parts.filter(([, ms]) => ms > 0).map(([name, ms]) => `${name} ${digits(ms, 2)}`).join(", ");
}
/** Values of a run after each of its steps, and the place among them of the one that is shown. */
export interface Course {
  energy: number[];
  depth: number[];
  at: number;
}
/** The last five seconds of what is played, or those about the step that is shown. */
export function courseOf({ energy, depth, steps, last }: Play): Course {
  const from = Math.max(0, Math.min(last - 300, steps - 150)), tail = (v: number[]): number[] => v.slice(from, from + 300);
  return { energy: tail(energy), depth: tail(depth), at: Math.max(0, steps - 1 - from) };
}
/** Graphs of energy, where there is one, and of the deepest penetration. */
export function graphsOf({ energy, depth, at }: Course): Node[] {
  const graph = (caption: string, values: number[], meaning: Meaning, shown: number): Node[] =>
    values.length > 1 ? [drawGraph({ caption, at, series: [{ name: digits(values[at], shown), meaning, values }] })] : [];
  return [...graph("energy", energy, "made", 4), ...graph("deepest penetration", depth, "touch", 3)];
}
