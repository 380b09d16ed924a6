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
  /** Whether the state after so many steps is to be kept, and is not. */
  wants(step: number): boolean {
    return !this.states.has(step) && !this.isSpared(step, Math.max(...this.states.keys()));
  }
  /** The earliest step that can be gone back to. */
  get first(): number {
    return this.states.keys().next().value ?? 0;
  }
  /** Keeps the state after so many steps, in place of the one that it had. */
  keep(step: number, state: graze.State): void {
    this.states.get(step)?.dispose();
    this.states.set(step, state);
    const newest = Math.max(...this.states.keys());
    for (const old of [...this.states.keys()].filter((one) => one < newest - longest || this.isSpared(one, newest))) this.drop(old);
  }
  /** The latest state up to a step, and its step. */
  upTo(step: number): [number, graze.State] {
    const at = Math.max(...[...this.states.keys()].filter((one) => one <= step));
    return [at, this.states.get(at)!];
  }
  forgetFrom(step: number): void {
    for (const late of [...this.states.keys()].filter((one) => one >= step)) this.drop(late);
  }
  /** Whether a large scene has no room for a state, beside the newest. */
  private isSpared(step: number, newest: number): boolean {
    return this.bodies > large && step <= newest - dense && step % sparse !== 0;
  }
  private drop(step: number): void {
    this.states.get(step)?.dispose();
    this.states.delete(step);
  }
}
