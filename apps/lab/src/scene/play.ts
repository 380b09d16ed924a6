// A scene in time: played, stepped, and stepped back through the last ten seconds.

import type { graze } from "../graze.ts";
import type { Vec } from "../question.ts";
import type { Scene } from "./model.ts";
import { Run, type Stages } from "./run.ts";

const frame = 1 / 60;
/** The number of states to step back to: ten seconds; fewer of large scenes. */
const mostStates = (bodies: number): number => (bodies > 300 ? 120 : 600);
const nothing: Scene = { name: "empty", bodies: [] };

export interface Listener {
  /** Called after every step, forward or back. */
  onStep(): void;
  onRunning(running: boolean): void;
  onTrouble(text: string): void;
}

export class Play {
  scene = nothing;
  run = new Run(nothing);
  subSteps = 8;
  /** Whether the scene's gravity acts. */
  heavy = true;
  /** The number of steps for each picture. */
  speed = 1;
  /** The energy and the depth of every step that can be gone back. */
  energy: number[] = [];
  depth: number[] = [];
  /** The time of the last step, in milliseconds, and of its parts. */
  stepTime = 0;
  stages: Stages | null = null;
  /** The spring that somebody holds a body by. */
  pull: { body: number; to: Vec } | null = null;
  private states: graze.State[] = [];
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
    return this.heavy ? (this.scene.gravity ?? [0, -9.81, 0]) : [0, 0, 0];
  }
  /** Opens another scene. Throws the library's errors; the scene is an empty one then. */
  open(scene: Scene): void {
    this.dispose();
    this.pull = null;
    this.scene = nothing;
    this.run = new Run(nothing);
    const made = new Run(scene);
    this.run.dispose();
    this.run = made;
    this.scene = scene;
  }
  /** Begins the scene anew, with its bodies where they were put. */
  begin(): void {
    this.open(this.scene);
  }
  toggle(): void {
    if (this.running) return this.stop();
    let due = 0;
    const tick = (): void => {
      this.ticking = requestAnimationFrame(tick);
      for (due += this.speed; due >= 1 && this.running; due--) this.advance(due >= 2);
    };
    this.ticking = requestAnimationFrame(tick);
    this.listener.onRunning(true);
  }
  stop(): void {
    cancelAnimationFrame(this.ticking);
    this.ticking = 0;
    this.listener.onRunning(false);
  }
  step(): void {
    this.stop();
    this.advance();
  }
  back(): void {
    this.stop();
    const state = this.states.pop();
    if (!state) return;
    this.run.restore(state);
    state.dispose();
    this.energy.pop();
    this.depth.pop();
    this.listener.onStep();
  }

  /** Makes a step. `hidden`: another step follows before anything is drawn. */
  private advance(hidden = false): void {
    try {
      this.run.play(this.subSteps, this.gravity);
      this.states.push(this.run.save());
      if (this.states.length > mostStates(this.scene.bodies.length)) this.states.shift()!.dispose();
      if (this.pull) this.run.pull(this.pull.body, this.pull.to);
      const start = performance.now();
      const { energy, deepest, stages } = this.run.step(frame);
      this.stages = stages;
      this.stepTime = performance.now() - start;
      this.energy.push(energy);
      this.depth.push(deepest);
      if (!hidden) this.listener.onStep();
    } catch (error) {
      this.stop();
      this.listener.onTrouble((error as Error).message);
    }
  }
  private forget(): void {
    for (const state of this.states) state.dispose();
    this.states = [];
    this.energy = [];
    this.depth = [];
  }
}
