// The viewer and the playground: a scene whose contacts are live while a body is dragged, and which can be played.

import { ask, graze, line } from "../graze.ts";
import { digits, h, vector } from "../parts/dom.ts";
import type { Drawing, Handle, Meaning } from "../parts/drawing.ts";
import { featureWords } from "../parts/features.ts";
import { drawGraph } from "../parts/graph.ts";
import { solidOf } from "../parts/solid.ts";
import { Stage3 } from "../parts/stage3.ts";
import { address, History, parse } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import { add, length, quatBetween, quatMultiply, rotate, scale, sub, unit } from "../parts/vec.ts";
import type { Question, Vec } from "../question.ts";
import { readCapture, type Captured } from "../scene/captured.ts";
import type { Scene } from "../scene/model.ts";
import { kindOf, openFile, sceneOfQuestion } from "../scene/open.ts";
import { drawFeature, lessonsOf } from "../scene/pair.ts";
import { beginning, isMoment, isScene, movedBodies, packed, type Moment } from "../scene/moment.ts";
import { propertiesOf } from "../scene/properties.ts";
import { reachOf, Run, type Pair, type Place } from "../scene/run.ts";
import { castBody, drawShot, shootRay, type Shot } from "../scene/shots.ts";
import { scenes } from "../scene/scenes.ts";
import { WatchedFile } from "../scene/watched.ts";
import type { Room } from "./room.ts";

const frame = 1 / 60;
/** Of larger scenes the contacts are counted and not drawn. */
const mostDrawn = 200;
/** Ten seconds of states to step back to; fewer of large scenes. */
const mostStates = (bodies: number): number => (bodies > 300 ? 120 : 600);
/** Bodies that are deeper in each other than that are marked: this part of what is seen. */
const visible = 1 / 4000;
const deepest = (pair: Pair): number => Math.min(...pair.manifolds.flatMap((m) => m.points.map((x) => x.distance)));
const button = (label: string, act: () => void, more: Record<string, unknown> = {}): HTMLButtonElement =>
  h("button", { type: "button", onclick: act, ...more }, label) as HTMLButtonElement;

export class SceneRoom implements Room {
  readonly element: HTMLElement;
  private readonly stage = new Stage3();
  private scene!: Scene;
  private run!: Run;
  private states: graze.State[] = [];
  private energy: number[] = [];
  private depth: number[] = [];
  private selected: number[] = [];
  private pull: { body: number; to: Vec } | null = null;
  /** What the next click is for; in the plane a ray has a click for its origin, too. */
  private aim: { kind: "ray" | "cast"; from?: Vec } | null = null;
  private shot: Shot | null = null;
  private broadPhase = false;
  /** The key of a scene of the list. */
  private key: string | null = null;
  /** Where the bodies stood when the scene was opened, and what was done since. */
  private before: Place[] = [];
  private history = new History<Moment>(beginning);
  /** By corners, what the two selected bodies touch with at each point of the table. */
  private features: [Vec[], Vec[]][] = [];
  /** A file that is looked after, and where it is. */
  private watched: WatchedFile | null = null;
  private served: string | null = null;
  private running = 0;
  private subSteps = 8;
  private heavy = true;
  private times = { step: 0, draw: 0 };
  private readonly onCapture: (name: string, captured: Captured) => void;
  private readonly table = new Table();
  private readonly pairs = new Table();
  private readonly info = h("div", { class: "words", "aria-live": "polite" });
  private readonly materials = h("div", { class: "choices", "data-material": true });
  private readonly plot = h("div", { class: "plot" });
  private readonly counter = h("p", { class: "counter" });
  private readonly note = h("p", { class: "intro" });
  private readonly trouble = h("p", { class: "trouble", role: "alert", hidden: true });
  private readonly list: HTMLSelectElement;
  private readonly play: HTMLButtonElement;
  private readonly steps = h("select", { onchange: () => { this.subSteps = Number(this.steps.value); this.begin(); this.remember(); } },
    ...[8, 1, 2, 4, 16].map((n) => h("option", { value: n }, String(n)))) as HTMLSelectElement;
  private readonly falls = h("input", { type: "checkbox", checked: true,
    onchange: () => { this.heavy = this.falls.checked; this.run.setGravity(this.gravity); this.remember(); } }) as HTMLInputElement;
  private readonly chosen = [0, 1].map((k) =>
    h("select", { "aria-label": k ? "Another body" : "A body", "data-body": k, onchange: () => this.chooseBodies() }) as HTMLSelectElement);
  private readonly asked = h("textarea", { rows: 3, spellcheck: "false", "aria-label": "A question of the protocol" }) as HTMLTextAreaElement;

  /** `onCapture` gets a capture that was opened in place of a scene. */
  constructor(values: Record<string, string>, onCapture: (name: string, captured: Captured) => void) {
    this.onCapture = onCapture;
    this.stage.onPick = (body, ray) => this.pick(body, ray);
    this.stage.onDrag = (id, to, done) => this.drag(id, to, done);
    this.pairs.onPoint = this.table.onPoint = (key) => this.stage.light(key);
    this.list = h("select", { "aria-label": "Scene", onchange: () => this.choose(this.list.value) },
      ...Object.entries(scenes).map(([key, make]) => h("option", { value: key }, make().name))) as HTMLSelectElement;
    this.play = button("Play", () => this.toggle(), { class: "accent", "data-play": true });
    this.element = this.page();
    this.element.addEventListener("dragover", (event) => event.preventDefault());
    this.element.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.chosenFiles([...(event.dataTransfer?.files ?? [])]);
    });
    if (!this.openAsked(values)) this.openListed(values.scene && scenes[values.scene] ? values.scene : "shapes");
    const moment = parse<Moment>(values.at, beginning, isMoment);
    if (moment !== beginning) this.restore(moment);
    this.history = new History(moment);
    if (!values.file) return;
    this.served = values.file;
    this.watched = new WatchedFile(values.file, { onFile: (file) => this.file(file), onTrouble: (text) => this.say(text) });
  }
  /** A question, or a scene of its own, that the address holds. */
  private openAsked({ q, s }: Record<string, string>): boolean {
    try {
      if (q) this.open(sceneOfQuestion(JSON.parse(q) as Question));
      const scene = parse<Scene | null>(s, null, isScene);
      if (!q && scene) this.open(scene);
      return Boolean(q || scene);
    } catch (error) {
      this.say((error as Error).message);
      return false;
    }
  }
  private openListed(key: string): void {
    this.open(scenes[key](), key);
  }
  /** Another scene was chosen: the file is not looked after any more. */
  private unwatch(): void {
    this.watched?.end();
    this.watched = this.served = null;
  }

  dispose(): void {
    this.unwatch();
    this.close();
    this.stage.dispose();
  }
  /** For the tests. */
  get shown(): { bodies: number; pairs: number; frames: number; poses: number[]; deepest: number; times: { step: number; draw: number } } {
    return { bodies: this.scene.bodies.length, pairs: this.run.contacts().filter((p) => p.overlap).length, frames: this.energy.length,
      poses: Array.from(this.run.poses()), deepest: this.depth.at(-1) ?? 0, times: this.times };
  }

  // --- Scenes ---

  private close(): void {
    this.stop();
    this.forget();
    this.run?.dispose();
  }
  private forget(): void {
    for (const state of this.states) state.dispose();
    this.states = [];
    this.energy = [];
    this.depth = [];
  }
  private choose(key: string): void {
    if (!scenes[key]) return;
    this.unwatch();
    this.openListed(key);
    this.remember();
  }

  // --- What the address and undo hold ---

  private get moment(): Moment {
    return { places: movedBodies(this.scene, this.before), selected: this.selected, subSteps: this.subSteps, gravity: this.heavy };
  }
  /** After everything that somebody did, but for playing. */
  private remember(): void {
    const { moment } = this, values: Record<string, string> = this.key ? { scene: this.key } : {};
    this.history.push(moment);
    if (this.served) values.file = this.served;
    else if (!this.key) {
      const text = packed({ ...this.scene, bodies: this.scene.bodies.map((body, i) => ({ ...body, ...this.before[i] })) });
      if (!text) return;
      values.s = text;
    }
    if (JSON.stringify(moment) !== JSON.stringify(beginning)) values.at = JSON.stringify(moment);
    history.replaceState(null, "", address("/scene", values));
  }
  private restore(moment: Moment | null): void {
    if (!moment) return;
    const count = this.scene.bodies.length;
    this.subSteps = moment.subSteps;
    this.heavy = moment.gravity;
    this.controls();
    for (const [i, body] of this.scene.bodies.entries()) Object.assign(body, moment.places[i] ?? this.before[i]);
    this.begin();
    this.selected = moment.selected.filter((i) => i >= 0 && i < count);
    this.show();
  }
  undo(): void {
    this.restore(this.history.undo());
  }
  redo(): void {
    this.restore(this.history.redo());
  }

  private open(scene: Scene, key: string | null = null): void {
    this.close();
    this.key = key;
    this.trouble.hidden = true;
    this.selected = [];
    this.pull = this.aim = this.shot = null;
    try {
      this.run = new Run(scene);
      this.scene = scene;
    } catch (error) {
      this.say(`${scene.name}: ${(error as Error).message}`);
      this.scene = { name: "empty", bodies: [] };
      this.run = new Run(this.scene);
    }
    this.before = this.scene.bodies.map(({ translation, rotation }) => ({ translation, rotation }));
    this.history = new History({ ...beginning, subSteps: this.subSteps, gravity: this.heavy });
    this.list.querySelector("[data-file]")?.remove();
    if (!key) this.list.append(h("option", { value: "", "data-file": true }, this.scene.name));
    this.list.value = key ?? "";
    const { bodies } = this.scene, { flat } = this.run, whole = this.whole(), view = { ...(this.scene.view ?? whole), flat };
    this.stage.look(view);
    this.stage.crowd.set(bodies.map(({ shape, trigger }) => ({ key: `${trigger ?? false}${JSON.stringify(shape)}`, make: () => solidOf(shape, flat, view.reach), flat: shape.type === "plane" || (trigger ?? false) })), bodies.map((b): Meaning => (b.trigger ? "trigger" : b.moves ? "a" : "out")));
    for (const [k, select] of this.chosen.entries())
      select.replaceChildren(h("option", { value: "" }, k ? "no other body" : "no body"), ...bodies.map((b, i) => h("option", { value: i }, b.name)));
    this.note.textContent = this.scene.note ?? "";
    this.show();
  }
  /** The scene from its beginning, where its bodies were put. */
  private begin(): void {
    this.stop();
    this.forget();
    this.run.dispose();
    this.run = new Run(this.scene);
    this.show();
  }
  /** A view of everything. */
  private whole(): { center: Vec; reach: number } {
    let lower: Vec = [Infinity, Infinity, Infinity], upper: Vec = [-Infinity, -Infinity, -Infinity];
    for (const [i, body] of this.scene.bodies.entries()) {
      if (body.shape.type === "plane") continue;
      const bounds = this.run.bounds(i, true);
      lower = lower.map((x, k) => Math.min(x, bounds.lower[k]));
      upper = upper.map((x, k) => Math.max(x, bounds.upper[k]));
    }
    if (!lower.every(Number.isFinite)) return { center: [0, 0, 0], reach: 3 };
    return { center: scale(add(lower, upper), 0.5), reach: Math.max(1e-6, length(sub(upper, lower)) * 0.55) };
  }
  /** A scene, and with it the files of its buffers. */
  private async chosenFiles(files: File[]): Promise<void> {
    const scene = files.find((file) => kindOf(file) !== "bin") ?? files[0];
    if (!scene) return;
    this.unwatch();
    await this.file(scene, files);
  }
  private async file(file: File, beside: File[] = []): Promise<void> {
    try {
      if (kindOf(file) === "capture") this.onCapture(file.name, await readCapture(await file.arrayBuffer()));
      else this.open(await openFile(file, beside)), this.remember();
    } catch (error) {
      this.say((error as Error).message);
    }
  }
  private say(text: string): void {
    this.trouble.textContent = text;
    this.trouble.hidden = false;
  }

  // --- Time ---

  private toggle(): void {
    if (this.running) return this.stop();
    this.play.textContent = "Pause";
    const tick = (): void => {
      this.running = requestAnimationFrame(tick);
      this.step();
    };
    this.running = requestAnimationFrame(tick);
  }
  private stop(): void {
    cancelAnimationFrame(this.running);
    this.running = 0;
    this.play.textContent = "Play";
  }
  private get gravity(): Vec {
    return this.heavy ? (this.scene.gravity ?? [0, -9.81, 0]) : [0, 0, 0];
  }
  private step(): void {
    try {
      this.run.play(this.subSteps, this.gravity);
      this.states.push(this.run.save());
      if (this.states.length > mostStates(this.scene.bodies.length)) this.states.shift()!.dispose();
      if (this.pull) this.run.pull(this.pull.body, this.pull.to);
      const start = performance.now();
      const { energy, deepest: depth } = this.run.step(frame);
      this.times.step = performance.now() - start;
      this.energy.push(energy);
      this.depth.push(depth);
      this.show();
    } catch (error) {
      this.stop();
      this.say((error as Error).message);
    }
  }
  private back(): void {
    this.stop();
    const state = this.states.pop();
    if (!state) return;
    this.run.restore(state);
    state.dispose();
    this.energy.pop();
    this.depth.pop();
    this.show();
  }

  // --- What is true now ---

  /** The question about the two selected bodies. */
  private question(): Question | null {
    if (this.selected.length !== 2) return null;
    const [a, b] = this.selected.map((i) => this.run.asked(i));
    return { query: "contacts", ...(this.run.flat ? { dimension: 2 as const } : {}), a, b, margin: this.run.margin(this.selected[0], this.selected[1]) };
  }

  private pick(body: number | null, ray: { origin: Vec; direction: Vec }): void {
    if (this.aim) {
      try {
        this.shoot(this.aim, ray);
      } catch (error) {
        this.say((error as Error).message); // two clicks at one place are no direction
      }
      return;
    }
    if (body === null) this.selected = [];
    else if (this.selected.includes(body)) this.selected = this.selected.filter((x) => x !== body);
    else this.selected = [...this.selected, body].slice(-2);
    this.show();
    this.remember();
  }
  private takeAim(kind: "ray" | "cast"): void {
    const blind = kind === "cast" && this.selected.length === 0;
    this.aim = blind ? null : { kind };
    this.tellShot(kind === "ray" ? "Shoot a ray" : "Cast a body",
      blind ? "Select the body first." : kind === "ray" && this.run.flat ? "Click where it begins, then where it shall go." : "Click where it shall go.");
  }
  /** The click that a ray or a cast waits for: a place in the plane, a line of sight in space. */
  private shoot(aim: { kind: "ray" | "cast"; from?: Vec }, sight: { origin: Vec; direction: Vec }): void {
    if (aim.kind === "cast" && this.selected.length === 0) return this.takeAim("cast");
    const place = this.run.flat ? add(sight.origin, scale(sight.direction, -sight.origin[2] / sight.direction[2])) : null;
    if (aim.kind === "ray" && place && !aim.from) {
      this.aim = { ...aim, from: place };
      return;
    }
    this.aim = null;
    const target = place ?? this.run.raycast(sight)?.point ?? add(sight.origin, scale(sight.direction, length(sight.origin)));
    // In space a ray comes from beneath the eye: from the eye itself it would be seen as a point.
    const from = aim.from ?? add(sight.origin, [0, -length(sub(target, sight.origin)) / 4, 0]);
    this.shot = aim.kind === "ray" ? shootRay(this.run, { origin: from, direction: sub(target, from) }) : castBody(this.run, this.selected[0], target);
    if (this.shot.question) this.asked.value = line(this.shot.question);
    const { kind, hit } = this.shot, name = hit && this.scene.bodies[hit.body].name;
    this.tellShot(kind === "ray" ? `The ray hits ${name ?? "nothing"}` : `${this.scene.bodies[this.shot.body!].name} meets ${name ?? "nothing"} on its way`,
      hit ? `${kind === "ray" ? "after" : "at"} ${digits(hit.t, 6)}, at ${vector(hit.point, 4)}, normal ${vector(hit.normal, 3)}` : "");
    this.paint();
  }
  /** How rough and how bouncy the first selected body is. */
  private tellMaterial(): void {
    const [i] = this.selected, body = this.scene.bodies[i];
    this.materials.replaceChildren();
    if (!body) return;
    const { staticFriction = 0.6, dynamicFriction = staticFriction, restitution = 0 } = body.material ?? {};
    const field = (label: string, value: number, most: number, set: (x: number) => graze.Material): HTMLElement =>
      h("label", {}, `${label} `, h("input", { type: "number", min: 0, max: most, step: 0.05, value,
        onchange: (event: Event) => {
          try {
            this.run.setMaterial(i, { ...body.material, ...set(Number((event.target as HTMLInputElement).value)) });
            this.trouble.hidden = true;
          } catch (error) {
            this.say((error as Error).message);
          }
        } }));
    this.materials.append(
      field("Friction", dynamicFriction, 10, (x) => ({ staticFriction: x, dynamicFriction: x })), field("Restitution", restitution, 1, (x) => ({ restitution: x })));
  }
  private tellShot(title: string, words: string): void {
    this.info.replaceChildren(h("h2", {}, title), h("p", {}, words));
  }
  private chooseBodies(): void {
    this.selected = [...new Set(this.chosen.filter((s) => s.value !== "").map((s) => Number(s.value)))];
    this.show();
    this.remember();
  }
  private drag(id: string, to: Vec, done: boolean): void {
    const i = this.selected[0], body = this.scene.bodies[i];
    if (!body) return;
    const aimed = this.run.flat ? [to[0], to[1], 0] : to, place = this.run.place(i);
    if (this.running && body.moves) {
      this.pull = done ? null : { body: i, to: aimed };
      return;
    }
    const turn = (): Vec => unit(quatMultiply(quatBetween(rotate(place.rotation, [1, 0, 0]), sub(aimed, place.translation)), place.rotation));
    const next = id === "move" ? { ...place, translation: aimed } : { ...place, rotation: turn() };
    if (!this.run.played) Object.assign(body, next);
    this.run.put(i, next);
    this.show();
    if (done && !this.run.played) this.remember();
  }
  private handles(): Handle[] {
    const i = this.selected[0];
    if (i === undefined) return [];
    const { translation, rotation } = this.run.place(i);
    const reach = this.scene.bodies[i].shape.type === "plane" ? 1 : Math.min(this.stage.seen, reachOf(this.run.bounds(i)) * 1.2 + this.stage.seen / 20);
    const name = this.scene.bodies[i].name;
    return [
      { id: "move", label: `Move ${name}`, kind: "move", meaning: "made", sign: "A", at: this.pull?.to ?? translation },
      ...(this.running ? [] : [{ id: "turn", label: `Turn ${name}`, kind: "turn" as const, meaning: "made" as const, at: add(translation, scale(rotate(rotation, [1, 0, 0]), reach)) }]),
    ];
  }

  private show(): void {
    const start = performance.now();
    this.stage.crowd.move(this.run.poses());
    this.chosen.forEach((select, k) => (select.value = String(this.selected[k] ?? "")));
    const special = new Map<number, Meaning>();
    if (!this.run.played && this.scene.bodies.length <= mostDrawn) for (const pair of this.run.contacts()) if (deepest(pair) < -visible * this.stage.seen) for (const i of [pair.a, pair.b]) if (this.scene.bodies[i]?.moves) special.set(i, "touch");
    this.selected.forEach((i, k) => special.set(i, k ? "b" : "made"));
    this.stage.crowd.paint(special);
    this.paint();
    this.times.draw = performance.now() - start;
    if (!this.running || this.energy.length % (this.scene.bodies.length > mostDrawn ? 30 : 6) === 0) this.tell();
  }
  private paint(): void {
    // To copy thousands of contacts out of the module takes longer than to draw the bodies.
    const few = this.scene.bodies.length <= mostDrawn, found = few ? this.run.contacts() : [];
    const [first, other] = this.selected;
    this.features = other === undefined ? [] : this.run.features(first, other, this.run.margin(first, other));
    const gap = other === undefined ? null : ask({ ...this.question()!, query: "distance", margin: undefined } as Question);
    const marked = new Set(this.selected);
    this.stage.draw((d: Drawing) => {
      for (const pair of found)
        for (const manifold of pair.manifolds)
          for (const p of manifold.points) {
            d.point(p.a, p.distance <= 0 ? "touch" : "axis", { key: `${pair.a} ${pair.b}` });
            if (marked.has(pair.a) || marked.has(pair.b)) d.arrow(p.a, add(p.a, scale(manifold.normal, this.stage.seen / 10)), "axis", { key: `${pair.a} ${pair.b}` });
          }
      if (this.broadPhase && few) this.run.drawBroadPhase((from, to, leaf) => d.line(from, to, leaf ? "ink" : "out", { ghost: !leaf }));
      this.run.drawJoints((from, to, gap) => d.line(from, to, gap ? "touch" : "ink", { wide: gap }));
      this.features.forEach((of, i) => of.forEach((corners, k) => drawFeature(d, corners, k ? "b" : "made", `point ${i}`)));
      if (other !== undefined) d.text(this.run.place(other).translation, "B", "b");
      if (gap && gap.distance! > 0) d.line(gap.a as unknown as Vec, gap.b as unknown as Vec, "axis", { dashed: true, label: digits(gap.distance, 4) });
      if (this.pull) d.line(this.run.place(this.pull.body).translation, this.pull.to, "made", { wide: true });
      if (this.shot) drawShot(d, this.shot, this.scene, this.stage.seen);
    }, this.handles(), `${this.scene.name}: ${this.scene.bodies.length} bodies${few ? `, ${found.length} pairs in contact` : ""}.`);
  }
  private tell(): void {
    const found = this.run.contacts();
    const points = found.reduce((sum, p) => sum + p.manifolds.reduce((n, m) => n + m.points.length, 0), 0);
    this.counter.textContent = `${this.scene.bodies.length} bodies · ${found.length} pairs · ${points} contacts` +
      (this.run.played ? ` · step ${digits(this.times.step, 3)} ms · drawing ${digits(this.times.draw, 3)} ms` : "");
    const name = (i: number): string => this.scene.bodies[i]?.name ?? String(i);
    this.pairs.show({
      caption: found.length > 30 ? `The first 30 of ${found.length} pairs` : "Pairs in contact", columns: ["pair", "points", "deepest"],
      rows: found.slice(0, 30).map((p) => ({
        cells: [`${name(p.a)} × ${name(p.b)}`, p.manifolds.reduce((n, m) => n + m.points.length, 0), p.manifolds.length > 0 ? deepest(p) : "inside"],
        key: `${p.a} ${p.b}`, mark: this.selected.includes(p.a) && this.selected.includes(p.b) ? "winner" as const : undefined })),
    });
    this.plot.replaceChildren();
    if (this.energy.length > 1) {
      const tail = <T,>(v: T[]): T[] => v.slice(-300), last = Math.min(300, this.energy.length) - 1;
      this.plot.append(drawGraph({ caption: "energy", at: last, series: [{ name: digits(this.energy.at(-1), 4), meaning: "made", values: tail(this.energy) }] }),
        drawGraph({ caption: "deepest penetration", at: last, series: [{ name: digits(this.depth.at(-1), 3), meaning: "touch", values: tail(this.depth) }] }));
    }
    this.explain();
  }
  private explain(): void {
    this.tellMaterial();
    const q = this.question();
    if (!q) {
      if (this.shot && this.selected.length === 0) return;
      const [i] = this.selected;
      this.info.replaceChildren(h("h2", {}, i === undefined ? "Select a body" : this.scene.bodies[i].name),
        h("p", {}, i === undefined ? "Click one to move it, a second one to see why the two touch or do not." : "Click another to see what the two have to do with each other."));
      this.table.show(i === undefined ? undefined : propertiesOf(this.run, this.scene.bodies[i], i, this.run.contacts()));
      return;
    }
    const [i, j] = this.selected, answer = ask(q), distance = ask({ ...q, query: "distance", margin: undefined } as Question);
    this.info.replaceChildren(
      h("h2", {}, `${this.scene.bodies[i].name} and ${this.scene.bodies[j].name}`),
      h("p", {}, answer.error ?? distance.error ?? `${answer.overlap ? "They touch" : "They are apart"}: signed distance ${digits(distance.distance, 6)}, normal ${vector(distance.normal, 4)}. ${distance.trace.reason ?? distance.trace.method}.`),
      ...lessonsOf(q, distance.distance! > 0).map(({ lesson, shows, state }) =>
        h("p", {}, h("a", { href: address(`/lesson/${lesson}`, { s: JSON.stringify(state) }) }, `Step through ${shows}`))));
    this.asked.value = line(q);
    this.table.show({ caption: "Points of the pair", columns: ["features", "distance"],
      rows: (answer.manifolds ?? []).flatMap((m) => m.points).map((p, k) => ({ cells: [featureWords(p.feature, q.dimension), p.distance], key: `point ${k}` })) });
  }

  /** The controls as the settings are. */
  private controls(): void {
    this.steps.value = String(this.subSteps);
    this.falls.checked = this.heavy;
  }
  private page(): HTMLElement {
    const chooser = h("input", { type: "file", multiple: true, class: "hidden", accept: ".gltf,.glb,.bin,.obj,.stl,.ply,.svg,.json,.jsonl,.capture", "aria-label": "Open a file",
      onchange: (event: Event) => void this.chosenFiles([...((event.target as HTMLInputElement).files ?? [])]) }) as HTMLInputElement;
    const again = (): void => this.begin();
    return h("article", { class: "lesson" },
      h("header", {}, h("h1", {}, "Viewer and playground"), this.note),
      h("div", { class: "choices" },
        this.list, button("Open a file", () => chooser.click()), chooser,
        button("Shoot a ray", () => this.takeAim("ray")), button("Cast the body", () => this.takeAim("cast")),
        h("label", {}, "Sub-steps ", this.steps), h("label", {}, this.falls, " Gravity"),
        h("label", {}, h("input", { type: "checkbox", "data-broad-phase": true, onchange: (e: Event) => { this.broadPhase = (e.target as HTMLInputElement).checked; this.paint(); } }), " Broad phase")),
      h("div", { class: "board" },
        h("div", { class: "picture" }, this.stage.element,
          h("div", { class: "timeline", role: "group", "aria-label": "Time" },
            button("Step back", () => this.back(), { "data-back": true }), this.play, button("One step", () => { this.stop(); this.step(); }, { "data-step": true }), button("Start again", again)),
          this.counter, this.trouble),
        h("div", { class: "side" }, h("div", { class: "choices" }, ...this.chosen), this.info, this.materials, this.table.element, this.plot, this.pairs.element,
          h("details", {}, h("summary", {}, "As a question"), this.asked,
            h("p", { class: "actions" }, button("Copy", () => void navigator.clipboard.writeText(this.asked.value)), button("Ask it", () => {
              try {
                this.unwatch();
                this.open(sceneOfQuestion(JSON.parse(this.asked.value) as Question));
                this.remember();
              } catch (error) {
                this.say((error as Error).message);
              }
            }))))));
  }
}
