// The viewer and the playground: a scene whose contacts are live while a body is dragged, and which can be played.

import { ask, graze, line } from "../graze.ts";
import { digits, h, vector } from "../parts/dom.ts";
import type { Drawing, Handle, Meaning } from "../parts/drawing.ts";
import { featureWords } from "../parts/features.ts";
import { drawGraph } from "../parts/graph.ts";
import { solidOf } from "../parts/solid.ts";
import { Stage3 } from "../parts/stage3.ts";
import { address } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import { add, length, quatBetween, quatMultiply, rotate, scale, sub, unit } from "../parts/vec.ts";
import type { Body, Question, Vec } from "../question.ts";
import { Shapes, simulationOf, worldOf, type Scene } from "../scene/model.ts";
import { readCapture, type Captured } from "../scene/captured.ts";
import { openFile, sceneOfQuestion } from "../scene/open.ts";
import { scenes } from "../scene/scenes.ts";
import type { Room } from "./room.ts";

const frame = 1 / 60;
/** Of larger scenes the contacts are counted and not drawn. */
const mostDrawn = 200;
/** Ten seconds of states to step back to; fewer of large scenes. */
const mostStates = (bodies: number): number => (bodies > 300 ? 120 : 600);
/** Bodies that are deeper in each other than that are marked. */
const visible = 1e-3;
const deepest = (pair: graze.WorldPair): number => Math.min(...pair.manifolds.flatMap((m) => m.points.map((x) => x.distance)));
const button = (label: string, act: () => void, more: Record<string, unknown> = {}): HTMLButtonElement =>
  h("button", { type: "button", onclick: act, ...more }, label) as HTMLButtonElement;

export class SceneRoom implements Room {
  readonly element: HTMLElement;
  private readonly stage = new Stage3();
  private scene!: Scene;
  private shapes = new Shapes();
  private world: graze.World | null = null;
  private simulation: graze.Simulation | null = null;
  private ids: graze.BodyId[] = [];
  private states: graze.State[] = [];
  private energy: number[] = [];
  private depth: number[] = [];
  private selected: number[] = [];
  private pull: { body: number; grip: Vec; to: Vec } | null = null;
  private ray: { from: Vec; to: Vec; body: string } | null = null;
  private shooting = false;
  /** Of the file that is looked after, the timer; null when none is. */
  private watching: number | null = 0;
  private running = 0;
  private subSteps = 8;
  private gravity = true;
  private times = { step: 0, draw: 0 };
  private readonly onCapture: (name: string, captured: Captured) => void;
  private readonly table = new Table();
  private readonly pairs = new Table();
  private readonly info = h("div", { class: "words", "aria-live": "polite" });
  private readonly plot = h("div", { class: "plot" });
  private readonly counter = h("p", { class: "counter" });
  private readonly note = h("p", { class: "intro" });
  private readonly trouble = h("p", { class: "trouble", role: "alert", hidden: true });
  private readonly list: HTMLSelectElement;
  private readonly play: HTMLButtonElement;
  private readonly chosen = [0, 1].map((k) =>
    h("select", { "aria-label": k ? "Another body" : "A body", "data-body": k, onchange: () => this.chooseBodies() }) as HTMLSelectElement);
  private readonly asked = h("textarea", { rows: 3, spellcheck: "false", "aria-label": "A question of the protocol" }) as HTMLTextAreaElement;

  /** `onCapture` gets a capture that was opened in place of a scene. */
  constructor(values: Record<string, string>, onCapture: (name: string, captured: Captured) => void) {
    this.onCapture = onCapture;
    this.stage.onPick = (body, ray) => this.pick(body, ray);
    this.stage.onDrag = (id, to, done) => this.drag(id, to, done);
    this.pairs.onPoint = (key) => this.stage.light(key);
    this.list = h("select", { "aria-label": "Scene", onchange: () => this.choose(this.list.value) },
      ...Object.entries(scenes).map(([key, make]) => h("option", { value: key }, make().name))) as HTMLSelectElement;
    this.play = button("Play", () => this.toggle(), { class: "accent", "data-play": true });
    this.element = this.page();
    this.element.addEventListener("dragover", (event) => event.preventDefault());
    this.element.addEventListener("drop", (event) => {
      event.preventDefault();
      const [file] = event.dataTransfer?.files ?? [];
      if (file) void this.chosenFile(file);
    });
    const key = values.scene && scenes[values.scene] ? values.scene : "shapes";
    this.list.value = key;
    if (values.q) {
      try {
        this.open(sceneOfQuestion(JSON.parse(values.q) as Question));
        return;
      } catch (error) {
        this.say((error as Error).message);
      }
    }
    this.open(scenes[key]());
    if (values.file) void this.watch(values.file);
  }
  /** A file beside the page, which `graze view` serves, read again when it changes; nothing is fetched from elsewhere. */
  private async watch(path: string): Promise<void> {
    const where = new URL(path, location.href);
    if (where.origin !== location.origin) return this.say(`${path}: lies elsewhere`);
    await this.read(where, "");
  }
  /** Reads a file unless it is still of the version that is known; one that has versions is asked for again. */
  private async read(where: URL, known: string): Promise<void> {
    const name = decodeURIComponent(where.pathname.split("/").pop() ?? "");
    let version = known;
    try {
      const response = await fetch(where, { cache: "no-store", headers: known ? { "If-None-Match": known } : {} });
      if (this.watching === null) return;
      if (response.ok) {
        version = response.headers.get("ETag") ?? "";
        await this.file(new File([await response.blob()], name));
      } else if (response.status !== 304) {
        throw new Error(`${name}: ${response.status === 404 ? "the file is gone" : `${response.status} ${response.statusText}`}`);
      }
    } catch (error) {
      this.say(error instanceof TypeError ? `${name}: graze view does not answer any more` : (error as Error).message);
    }
    if (version && this.watching !== null) this.watching = window.setTimeout(() => void this.read(where, version), document.hidden ? 5000 : 1000);
  }
  /** Another scene was chosen: the file is not looked after any more. */
  private unwatch(): void {
    if (this.watching) clearTimeout(this.watching);
    this.watching = null;
  }

  dispose(): void {
    this.unwatch();
    this.close();
    this.stage.dispose();
  }
  /** For the tests. */
  get shown(): { bodies: number; pairs: number; frames: number; poses: number[]; deepest: number; times: { step: number; draw: number } } {
    const at = this.questions();
    return { bodies: this.scene.bodies.length, pairs: at.contacts().filter((p) => p.overlap).length, frames: this.energy.length,
      poses: Array.from(at.poses()), deepest: this.depth.at(-1) ?? 0, times: this.times };
  }

  // --- Scenes ---

  private close(): void {
    this.stop();
    this.forget();
    this.simulation?.dispose();
    this.world?.dispose();
    this.simulation = this.world = null;
    this.shapes.dispose();
    this.shapes = new Shapes();
  }
  private forget(): void {
    for (const state of this.states) state.dispose();
    this.states = [];
    this.energy = [];
    this.depth = [];
  }
  private choose(key: string): void {
    this.unwatch();
    history.replaceState(null, "", address("/scene", { scene: key }));
    this.open(scenes[key]());
  }
  private open(scene: Scene): void {
    this.close();
    this.trouble.hidden = true;
    this.selected = [];
    this.pull = this.ray = null;
    try {
      this.scene = scene;
      const made = worldOf(scene, this.shapes);
      this.world = made.world;
      this.ids = made.ids;
    } catch (error) {
      this.say(`${scene.name}: ${(error as Error).message}`);
      this.scene = { name: "empty", bodies: [] };
      this.world = new graze.World();
    }
    const { bodies } = this.scene;
    this.stage.crowd.set(bodies.map(({ shape }) => ({ key: JSON.stringify(shape), make: () => solidOf(shape), flat: shape.type === "plane" })), bodies.map((b): Meaning => (b.trigger ? "trigger" : b.moves ? "a" : "out")));
    for (const [k, select] of this.chosen.entries())
      select.replaceChildren(h("option", { value: "" }, k ? "no other body" : "no body"), ...bodies.map((b, i) => h("option", { value: i }, b.name)));
    this.note.textContent = this.scene.note ?? "";
    this.stage.look(this.scene.view ?? this.whole());
    this.show();
  }
  /** A view of everything. */
  private whole(): { center: Vec; reach: number } {
    let lower: Vec = [Infinity, Infinity, Infinity], upper: Vec = [-Infinity, -Infinity, -Infinity];
    for (const body of this.scene.bodies) {
      if (body.shape.type === "plane") continue;
      const bounds = this.shapes.of(body.shape).bounds({ translation: body.translation, rotation: unit(body.rotation) });
      lower = lower.map((x, i) => Math.min(x, bounds.lower[i]));
      upper = upper.map((x, i) => Math.max(x, bounds.upper[i]));
    }
    if (!lower.every(Number.isFinite)) return { center: [0, 0, 0], reach: 3 };
    return { center: scale(add(lower, upper), 0.5), reach: Math.max(1e-6, length(sub(upper, lower)) * 0.55) };
  }
  private chosenFile(file: File): Promise<void> {
    this.unwatch();
    return this.file(file);
  }
  private async file(file: File): Promise<void> {
    try {
      if (file.name.endsWith(".capture")) this.onCapture(file.name, await readCapture(await file.arrayBuffer()));
      else this.open(await openFile(file));
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
  private begin(): graze.Simulation {
    if (!this.simulation) {
      const made = simulationOf(this.scene, this.shapes, { gravity: this.gravity ? [0, -9.81, 0] : [0, 0, 0], subSteps: this.subSteps });
      this.simulation = made.simulation;
      this.ids = made.ids;
      this.world?.dispose();
      this.world = null;
    }
    return this.simulation;
  }
  private step(): void {
    try {
      const simulation = this.begin();
      this.states.push(simulation.save());
      if (this.states.length > mostStates(this.scene.bodies.length)) this.states.shift()!.dispose();
      if (this.pull) this.tug(simulation, this.pull);
      const start = performance.now();
      simulation.step(frame);
      this.times.step = performance.now() - start;
      const report = simulation.report();
      this.energy.push(report.kineticEnergy + report.potentialEnergy);
      this.depth.push(report.deepest);
      this.show();
    } catch (error) {
      this.stop();
      this.say((error as Error).message);
    }
  }
  private back(): void {
    this.stop();
    const state = this.states.pop();
    if (!state || !this.simulation) return;
    this.simulation.restore(state);
    state.dispose();
    this.energy.pop();
    this.depth.pop();
    this.show();
  }
  /** A spring, critically damped at three hertz, from the grip on the body to the pointer. */
  private tug(simulation: graze.Simulation, pull: { body: number; grip: Vec; to: Vec }): void {
    const id = this.ids[pull.body], motion = simulation.motion(id), mass = simulation.mass(id), omega = 2 * Math.PI * 3;
    const force = sub(scale(sub(pull.to, motion.center), omega * omega * mass), scale(motion.linear, 2 * omega * mass));
    simulation.wake(id);
    simulation.applyForce(id, force);
  }

  // --- What is true now ---

  private questions(): graze.WorldQueries {
    return this.simulation ? this.simulation.world : this.world!;
  }
  private body(i: number): Body {
    const pose = this.questions().pose(this.ids[i]);
    return { shape: this.scene.bodies[i].shape, translation: pose.translation, rotation: pose.rotation };
  }
  /** The question about the two selected bodies. */
  private question(): Question | null {
    if (this.selected.length !== 2) return null;
    const [i, j] = this.selected;
    return { query: "contacts", a: this.body(i), b: this.body(j), margin: 0.01 };
  }

  private pick(body: number | null, ray: { origin: Vec; direction: Vec }): void {
    if (this.shooting) {
      const hit = this.questions().raycast(ray);
      this.shooting = false;
      this.ray = hit ? { from: ray.origin, to: hit.hit.point, body: this.scene.bodies[hit.body.index]?.name ?? "" } : null;
      this.info.replaceChildren(h("h2", {}, hit ? `The ray hits ${this.ray!.body}` : "The ray hits nothing"),
        h("p", {}, hit ? `after ${digits(hit.hit.t, 6)}, at ${vector(hit.hit.point, 4)}, normal ${vector(hit.hit.normal, 3)}` : ""));
      this.paint();
      return;
    }
    if (body === null) this.selected = [];
    else if (this.selected.includes(body)) this.selected = this.selected.filter((x) => x !== body);
    else this.selected = [...this.selected, body].slice(-2);
    this.show();
  }
  private chooseBodies(): void {
    this.selected = [...new Set(this.chosen.filter((s) => s.value !== "").map((s) => Number(s.value)))];
    this.show();
  }
  private drag(id: string, to: Vec, done: boolean): void {
    const i = this.selected[0], body = this.scene.bodies[i];
    if (!body) return;
    const pose = this.questions().pose(this.ids[i]);
    if (this.simulation && this.running && body.moves) {
      this.pull = done ? null : { body: i, grip: pose.translation, to };
      return;
    }
    const next = { translation: pose.translation as Vec, rotation: pose.rotation as Vec };
    if (id === "move") next.translation = to;
    else next.rotation = unit(quatMultiply(quatBetween(rotate(pose.rotation, [1, 0, 0]), sub(to, pose.translation)), pose.rotation));
    if (this.simulation) {
      this.simulation.setPose(this.ids[i], next);
    } else {
      Object.assign(body, next);
      this.world!.move(this.ids[i], next);
      this.world!.update();
    }
    this.show();
  }
  private handles(): Handle[] {
    const i = this.selected[0];
    if (i === undefined || !this.ids[i]) return [];
    const { translation, rotation } = this.questions().pose(this.ids[i]), bounds = this.shapes.of(this.scene.bodies[i].shape);
    const reach = this.scene.bodies[i].shape.type === "plane" ? 1 : Math.min(3, length(sub(bounds.bounds().upper, bounds.bounds().lower)) * 0.6 + 0.2);
    const name = this.scene.bodies[i].name;
    return [
      { id: "move", label: `Move ${name}`, kind: "move", meaning: "a", at: this.pull?.to ?? translation },
      ...(this.running ? [] : [{ id: "turn", label: `Turn ${name}`, kind: "turn" as const, meaning: "a" as const, at: add(translation, scale(rotate(rotation, [1, 0, 0]), reach)) }]),
    ];
  }

  private show(): void {
    const start = performance.now();
    const at = this.questions();
    this.stage.crowd.move(at.poses());
    this.chosen.forEach((select, k) => (select.value = String(this.selected[k] ?? "")));
    const special = new Map<number, Meaning>();
    if (!this.simulation && this.scene.bodies.length <= mostDrawn) for (const pair of at.contacts()) if (deepest(pair) < -visible) for (const i of [pair.a, pair.b]) if (this.scene.bodies[i]?.moves) special.set(i, "touch");
    this.selected.forEach((i, k) => special.set(i, k ? "b" : "made"));
    this.stage.crowd.paint(special);
    this.paint();
    this.times.draw = performance.now() - start;
    if (!this.running || this.energy.length % (this.scene.bodies.length > mostDrawn ? 30 : 6) === 0) this.tell();
  }
  private paint(): void {
    // To copy thousands of contacts out of the module takes longer than to draw the bodies.
    const few = this.scene.bodies.length <= mostDrawn, found = few ? this.questions().contacts() : [];
    const marked = new Set(this.selected);
    this.stage.draw((d: Drawing) => {
      for (const pair of found)
        for (const manifold of pair.manifolds)
          for (const p of manifold.points) {
            d.point(p.a as Vec, p.distance <= 0 ? "touch" : "axis", { key: `${pair.a} ${pair.b}` });
            if (marked.has(pair.a) || marked.has(pair.b)) d.arrow(p.a as Vec, add(p.a as Vec, scale(manifold.normal as Vec, 0.4)), "axis", { key: `${pair.a} ${pair.b}` });
          }
      if (this.pull) d.line(this.questions().pose(this.ids[this.pull.body]).translation, this.pull.to, "made", { wide: true });
      if (this.ray) {
        d.arrow(this.ray.from, this.ray.to, "made", { wide: true });
        d.point(this.ray.to, "touch", { wide: true });
      }
    }, this.handles(), `${this.scene.name}: ${this.scene.bodies.length} bodies${few ? `, ${found.length} pairs in contact` : ""}.`);
  }
  private tell(): void {
    const found = this.questions().contacts();
    const points = found.reduce((sum, p) => sum + p.manifolds.reduce((n, m) => n + m.points.length, 0), 0);
    this.counter.textContent = `${this.scene.bodies.length} bodies · ${found.length} pairs · ${points} contacts` +
      (this.simulation ? ` · step ${digits(this.times.step, 3)} ms · drawing ${digits(this.times.draw, 3)} ms` : "");
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
    const q = this.question();
    if (!q) {
      if (this.ray && this.selected.length === 0) return;
      const [i] = this.selected;
      this.info.replaceChildren(h("h2", {}, i === undefined ? "Select a body" : this.scene.bodies[i].name),
        h("p", {}, i === undefined ? "Click one to move it, a second one to see why the two touch or do not." : `A ${this.scene.bodies[i].shape.type} at ${vector(this.questions().pose(this.ids[i]).translation, 4)}. Click another for the pair.`));
      this.table.show(undefined);
      return;
    }
    const [i, j] = this.selected, answer = ask(q), distance = ask({ ...q, query: "distance", margin: undefined } as Question);
    const boxes = q.a.shape.type === "box" && q.b!.shape.type === "box";
    const lesson = boxes ? "fifteen-axes" : "gjk-space";
    const state = JSON.stringify({ q: boxes ? { query: "contacts", a: q.a, b: q.b } : { query: "distance", a: q.a, b: q.b } });
    this.info.replaceChildren(
      h("h2", {}, `${this.scene.bodies[i].name} and ${this.scene.bodies[j].name}`),
      h("p", {}, answer.error ?? distance.error ?? `${answer.overlap ? "They touch" : "They are apart"}: signed distance ${digits(distance.distance, 6)}, normal ${vector(distance.normal, 4)}. ${distance.trace.reason ?? distance.trace.method}.`),
      h("p", {}, h("a", { href: address(`/lesson/${lesson}`, { s: state }) }, "Step through this pair")));
    this.asked.value = line(q);
    this.table.show({ caption: "Points of the pair", columns: ["features", "distance"],
      rows: (answer.manifolds ?? []).flatMap((m) => m.points.map((p) => ({ cells: [featureWords(p.feature), p.distance] }))) });
  }

  private page(): HTMLElement {
    const chooser = h("input", { type: "file", class: "hidden", accept: ".gltf,.glb,.obj,.stl,.ply,.json,.jsonl,.capture", "aria-label": "Open a file",
      onchange: (event: Event) => { const [file] = (event.target as HTMLInputElement).files ?? []; if (file) void this.chosenFile(file); } }) as HTMLInputElement;
    const again = (): void => { const { scene } = this; this.open(scenes[this.list.value]?.().name === scene.name ? scenes[this.list.value]() : scene); };
    return h("article", { class: "lesson" },
      h("header", {}, h("h1", {}, "Viewer and playground"), this.note),
      h("div", { class: "choices" },
        this.list, button("Open a file", () => chooser.click()), chooser,
        button("Shoot a ray", () => { this.shooting = true; this.info.replaceChildren(h("h2", {}, "Shoot a ray"), h("p", {}, "Click where it shall go.")); }),
        h("label", {}, "Sub-steps ", h("select", { onchange: (e: Event) => { this.subSteps = Number((e.target as HTMLSelectElement).value); again(); } },
          ...[8, 1, 2, 4, 16].map((n) => h("option", { value: n }, String(n))))),
        h("label", {}, h("input", { type: "checkbox", checked: true, onchange: (e: Event) => { this.gravity = (e.target as HTMLInputElement).checked; this.simulation?.setGravity(this.gravity ? [0, -9.81, 0] : [0, 0, 0]); } }), " Gravity")),
      h("div", { class: "board" },
        h("div", { class: "picture" }, this.stage.element,
          h("div", { class: "timeline", role: "group", "aria-label": "Time" },
            button("Step back", () => this.back(), { "data-back": true }), this.play, button("One step", () => { this.stop(); this.step(); }, { "data-step": true }), button("Start again", again)),
          this.counter, this.trouble),
        h("div", { class: "side" }, h("div", { class: "choices" }, ...this.chosen), this.info, this.table.element, this.plot, this.pairs.element,
          h("details", {}, h("summary", {}, "The pair as a question"), this.asked,
            h("p", { class: "actions" }, button("Ask it", () => {
              try {
                this.open(sceneOfQuestion(JSON.parse(this.asked.value) as Question));
              } catch (error) {
                this.say((error as Error).message);
              }
            }))))));
  }
}
