// A capture: a run of a world or a simulation, frame by frame, forward, back and scrubbed; each frame can be queried as
// a scene can.

import { button, h, vector } from "../parts/dom.ts";
import type { Drawing, Meaning } from "../parts/drawing.ts";
import { featureWords } from "../parts/features.ts";
import { drawer } from "../parts/drawer.ts";
import { fold } from "../parts/fold.ts";
import { Layers } from "../parts/layers.ts";
import { Stage3 } from "../parts/stage3.ts";
import { address, cameraOf, cameraText, parse, whenStill } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import { Timeline } from "../parts/timeline.ts";
import { bodiesAt, type Captured, type CapturedFrame } from "../scene/captured.ts";
import { Chooser, toggled } from "../scene/chooser.ts";
import { EventList } from "../scene/events.ts";
import { Inquiry } from "../scene/inquiry.ts";
import { captureLayers, whenStepped } from "../scene/layers.ts";
import type { Scene, SceneBody, Tie } from "../scene/model.ts";
import { firstShown, isShown, type Shown } from "../scene/moment.ts";
import { askPair, drawPair, type AskedPair } from "../scene/pair.ts";
import { bodiesOf, colored, counted, keyOf, overlapping, pairRows, partnersOf } from "../scene/pairs.ts";
import { drawOutcome, graphsOf } from "../scene/picture.ts";
import { readCapture } from "../scene/replay.ts";
import { Run } from "../scene/run.ts";
import { Shooting, shootingButtons, type Kind, type Sight } from "../scene/shooting.ts";
import type { Shot } from "../scene/shots.ts";
import { opener, type Served } from "../scene/source.ts";
import { explained, TraceSteps } from "../scene/trace-steps.ts";
import type { Room } from "./room.ts";

/** The frame that is shown, the selected bodies, and the settings of playing and drawing. */
interface Moment extends Shown {
  frame: number;
}
const start: Moment = { ...firstShown, frame: 0 };
const isMoment = (value: unknown): boolean => isShown(value) && Number.isInteger((value as Partial<Moment> | null)?.frame ?? start.frame);
/** The selected bodies of a frame in a world of their own. */
interface Asked {
  run: Run;
  bodies: SceneBody[];
  numbers: number[];
  pair: AskedPair | null;
}
/** All bodies of a frame that a question has words for, in a world of their own, to be shot at. */
interface Whole {
  run: Run;
  scene: Scene;
  numbers: number[];
}
/** Where the capture lies if it is served, and the moment that the address holds. */
export interface Origin {
  served: Served | null;
  at?: string;
  /** The camera in the address. */
  view?: string;
}

export class CaptureRoom implements Room {
  readonly element: HTMLElement;
  private readonly stage = new Stage3();
  private readonly timeline = new Timeline((frame) => this.go(frame), { word: "frame", spoken: false }, 1000 / 60, () => this.write());
  private readonly layers = new Layers(captureLayers, () => this.show());
  private readonly still = whenStill(() => this.write());
  private readonly pairs = new Table();
  private readonly found = new Table();
  private readonly events = new EventList("frame");
  private readonly plot = h("div", { class: "plot" });
  private readonly counter = h("p", { class: "counter", "aria-live": "polite" });
  private readonly trouble = h("p", { class: "trouble", role: "alert", hidden: true });
  private readonly inquiry: Inquiry;
  private readonly chooser: Chooser;
  private readonly intro = h("p", { class: "intro" });
  private captured: Captured;
  private readonly origin: Origin;
  private frame = 0;
  private selected: number[] = [];
  private asked: Asked | null = null;
  private whole: Whole | null = null;
  private readonly steps = new TraceSteps(() => (this.paint(), this.still.call()));
  private readonly shooting: Shooting;
  /** The answer to what was aimed at in this frame. */
  private shot: Shot | null = null;

  /** `onScene` gets a frame as a scene, `onFiles` the files that are chosen to be opened in place of the capture. */
  constructor(name: string, captured: Captured, origin: Origin, onScene: (scene: Scene) => void, onFiles: (files: File[]) => void) {
    this.captured = captured;
    this.origin = origin;
    this.inquiry = new Inquiry((question) => (location.hash = address("/scene", { q: JSON.stringify(question) })), (text) => this.say(text));
    this.shooting = new Shooting((title, words) => this.inquiry.tell(title, words));
    this.chooser = new Chooser((selected) => this.select(selected));
    this.pairs.onPoint = this.found.onPoint = this.inquiry.table.onPoint = (key) => this.stage.light(key);
    this.stage.onPick = (body, sight, key) => this.pick(body, sight, bodiesOf(key));
    this.put();
    this.stage.look({ center: captured.center, reach: captured.size * 0.6, flat: captured.report.plane });
    const { left, side, handle } = drawer([this.chooser.tree], [
      fold("properties", "Properties", this.inquiry.info, this.steps.element, this.found.element, this.inquiry.table.element, this.inquiry.element),
      fold("graphs", "Graphs", this.plot), fold("pairs", "Pairs", this.pairs.element), fold("events", "Events", this.events.element)]);
    this.element = h("article", { class: "lesson viewer" },
      h("header", {}, h("h1", {}, name), this.intro),
      h("div", { class: "choices" }, ...opener("Open another file", onFiles), ...shootingButtons((kind) => this.takeAim(kind))),
      this.trouble,
      h("div", { class: "board workbench" }, left,
        h("div", { class: "picture" }, this.stage.element, fold("time", "Time", this.timeline.element, this.counter), handle, this.layers.element,
          h("p", { class: "actions" }, button("Open this frame as a scene", () => this.open(onScene)))),
        side));
    const moment = { ...start, ...parse<Partial<Moment>>(origin.at, {}, isMoment) };
    this.layers.switched = moment.layers;
    this.steps.shown = moment;
    this.timeline.speed = moment.speed;
    this.stage.camera = cameraOf(origin.view);
    this.stage.onCamera = () => this.still.call();
    this.selected = moment.selected;
    this.goNear(moment.frame);
    const watched = origin.served?.watched;
    watched?.tell({ onTrouble: (text) => this.say(text), onFile: async (file) => {
      const written = await readCapture(await file.arrayBuffer());
      if (!watched.ended) this.again(written);
    } });
  }
  dispose(): void {
    this.origin.served?.watched.end();
    this.still.cancel();
    this.timeline.stop();
    this.steps.stop();
    this.asked?.run.dispose();
    this.leave();
    this.stage.dispose();
  }
  /** For the tests. */
  get shown(): { frame: number; frames: number; bodies: number; pairs: number; selected: number[] } {
    const { frames } = this.captured, { there, counts } = this.now;
    return { frame: this.frame, frames: frames.length, bodies: there.size, pairs: counts.pairs, selected: this.selected };
  }

  private get now(): CapturedFrame {
    return this.captured.frames[this.frame];
  }
  /** The bodies that sleep in this frame, as far as they are drawn as such. */
  private get asleep(): ReadonlySet<number> {
    return (this.layers.has("sleep") && this.now.motion?.asleep) || new Set();
  }
  /** Puts the capture onto the stage and into the lists. */
  private put(): void {
    const { report, scalar, bodies, frames } = this.captured;
    const kind = `${report.simulation ? "simulation" : "world"}${report.plane ? " of the plane" : ""} in ${scalar}`;
    const end = report.difference
      ? `From frame ${report.difference.frame} on it comes to something else: call ${report.difference.call}, ${report.difference.what}.`
      : report.cut ? "It ends within a frame, which is left out." : "It comes to the same bits.";
    this.intro.textContent = `A ${kind}: ${frames.length} frames, played again. ${end}`;
    const usual = bodies.map((body): Meaning => (body.trigger ? "trigger" : body.moves ? "a" : "out"));
    this.stage.crowd.set(bodies.map((body, i) => ({ key: String(i), make: () => body.solid, flat: body.flat })), usual);
    this.chooser.set(bodies);
  }
  /** Shows a file that has been written once more, at the frame where it was shown. */
  private again(captured: Captured): void {
    this.captured = captured;
    this.put();
    this.goNear(this.frame);
  }
  /** Goes to the frame with this number, or the nearest that there is, with those selected bodies that it has. */
  private goNear(frame: number): void {
    const { bodies, frames } = this.captured;
    this.selected = this.selected.filter((i) => i >= 0 && i < bodies.length);
    this.go(Math.max(0, Math.min(frame, frames.length - 1)));
  }
  private say(text: string | null): void {
    this.trouble.textContent = text;
    this.trouble.hidden = text === null;
    if (text !== null) this.trouble.scrollIntoView({ block: "nearest" });
  }
  private select(selected: number[]): void {
    this.selected = selected;
    this.show();
  }
  private go(frame: number): void {
    this.frame = frame;
    this.leave();
    this.show();
  }

  // --- Rays, casts and measures, whose bodies are numbered as those of the frame's world ---

  private get everything(): Whole {
    if (this.whole) return this.whole;
    const numbers = [...this.now.there].filter((i) => this.captured.bodies[i].shape), scene = this.sceneOf("the frame", numbers);
    return (this.whole = { run: new Run(scene), scene, numbers });
  }
  /** Of another frame nothing that was shot is true any more. */
  private leave(): void {
    this.shooting.forget();
    this.shot = null;
    this.whole?.run.dispose();
    this.whole = null;
  }
  private thrown({ numbers }: Whole): number | undefined {
    const at = numbers.indexOf(this.selected[0]);
    return at < 0 ? undefined : at;
  }
  private takeAim(kind: Kind): void {
    this.timeline.stop();
    try {
      this.shooting.takeAim(kind, this.everything.run, this.thrown(this.everything));
    } catch (error) {
      this.say((error as Error).message);
    }
  }
  private pick(body: number | null, sight: Sight, pair: number[]): void {
    if (!this.shooting.waits) return this.select(pair.length > 0 ? pair : toggled(this.selected, body));
    try {
      const { everything } = this;
      if (!this.shooting.click(sight, everything.run, everything.scene, this.thrown(everything))) return;
      this.shot = this.shooting.shot(everything.run, everything.scene);
      this.inquiry.answer(this.shot!);
      this.paint();
    } catch (error) {
      this.say((error as Error).message); // two clicks at one place are no direction
    }
  }
  private sceneOf(name: string, numbers: number[]): Scene {
    return { name, bodies: bodiesAt(this.captured, this.frame, numbers), ...(this.captured.report.plane ? { dimension: 2 as const } : {}) };
  }
  /** What the address of a served capture holds; another is nowhere to be found again. */
  private write(): void {
    const { served } = this.origin, { frame, selected } = this, { camera } = this.stage;
    if (!served) return;
    const at = JSON.stringify({ frame, selected, ...this.steps.shown, speed: this.timeline.speed, layers: this.layers.switched });
    history.replaceState(null, "", address("/scene", { file: served.path, at, ...(camera ? { view: cameraText(camera) } : {}) }));
  }
  private open(onScene: (scene: Scene) => void): void {
    try {
      onScene(this.sceneOf(`frame ${this.frame + 1} of ${this.captured.frames.length}`, [...this.now.there]));
    } catch (error) {
      this.say((error as Error).message);
    }
  }

  /** Makes the selected bodies of this frame a world that can be queried. */
  private ask(): void {
    this.asked?.run.dispose();
    this.asked = null;
    this.say(null);
    const numbers = this.selected.filter((i) => this.now.there.has(i));
    try {
      const scene = this.sceneOf("selected", numbers), run = new Run(scene);
      this.asked = { bodies: scene.bodies, numbers, run, pair: askPair(run, numbers.map((_, k) => k)) };
    } catch (error) {
      this.say((error as Error).message); // a shape that the protocol cannot express
    }
  }
  private show(): void {
    const { frames } = this.captured, { poses, there, pairs } = this.now;
    this.ask();
    this.timeline.show(this.frame, frames.length);
    this.chooser.show(this.selected);
    this.stage.hasGrid = this.layers.has("grid");
    this.stage.crowd.group.visible = this.layers.has("bodies");
    this.stage.crowd.move(poses, there);
    this.stage.crowd.paint(colored(this.selected, this.asleep));
    this.stage.crowd.outline(overlapping(this.layers.has("contacts") ? pairs : [], (i) => this.captured.bodies[i].moves, this.stage.seen));
    this.paint();
    this.counter.textContent = counted(there.size, this.now.counts);
    this.pairs.show(pairRows(pairs, "Pairs in this frame", (i) => this.captured.bodies[i].name, this.selected, (bodies) => this.select(bodies)));
    this.plot.replaceChildren(...graphsOf({ energy: frames.flatMap(({ motion }) => (motion ? [motion.energy] : [])), depth: frames.map((x) => x.deepest), at: this.frame }));
    // Frames are counted from one, as beside the slider.
    this.events.show(this.frame + 1, (number) => frames[number - 1]?.events, (i) => this.captured.bodies[i].name);
    this.tell();
    this.still.call();
  }
  private paint(): void {
    const { there, counts: { pairs } } = this.now;
    this.steps.take(...explained(this.asked?.pair ?? null, this.shooting.aim, this.shot, this.selected));
    this.stage.draw((d) => this.draw(d), [], `Frame ${this.frame + 1} of ${this.captured.frames.length}: ${there.size} bodies, ${pairs} pairs.`);
  }
  private draw(d: Drawing): void {
    const { pairs, cloud, poses, motion } = this.now;
    drawOutcome(d, { found: pairs, cloud, joints: motion?.joints ?? [], asleep: this.asleep, place: (body) => Array.from(poses.subarray(7 * body, 7 * body + 3)) },
      { selected: this.selected, draws: (layer) => this.layers.has(layer), seen: this.stage.seen });
    if (this.shot && this.layers.has("shots")) this.shot.draw(d, this.stage.seen);
    this.steps.draw(d, this.stage.seen);
    if (!this.asked) return;
    const { run, numbers, pair: selected } = this.asked;
    if (selected && this.layers.has("pair")) drawPair(d, run, selected);
    numbers.forEach((_, k) => d.text(run.place(k).translation, k ? "B" : "A", k ? "b" : "made"));
  }
  /** What the simulation did with some of the bodies, which have their places among them for numbers. */
  private motionOf(numbers: number[]): { asleep: ReadonlySet<number> | null; joints?: Tie[] } {
    const { motion } = this.now, at = (body: number | null): number | null => (body === null ? null : numbers.indexOf(body));
    if (!motion) return { asleep: null };
    return { asleep: new Set([...numbers.keys()].filter((k) => motion.asleep.has(numbers[k]))), joints: motion.ties.map((tie) => ({ ...tie, a: at(tie.a), b: at(tie.b) })) };
  }
  /** Shows the answers about the selected bodies where they are, and those that the run itself found. */
  private tell(): void {
    const { asked } = this;
    const name = (i: number): string => this.captured.bodies[i].name;
    this.inquiry.show(asked && { ...asked, ...this.motionOf(asked.numbers), when: this.captured.report.simulation ? whenStepped : "where they are", selected: asked.numbers.map((_, k) => k), partners: (k) => partnersOf(asked.numbers[k], this.now.pairs, name) });
    const [first, other] = this.selected, pair = this.now.pairs.find((p) => this.selected.length === 2 && [p.a, p.b].every((i) => this.selected.includes(i)));
    const turned = pair && pair.a !== first && pair.b !== other;
    const names = turned ? [other, first] : [first, other];
    this.found.show(pair && {
      caption: `Found by the run, A is ${this.captured.bodies[names[0]].name}`, columns: ["features", "distance", "impulse"],
      rows: pair.manifolds.flatMap((m) => m.points).map((p) => ({
        cells: [featureWords(p.feature, this.captured.report.plane ? 2 : 3), p.distance, vector(p.impulse, 3)], key: keyOf(pair) })),
    });
  }
}
