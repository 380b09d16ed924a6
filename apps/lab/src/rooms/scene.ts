// The viewer and the playground: a scene whose contacts are live while a body is dragged, and which can be played.

import { button, digits, h } from "../parts/dom.ts";
import { drawer } from "../parts/drawer.ts";
import { saveFile, sizeWords } from "../parts/save.ts";
import { fold } from "../parts/fold.ts";
import { Layers } from "../parts/layers.ts";
import { Stage3 } from "../parts/stage3.ts";
import { address, cameraOf, cameraText, copy, History, parse, whenStill } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import { Scrub } from "../parts/timeline.ts";
import type { Question, Vec } from "../question.ts";
import { followersAt, type Animated, type Follower } from "../scene/animation.ts";
import { AnimationBar } from "../scene/animation-bar.ts";
import type { Captured } from "../scene/captured.ts";
import { sceneOfQuestion } from "../scene/asked.ts";
import { Catalogue } from "../scene/catalogue.ts";
import { Chooser, toggled } from "../scene/chooser.ts";
import { dragBody } from "../scene/drag.ts";
import { EventList } from "../scene/events.ts";
import { Inquiry } from "../scene/inquiry.ts";
import { sceneLayers, whenStepped } from "../scene/layers.ts";
import { materialFields } from "../scene/materials.ts";
import type { Scene, SceneBody } from "../scene/model.ts";
import { beginning, changedMaterials, isMoment, isRepeated, isScene, movedBodies, opening, packed, type Moment } from "../scene/moment.ts";
import { askPair, type AskedPair } from "../scene/pair.ts";
import { bodiesOf, colored, counted, countsOf, overlapping, pairRows, partnersOf } from "../scene/pairs.ts";
import { courseOf, crowdOf, drawOverlay, graphsOf, handlesOf, stagesOf, viewOf } from "../scene/picture.ts";
import { frame, Play } from "../scene/play.ts";
import type { Pair, Place } from "../scene/run.ts";
import { Settings } from "../scene/settings.ts";
import { Shooting, shootingButtons, type Kind, type Sight } from "../scene/shooting.ts";
import { aimsAt, type Shot } from "../scene/shots.ts";
import { explained, TraceSteps } from "../scene/trace-steps.ts";
import { Source, type Served } from "../scene/source.ts";
import type { Room } from "./room.ts";

/** The number of bodies above which contacts are drawn without their pairs, which cannot be pointed to then. */
const mostDrawn = 200;
/** A place alone: an address may hold more beside it. */
const placed = (of: Place | undefined): Place | undefined => of && { translation: of.translation, rotation: of.rotation };
/** The part of a follower that a body of a scene has. */
const shaped = (of: Pick<Follower, "translation" | "rotation" | "shape"> | undefined): Partial<SceneBody> | undefined => of && { translation: of.translation, rotation: of.rotation, shape: of.shape };
/** Called with a capture that was opened in place of a scene, and with the watched file if it is served. */
export type OnCapture = (name: string, captured: Captured, served: Served | null) => void;

export class SceneRoom implements Room {
  readonly element: HTMLElement;
  private readonly stage = new Stage3();
  private readonly play: Play;
  private readonly inquiry: Inquiry;
  private readonly shooting: Shooting;
  private readonly chooser: Chooser;
  private selected: number[] = [];
  /** The key of a scene of the list. */
  private key: string | null = null;
  /** The places of the bodies when the scene was opened, and the changes since. */
  private before: (Place & Pick<SceneBody, "material" | "shape">)[] = [];
  /** The animation and its time, with which the run begins, and the bodies that follow it then. */
  private animated: Animated | null = null;
  private followers: ReadonlyMap<number, Follower> = new Map();
  private history = new History<Moment>(beginning);
  /** The pairs that touch, in scenes that are not too large to draw them. */
  private found: Pair[] = [];
  /** The selected bodies, where they are drawn. */
  private pair: AskedPair | null = null;
  /** The answer to what was aimed at. */
  private shot: Shot | null = null;
  /** Whether somebody aimed later than they selected: the words are about that then. */
  private aimed = false;
  private draws = 0;
  /** The part that is too long for the address: without its scene it holds nothing, without its run everything else. */
  private tooLong: "scene" | "run" | null = null;
  private drawTime = 0;
  private readonly source: Source;
  private readonly events = new EventList("step");
  private readonly undoes = button("Undo", () => this.undo(), { "data-undo": true });
  private readonly redoes = button("Redo", () => this.redo(), { "data-redo": true });
  /** What became of a button that leads to nothing that is seen. */
  private readonly done = h("p", { class: "counter", "aria-live": "polite" });
  private readonly scrub = new Scrub("step", false, (step) => (this.play.stop(), this.play.goTo(step)), () => this.did(() => {}));
  private readonly pairs = new Table();
  private readonly steps = new TraceSteps(() => (this.paint(), this.write()));
  private readonly materials = h("div", { class: "choices", "data-material": true });
  private readonly plot = h("div", { class: "plot" });
  private readonly counter = h("p", { class: "counter" });
  private readonly note = h("p", { class: "intro" });
  private readonly trouble = h("p", { class: "trouble", role: "alert", hidden: true });
  private readonly layers = new Layers(sceneLayers, () => this.changed());
  private readonly still = whenStill(() => this.write());
  private readonly catalogue: Catalogue;
  private readonly animation = new AnimationBar((at) => this.animate(at), () => this.did(() => {}));
  private readonly toggle = button("Play", () => this.did(() => this.play.toggle()), { class: "accent", "data-play": true });
  private readonly settings = new Settings((changed) => this.set(changed));
  /** The part of the address about a scene that has not come yet, and the key of that scene if the list has it. */
  private expected: { key: string | null; moment: Partial<Moment>; camera: Vec | null } | null = null;

  constructor(values: Record<string, string>, onCapture: OnCapture) {
    this.source = new Source({
      onScene: (scene) => this.opened(scene), onTrouble: (text) => this.say(text),
      onCapture });
    this.play = new Play({
      onStep: () => this.show(), onTrouble: (text) => this.say(text),
      onRunning: (running) => {
        this.toggle.textContent = running ? "Pause" : "Play";
        if (running) this.animation.stop();
        if (!running) this.showSettings();
      } });
    this.catalogue = new Catalogue((scene, key) => this.opened(scene, key), () => this.source.unwatch());
    this.inquiry = new Inquiry((question) => this.askIt(question), (text) => this.say(text));
    this.shooting = new Shooting((title, words) => this.inquiry.tell(title, words));
    this.chooser = new Chooser((selected) => this.select(selected));
    this.stage.onPick = (body, sight, key) => this.pick(body, sight, bodiesOf(key));
    this.stage.onDrag = (id, to, done) => this.drag(id, to, done);
    this.pairs.onPoint = this.inquiry.table.onPoint = (key) => this.stage.light(key);
    this.stage.onCamera = () => this.still.call();
    this.element = this.page();
    this.begun(values);
  }
  private begun(values: Record<string, string>): void {
    const moment = parse<Partial<Moment>>(values.at, {}, isMoment), camera = cameraOf(values.view);
    const key = values.file || values.q || values.s ? null : (values.scene ?? "shapes");
    this.expected = { key, moment, camera };
    this.open(this.play.scene); // until the one of the address has come
    if (values.file) return this.source.watch(values.file);
    try {
      const scene = values.q ? sceneOfQuestion(JSON.parse(values.q) as Question) : parse<Scene | null>(values.s, null, isScene);
      if (scene) this.opened(scene);
      else this.catalogue.open(values.scene ?? "shapes");
    } catch (error) {
      this.catalogue.open("shapes");
      this.say((error as Error).message);
    }
  }
  /** Opens a scene that has come, at the moment in the address if it is the one that the address is about. */
  private opened(scene: Scene, key: string | null = null): void {
    const expected = this.expected?.key === key ? this.expected : null;
    this.expected = null;
    this.open(scene, key, expected && { ...opening(scene), ...expected.moment });
    if (expected) this.stage.camera = expected.camera;
    this.remember();
  }

  /** Opens files that were dropped. */
  openFiles(files: File[]): void {
    this.expected = null;
    void this.source.chosen(files);
  }
  dispose(): void {
    this.still.cancel();
    this.source.unwatch();
    this.steps.stop();
    this.animation.stop();
    this.play.dispose();
    this.stage.dispose();
  }
  /** For the tests. */
  get shown(): { bodies: number; pairs: number; frames: number; poses: number[]; deepest: number; draws: number; times: { step: number; draw: number } } {
    const { scene, run, steps, depth, stepTime } = this.play;
    return { bodies: scene.bodies.length, pairs: run.contacts().filter((p) => p.overlap).length, frames: steps,
      poses: Array.from(run.poses()), deepest: depth[steps - 1] ?? 0, draws: this.draws, times: { step: stepTime, draw: this.drawTime } };
  }

  /** Does what the library may refuse: the moment is recorded, or the reason is said. */
  private tried(what: () => void): void {
    try {
      what();
      this.say(null);
      this.remember();
    } catch (error) {
      this.say((error as Error).message);
    }
  }

  // --- The state that the address and undo hold ---

  private get moment(): Moment {
    const { scene, begun, subSteps, warmStart, pulled } = this.play, materials = begun?.materials ?? scene.bodies.map(({ material }) => material);
    const { steps, inputs } = this.play.goal ?? { steps: this.play.steps, inputs: this.play.inputs.upTo(this.play.steps) };
    return { places: movedBodies(scene, this.before.map((one, i) => this.followers.get(i) ?? one)), animated: this.animated, selected: this.selected, subSteps, warmStart, gravity: begun ? begun.gravity : pulled,
      materials: changedMaterials(materials, this.before.map(({ material }) => material)), steps, inputs,
      aim: this.shooting.aim, aimed: this.aimed || this.shooting.aim === null, ...this.steps.shown, speed: this.play.speed, layers: this.layers.switched };
  }
  /** The settings that stay from one scene to the next. */
  private get kept(): Partial<Moment> {
    const { subSteps, warmStart, pulled: gravity, speed } = this.play;
    return { subSteps, warmStart, gravity, speed, layers: this.layers.switched };
  }
  /** Records the moment after everything that somebody did, and where they paused. */
  private remember(): void {
    this.history.push(this.moment);
    this.write();
  }
  /** Does something to time, and records where that leads; its address is written once time stands still. */
  private did(what: () => void): void {
    what();
    if (this.play.running) return;
    this.history.push(this.moment);
    this.still.call();
  }
  /** Writes the address of the page. */
  private write(): void {
    const { scene } = this.play, values: Record<string, string> = this.key ? { scene: this.key } : {};
    this.undoes.disabled = !this.history.hasPast;
    this.redoes.disabled = !this.history.hasFuture;
    this.tooLong = null;
    if (this.source.served) values.file = this.source.served;
    else if (!this.key) {
      const text = packed({ ...scene, bodies: scene.bodies.map((body, i) => ({ ...body, ...this.before[i] })) });
      if (text) values.s = text;
      else this.tooLong = "scene";
    }
    if (this.tooLong === null) this.writeMoment(values);
    const { camera } = this.stage;
    if (camera && this.tooLong !== "scene") values.view = cameraText(camera);
    history.replaceState(null, "", address("/scene", values));
  }
  /** Adds the moment to the values of an address, without its run if that is too long. */
  private writeMoment(values: Record<string, string>): void {
    const { moment } = this, first = opening(this.play.scene), held = isRepeated(moment) ? moment : { ...moment, steps: 0, inputs: [] };
    if (held !== moment) this.tooLong = "run";
    // The moment is spread over the first one, so that both have their keys in one order.
    if (JSON.stringify({ ...first, ...held }) !== JSON.stringify(first)) values.at = JSON.stringify(held);
  }
  /** Takes a moment over, but for its drawing. */
  private take(moment: Moment): void {
    const { scene } = this.play;
    this.play.subSteps = moment.subSteps;
    this.play.warmStart = moment.warmStart;
    this.play.pulled = moment.gravity;
    this.setAnimated(moment.animated);
    for (const [i, body] of scene.bodies.entries()) Object.assign(body, this.before[i], shaped(this.followers.get(i)), placed(moment.places[i]), moment.materials[i] && { material: moment.materials[i] });
    this.takeLooks(moment);
  }
  /** Takes over what does not move anything. */
  private takeLooks(moment: Moment): void {
    const { scene } = this.play;
    this.play.speed = moment.speed;
    this.layers.switched = moment.layers;
    this.steps.shown = moment;
    this.selected = moment.selected.filter((i) => i >= 0 && i < scene.bodies.length);
    this.shooting.aim = aimsAt(moment.aim, scene) ? moment.aim : null;
    this.aimed = moment.aimed;
    this.showSettings();
  }
  private restore(moment: Moment | null): void {
    if (!moment) return;
    const stays = this.play.run.played && moment.steps >= this.play.first && moment.steps <= this.play.last && this.sameRun(moment);
    if (stays) {
      this.takeLooks(moment);
      this.play.goTo(moment.steps);
    } else {
      this.take(moment);
      this.play.repeat(moment.steps, moment.inputs);
      this.show();
    }
    this.write();
  }
  /** Whether the run that is played came by the moment. */
  private sameRun(moment: Moment): boolean {
    const of = ({ places, animated, subSteps, warmStart, gravity, materials }: Moment): string => JSON.stringify([places, animated, subSteps, warmStart, gravity, materials]);
    return of(moment) === of(this.moment) && JSON.stringify(this.play.inputs.upTo(moment.steps)) === JSON.stringify(moment.inputs);
  }
  /** Stops time, and records how far it had gone. */
  private halt(): void {
    if (this.play.running) this.history.push(this.moment);
    this.play.stop();
  }
  undo(): void {
    this.halt();
    this.restore(this.history.undo());
  }
  redo(): void {
    this.halt();
    this.restore(this.history.redo());
  }
  /** Begins the scene anew, with other settings if these are given. */
  private begin(settings: Partial<Moment> = {}): void {
    this.halt();
    const { scene, pulled: gravity } = this.play, materials = changedMaterials(scene.bodies.map(({ material }) => material), this.before.map(({ material }) => material));
    this.take({ ...this.moment, gravity, materials, ...settings });
    this.play.begin();
    this.show();
    this.remember();
  }
  /** Called after layers were switched. */
  private changed(): void {
    this.show();
    this.remember();
  }
  /** Sets how time runs. Sub-steps and warm starts need a new simulation, the rest counts from the next step on. */
  private set({ subSteps, warmStart, gravity, speed = this.play.speed }: Partial<Moment>): void {
    if (subSteps !== undefined) return this.begin({ subSteps });
    if (warmStart !== undefined) return this.begin({ warmStart });
    this.tried(() => {
      this.play.speed = speed;
      if (gravity !== undefined) this.play.setGravity(gravity);
    });
    this.showSettings();
  }

  // --- Scenes ---

  private open(scene: Scene, key: string | null = null, moment: Moment | null = null): void {
    this.key = key;
    this.trouble.hidden = true;
    this.shooting.forget();
    this.before = scene.bodies.map(({ translation, rotation, material, shape }) => ({ translation, rotation, material, shape }));
    try {
      this.play.open(scene);
      const first = moment ?? { ...opening(scene), ...this.kept };
      this.take(first);
      if (Object.keys(first.places).length > 0 || first.animated || first.steps > 0 || first.inputs.length > 0) this.play.repeat(first.steps, first.inputs);
    } catch (error) {
      this.say(`${scene.name}: ${(error as Error).message}`);
      this.before = this.selected = [];
    }
    this.history = new History(this.moment);
    this.catalogue.show(key, this.play.scene.name);
    this.put();
    this.show();
  }
  /** Puts the bodies of the scene onto the stage and into the lists. */
  private put(): void {
    const { scene, run } = this.play, view = viewOf(run, scene);
    this.stage.look(view);
    this.stage.crowd.set(...crowdOf(scene, run.flat, view.reach));
    this.chooser.set(scene.bodies);
    this.animation.set(scene.animations ?? []);
    this.note.textContent = scene.note ?? "";
    this.showSettings();
  }
  private askIt(question: Question): void {
    this.source.unwatch();
    this.open(sceneOfQuestion(question));
    this.remember();
  }
  private say(text: string | null): void {
    this.trouble.textContent = text;
    this.trouble.hidden = text === null;
    if (text !== null) this.trouble.scrollIntoView({ block: "nearest" });
  }

  // --- Animations ---

  /** Shows another moment of an animation; a run that was played begins anew there. What only the animation before
   *  moved is at rest again. */
  private animate(at: Animated): void {
    if (this.play.run.played) return this.begin({ animated: at });
    const left = [...this.followers.keys()];
    this.setAnimated(at);
    const places = new Map([...left.map((i) => [i, this.before[i]] as const), ...this.followers]);
    this.play.run.putAll(places);
    for (const [i, place] of places) Object.assign(this.play.scene.bodies[i], shaped(place));
    this.show();
  }
  /** Takes an animation and its time over, but for its drawing. */
  private setAnimated(at: Animated | null): void {
    const { animations = [] } = this.play.scene, animation = animations[at?.number ?? 0];
    this.animated = animation ? at : null;
    this.followers = animation && at ? followersAt(animation, at.time, this.before) : new Map();
    this.play.follows = animation ? { animation, from: at?.time ?? 0 } : null;
  }

  // --- Pointer ---

  private pick(body: number | null, sight: Sight, pair: number[]): void {
    if (!this.shooting.waits) return this.select(pair.length > 0 ? pair : toggled(this.selected, body));
    try {
      const { run, scene } = this.play;
      if (!this.shooting.click(sight, run, scene, this.selected[0])) return;
      this.aimed = true;
      this.show();
      this.remember();
    } catch (error) {
      this.say((error as Error).message); // two clicks at one place are no direction
    }
  }
  private select(selected: number[]): void {
    this.selected = selected;
    this.aimed = false;
    this.show();
    this.remember();
  }
  private drag(id: string, to: Vec, done: boolean): void {
    const [i] = this.selected;
    const handle = handlesOf(this.play, i, this.stage.seen).find((one) => one.id === id);
    if (!handle || !dragBody(this.play, i, handle, to, done)) return;
    this.show();
    if (done) this.remember();
  }

  // --- The present state ---

  private get few(): boolean {
    return this.play.scene.bodies.length <= mostDrawn;
  }
  private show(): void {
    const start = performance.now(), { run, scene, running, steps, first, last } = this.play;
    this.stage.crowd.move(run.poses(), undefined, new Map([...this.followers].map(([i, { growth }]) => [i, growth])));
    this.animation.show({ number: this.animated?.number ?? 0, time: (this.animated?.time ?? 0) + steps * frame }, this.play.speed);
    this.chooser.show(this.selected);
    // Copying thousands of pairs out of the module takes longer than a step; their points alone take a tenth of one.
    this.found = this.few ? run.contacts() : [];
    const asleep = this.layers.has("sleep") ? this.play.run.sleeping() : new Set<number>();
    this.stage.crowd.paint(colored(this.selected, asleep));
    this.stage.crowd.outline(overlapping(this.layers.has("contacts") ? this.found : [], (i) => scene.bodies[i]?.moves, this.stage.seen));
    this.paint();
    this.scrub.show(steps, first, last, last > 0 ? `${steps} / ${last}` : "");
    this.drawTime = performance.now() - start;
    if (!(running || this.animation.running) || this.draws % (this.few ? 6 : 30) === 0) this.tell();
  }
  private paint(): void {
    const asleep = this.layers.has("sleep") && this.few ? this.play.run.sleeping() : new Set<number>();
    const { run, scene } = this.play;
    this.pair = askPair(run, this.selected, scene.question);
    this.shot = this.shoot();
    this.steps.take(...explained(this.pair, this.shooting.aim, this.shot, this.selected));
    const { play, found, selected, pair, few } = this, { seen } = this.stage, { name, bodies } = play.scene;
    const overlay = { found, cloud: few ? null : run.cloud(), selected, pair, shot: this.shot, asleep, joints: this.layers.has("joints") ? run.jointLines() : [],
      place: (body: number) => run.place(body).translation, draws: (layer: string) => this.layers.has(layer) && (few || layer !== "broad"), seen };
    this.draws++;
    this.stage.hasGrid = this.layers.has("grid");
    this.stage.crowd.group.visible = this.layers.has("bodies");
    this.stage.draw((d) => {
      drawOverlay(d, play, overlay);
      this.steps.draw(d, seen);
    }, handlesOf(play, selected[0], seen),
      `${name}: ${bodies.length} bodies${few ? `, ${found.length} pairs in contact` : ""}.`);
  }
  /** The answer to what was aimed at; of what the library refuses, as an address may hold it, nothing is left. */
  private shoot(): Shot | null {
    try {
      return this.shooting.shot(this.play.run, this.play.scene);
    } catch (error) {
      this.shooting.forget();
      this.say((error as Error).message);
      return null;
    }
  }
  private copyAddress(): void {
    this.write();
    copy(location.href).then(() => (this.done.textContent = this.tooLong ? `Copied; the ${this.tooLong} is too long for an address, and is left out.` : "Copied."),
      (error: Error) => this.say(error.message));
  }
  /** Saves the run up to the present step as a file that the lab and `graze replay` play. */
  private async save(): Promise<void> {
    this.play.stop();
    if (this.play.steps === 0) return void (this.done.textContent = "Nothing was played yet: a capture has a frame for each step.");
    this.done.textContent = "The run is made once more …";
    try {
      const frames = await this.play.captured(), name = `${this.key ?? "scene"}.capture`;
      saveFile(name, frames);
      const { steps } = this.play, bytes = frames.reduce((sum, { length }) => sum + length, 0);
      this.done.textContent = `${name}: ${steps} ${steps === 1 ? "step" : "steps"}, ${digits(steps * frame, 3)} s, ${sizeWords(bytes)}.`;
    } catch (error) {
      this.done.textContent = "";
      this.say((error as Error).message);
    }
  }
  private showSettings(): void {
    const { subSteps, warmStart, gravity, own, speed, run } = this.play;
    this.settings.show({ subSteps, warmStart, gravity, speed }, own, run.flat);
  }
  private setMaterial(body: number, material: NonNullable<SceneBody["material"]>): void {
    this.tried(() => {
      if (this.play.run.played) this.play.act({ kind: "material", body, material });
      else this.play.run.setMaterial(body, material);
    });
  }
  private tell(): void {
    const { scene, run, stepTime, stages } = this.play, found = this.few ? this.found : run.contacts();
    this.counter.textContent = counted(scene.bodies.length, countsOf(found)) +
      (run.played ? ` · step ${digits(stepTime, 3)} ms${stages ? ` (${stagesOf(stages)})` : ""} · drawing ${digits(this.drawTime, 3)} ms` : "");
    this.pairs.show(pairRows(found, "Pairs in contact", (i) => scene.bodies[i]?.name ?? String(i), this.selected, (bodies) => this.select(bodies)));
    this.plot.replaceChildren(...graphsOf(courseOf(this.play)));
    if (!this.play.running) this.showSettings(); // else a field is not overwritten while somebody writes in it
    const [i] = this.selected;
    this.materials.replaceChildren(...(i === undefined ? [] : materialFields(scene.bodies[i], (material) => this.setMaterial(i, material))));
    this.events.show(this.play.steps, (step) => this.play.eventsOf(step), (body) => scene.bodies[body]?.name ?? "the world");
    this.inquiry.show({ run, bodies: scene.bodies, joints: scene.joints, selected: this.selected, pair: this.pair, asleep: run.played ? run.sleeping() : null, when: run.played && this.play.steps > 0 ? whenStepped : "where they are",
      partners: (body) => partnersOf(body, found, (other) => scene.bodies[other].name) });
    if (this.shot && (this.aimed || i === undefined)) this.inquiry.answer(this.shot);
  }

  private page(): HTMLElement {
    const takeAim = (kind: Kind): void => this.shooting.takeAim(kind, this.play.run, this.selected[0]);
    const { left, side, handle } = drawer([this.chooser.tree], [
      fold("properties", "Properties", this.inquiry.info, this.steps.element, this.materials, this.inquiry.table.element, this.inquiry.element),
      fold("graphs", "Graphs", this.plot), fold("pairs", "Pairs", this.pairs.element), fold("events", "Events", this.events.element)]);
    return h("article", { class: "lesson viewer" },
      h("header", {}, h("h1", {}, "Viewer and playground"), this.note),
      h("div", { class: "choices" },
        this.catalogue.element, ...this.source.elements,
        ...shootingButtons(takeAim),
        ...this.settings.elements),
      this.trouble,
      h("div", { class: "board workbench" }, left,
        h("div", { class: "picture" }, this.stage.element,
          fold("time", "Time", h("div", { class: "timeline", role: "group", "aria-label": "Time" },
            button("Step back", () => this.did(() => this.play.back()), { "data-back": true }), this.toggle,
            button("One step", () => this.did(() => this.play.step()), { "data-step": true }), button("Start again", () => this.begin()), this.settings.speed,
            this.scrub.slider, this.scrub.where),
            this.animation.element, this.counter), handle, this.layers.element,
          h("p", { class: "actions" }, this.undoes, this.redoes,
            button("Copy permalink", () => this.copyAddress(), { "data-permalink": true }),
            button("Save the run as a capture", () => void this.save(), { "data-save": true })), this.done),
        side));
  }
}
