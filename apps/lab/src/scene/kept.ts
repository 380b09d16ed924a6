// The states of a simulation that is played, to go back to: of the last second all, before it as many as a large scene
// has memory for. Those between are computed anew.

import type { graze } from "../graze.ts";

/** The number of steps that can be gone back: ten seconds. */
const longest = 600;
/** Scenes with more bodies keep every tenth state only, but for the last second. */
const large = 300, sparse = 10, dense = 60;

export class KeptStates {
  private readonly states = new Map<number, graze.State>();
  private bodies = 0;

  /** Forgets all states, for a scene with so many bodies. */
  clear(bodies: number): void {
    this.forgetFrom(-Infinity);
    this.bodies = bodies;
  }
  has(step: number): boolean {
    return this.states.has(step);
  }
  /** The earliest step that can be gone back to. */
  get first(): number {
    return this.states.keys().next().value ?? 0;
  }
  /** Keeps the state after so many steps, in place of the one that it had. */
  keep(step: number, state: graze.State): void {
    this.states.get(step)?.dispose();
    this.states.set(step, state);
    const old = step - dense;
    if (this.bodies > large && old % sparse !== 0) this.drop(old);
    for (const early of [...this.states.keys()].filter((one) => one < step - longest)) this.drop(early);
  }
  /** The latest state up to a step, and its step. */
  upTo(step: number): [number, graze.State] {
    const at = Math.max(...[...this.states.keys()].filter((one) => one <= step));
    return [at, this.states.get(at)!];
  }
  forgetFrom(step: number): void {
    for (const late of [...this.states.keys()].filter((one) => one >= step)) this.drop(late);
  }
  private drop(step: number): void {
    this.states.get(step)?.dispose();
    this.states.delete(step);
  }
}
