// A scene in time: played, stepped, and gone through, back as far as states are kept and forward as far as it was
// played.

import type { graze } from "../graze.ts";
import type { Vec } from "../question.ts";
import { followersAt, type Animation } from "./animation.ts";
import { sorted, type StepEvents } from "./events.ts";
import { act, Inputs, possible, type Action, type Input, type Pull } from "./inputs.ts";
import { KeptStates } from "./kept.ts";
import { usualGravity, type Scene } from "./model.ts";
import { Run, type Stages } from "./run.ts";

/** The seconds of a step. */
export const frame = 1 / 60;
/** The milliseconds that a run that is repeated takes between two pictures. */
const slice = 40;
const nothing: Scene = { name: "empty", bodies: [] };

export interface Listener {
  /** Called after every step, forward or back. */
  onStep(): void;
  onRunning(running: boolean): void;
  onTrouble(text: string): void;
}
/** The settings with which a run began. */
export interface Begun {
  subSteps: number;
  warmStart: boolean;
  gravity: Vec | null;
  materials: (graze.Material | graze.plane.Material | undefined)[];
}

export class Play {
  scene = nothing;
  run = new Run(nothing);
  subSteps = 8;
  /** Whether a sub-step begins with the impulses of the last one. */
  warmStart = true;
  /** The gravity that somebody set; null for the scene's own. */
  pulled: Vec | null = null;
  /** The animation that kinematic bodies follow, and its time when the run begins. */
  follows: { animation: Animation; from: number } | null = null;
  /** The number of steps for each picture. */
  speed = 1;
  /** The number of steps that were made, and that up to which it was played. */
  steps = 0;
  last = 0;
  /** The energy and the depth after every step. */
  energy: number[] = [];
  depth: number[] = [];
  /** The time of the last step, in milliseconds, and of its parts. */
  stepTime = 0;
  stages: Stages | null = null;
  readonly inputs = new Inputs();
  begun: Begun | null = null;
  /** The run that is being repeated, until it is there or somebody stops it. */
  goal: { steps: number; inputs: Input[] } | null = null;
  private events: (StepEvents | undefined)[] = [];
  private readonly kept = new KeptStates();
  private ticking = 0;
  private readonly listener: Listener;

  constructor(listener: Listener) {
    this.listener = listener;
  }
  dispose(): void {
    this.stop();
    this.forget();
    this.run.dispose();
  }

  get running(): boolean {
    return this.ticking !== 0;
  }
  get gravity(): Vec {
    return this.pulled ?? this.own;
  }
  /** The scene's own gravity. */
  get own(): Vec {
    return this.scene.gravity ?? usualGravity;
  }
  /** The first step that can be gone back to. */
  get first(): number {
    return this.kept.first;
  }
  /** The spring that somebody holds a body by. */
  get pull(): Pull | null {
    return this.inputs.pullAt(this.steps);
  }
  /** The events of the step that came to this state. */
  eventsOf(step: number): StepEvents | undefined {
    return this.events[step];
  }
  /** Opens another scene. Throws the library's errors; the scene is an empty one then. */
  open(scene: Scene): void {
    this.dispose();
    this.scene = nothing;
    this.run = new Run(nothing);
    const made = new Run(scene);
    this.run.dispose();
    this.run = made;
    this.scene = scene;
    this.kept.clear(scene.bodies.length);
  }
  /** Begins the scene anew, with its bodies where they were put. */
  begin(): void {
    this.open(this.scene);
  }
  toggle(): void {
    if (this.running) return this.stop();
    let due = 0;
    this.tick(() => {
      for (due += this.speed; due >= 1 && this.running; due--) this.forward(due >= 2);
    });
  }
  stop(): void {
    cancelAnimationFrame(this.ticking);
    this.ticking = 0;
    this.goal = null;
    this.listener.onRunning(false);
  }
  step(): void {
    this.stop();
    this.forward();
  }
  back(): void {
    this.stop();
    if (this.steps > this.first) this.goTo(this.steps - 1);
  }
  /** Goes to a step that was made. */
  goTo(step: number): void {
    this.attempt(() => {
      this.seek(Math.max(this.first, Math.min(step, this.last)));
      this.listener.onStep();
    });
  }
  /** Does something to the simulation, after which nothing later is true any more. Throws where the library refuses it;
   *  everything stays then as it was. */
  act(action: Action): void {
    if (!this.run.played && !this.running) return;
    if (this.goal) this.stop();
    this.start();
    act(this.run, action);
    this.kept.forgetFrom(this.steps + 1);
    this.inputs.forgetAfter(this.steps);
    this.last = this.steps;
    for (const values of [this.energy, this.depth]) values.length = this.steps;
    this.events.length = Math.min(this.events.length, this.steps + 1);
    this.inputs.add({ ...action, step: this.steps });
    if (action.kind !== "pull") this.kept.keep(this.steps, this.run.save());
  }
  /** Sets the gravity from here on; null is the scene's own. */
  setGravity(gravity: Vec | null): void {
    this.act({ kind: "gravity", gravity: gravity ?? this.own });
    this.pulled = gravity;
  }
  /** Repeats a run from its beginning: so many steps, with what was done in them. It goes on between pictures where it
   *  takes longer than one. */
  repeat(steps: number, inputs: Input[]): void {
    this.begin();
    const done = possible(inputs, this.scene).filter(({ step }) => step <= steps);
    if (steps === 0 && done.length === 0) return;
    this.inputs.list = done;
    this.goal = { steps, inputs: done };
    this.attempt(() => {
      this.start();
      this.approach();
    });
    if (this.goal) this.tick(() => {
      this.attempt(() => this.approach());
      this.listener.onStep();
    });
  }
  /** The bytes of a capture of the run up to the present step, which is made once more. */
  async captured(): Promise<Uint8Array[]> {
    const frames: Uint8Array[] = [], { begun, steps } = this, inputs = new Inputs();
    inputs.list = this.inputs.upTo(steps);
    const bodies = this.scene.bodies.map((body, i) => ({ ...body, material: begun ? begun.materials[i] : body.material }));
    const run = new Run({ ...this.scene, bodies });
    try {
      const { subSteps, warmStart, gravity } = begun ?? { ...this, gravity: this.pulled };
      run.play({ subSteps, warmStart, gravity: gravity ?? this.own }, (bytes) => frames.push(bytes));
      for (let step = 0, until = performance.now() + slice; step < steps; step++) {
        for (const input of inputs.at(step)) act(run, input);
        const pull = inputs.pullAt(step);
        if (pull) run.pull(pull.body, pull.to);
        this.lead(run, step + 1);
        run.step(frame);
        if (performance.now() < until) continue;
        await new Promise(requestAnimationFrame);
        until = performance.now() + slice;
      }
    } finally {
      run.dispose();
    }
    return frames;
  }

  /** Calls `act` before every picture, until it is stopped. */
  private tick(act: () => void): void {
    const each = (): void => {
      this.ticking = requestAnimationFrame(each);
      act();
    };
    this.ticking = requestAnimationFrame(each);
    this.listener.onRunning(true);
  }
  private attempt(what: () => void): void {
    try {
      what();
    } catch (error) {
      this.stop();
      this.listener.onTrouble((error as Error).message);
    }
  }
  /** Begins the simulation where it has not begun. */
  private start(): void {
    if (this.run.played) return;
    const { subSteps, warmStart, pulled: gravity, scene } = this;
    this.begun = { subSteps, warmStart, gravity, materials: scene.bodies.map(({ material }) => material) };
    this.run.play({ subSteps, warmStart, gravity: this.gravity });
    this.reach();
  }
  /** Goes on towards the goal, until a picture is due. */
  private approach(): void {
    const { steps } = this.goal!;
    for (const until = performance.now() + slice; this.steps < steps && performance.now() < until;) this.onward();
    if (this.steps >= steps) this.stop();
  }
  /** Makes a step, or goes on to the next that was made. `hidden`: another step follows before anything is drawn. */
  private forward(hidden = false): void {
    this.attempt(() => {
      this.start();
      if (this.steps < this.last) this.seek(this.steps + 1);
      else this.onward();
      if (!hidden) this.listener.onStep();
    });
  }
  /** Restores the state of a step, from an earlier one where it was not kept. */
  private seek(step: number): void {
    const [at, state] = this.kept.upTo(step);
    this.run.restore(state);
    this.steps = at;
    this.settle();
    while (this.steps < step) this.onward();
  }
  /** Sets what a state does not hold. */
  private settle(): void {
    const inputs = this.inputs.upTo(this.steps), { begun, scene } = this;
    this.pulled = inputs.findLast((one): one is Extract<Input, { kind: "gravity" }> => one.kind === "gravity")?.gravity ?? begun!.gravity;
    this.run.setGravity(this.gravity);
    for (const body of new Set(this.inputs.list.flatMap((one) => (one.kind === "material" ? [one.body] : [])))) {
      const set = inputs.findLast((one): one is Extract<Input, { kind: "material" }> => one.kind === "material" && one.body === body)?.material ?? begun!.materials[body];
      this.run.setMaterial(body, set ?? {}, false);
      scene.bodies[body].material = set;
    }
  }
  /** Sends the bodies that follow the animation to where they are after so many steps. */
  private lead(run: Run, steps: number): void {
    if (this.follows) run.follow(followersAt(this.follows.animation, this.follows.from + steps * frame, this.scene.bodies), frame);
  }
  private onward(): void {
    const { pull, run } = this;
    if (pull) run.pull(pull.body, pull.to);
    this.lead(run, this.steps + 1);
    const start = performance.now();
    const { energy, deepest, stages } = run.step(frame);
    this.stages = stages;
    this.stepTime = performance.now() - start;
    this.steps++;
    this.energy[this.steps - 1] = energy;
    this.depth[this.steps - 1] = deepest;
    this.events[this.steps] = sorted(run.events());
    this.last = Math.max(this.last, this.steps);
    this.reach();
  }
  /** Does what was done at this step of a run that is repeated, and keeps its state. */
  private reach(): void {
    const inputs = this.inputs.at(this.steps);
    for (const input of inputs) {
      act(this.run, input);
      if (input.kind === "gravity") this.pulled = input.gravity;
    }
    if (this.kept.wants(this.steps)) this.kept.keep(this.steps, this.run.save());
  }
  private forget(): void {
    this.kept.clear(0);
    this.inputs.list = [];
    this.begun = null;
    this.energy = [];
    this.depth = [];
    this.events = [];
    this.steps = this.last = 0;
  }
}
