// What somebody does to a simulation while it is played, by the step at which it is done: with it a run is repeated to
// the same bits.

import type { graze } from "../graze.ts";
import type { Vec } from "../question.ts";
import { isPlace, isVector } from "./checks.ts";
import type { Scene } from "./model.ts";
import type { Place, Run } from "./run.ts";

/** The spring that somebody holds a body by. */
export interface Pull {
  body: number;
  to: Vec;
}
export type Action =
  | { kind: "put"; body: number; place: Place }
  | { kind: "material"; body: number; material: graze.Material | graze.plane.Material }
  | { kind: "gravity"; gravity: Vec }
  | { kind: "pull"; pull: Pull | null };
/** An action after so many steps. */
export type Input = Action & { step: number };

const isBody = (value: unknown): boolean => Number.isInteger(value) && (value as number) >= 0;
function isInput(value: unknown): boolean {
  const { step, kind, ...of } = (value ?? {}) as Record<string, unknown>, pull = of.pull as Pull | null;
  return isBody(step) && ((kind === "put" && isBody(of.body) && isPlace(of.place)) || (kind === "material" && isBody(of.body) && typeof of.material === "object" && of.material !== null) ||
    (kind === "gravity" && isVector(of.gravity)) || (kind === "pull" && (pull === null || (isBody(pull?.body) && isVector(pull?.to)))));
}
/** Whether a value of an address is a list of inputs. */
export const areInputs = (value: unknown): value is Input[] => Array.isArray(value) && value.every(isInput);

/** The number of the body that an input is about: -1 where there is none. */
const bodyOf = (input: Input): number => (input.kind === "gravity" ? undefined : input.kind === "pull" ? input.pull?.body : input.body) ?? -1;
/** Those inputs whose bodies a scene has: an address may name any. */
export const possible = (inputs: Input[], { bodies }: Scene): Input[] => inputs.filter((input) => bodyOf(input) < bodies.length);

/** Does an action but for pulling, which is done anew in each step. */
export function act(run: Run, action: Action): void {
  if (action.kind === "put") run.put(action.body, action.place);
  else if (action.kind === "material") run.setMaterial(action.body, action.material);
  else if (action.kind === "gravity") run.setGravity(action.gravity);
}
const sameSubject = (a: Input, b: Input): boolean =>
  a.step === b.step && a.kind === b.kind && ("body" in a ? a.body : -1) === ("body" in b ? b.body : -1);

export class Inputs {
  list: Input[] = [];

  /** Adds an input, in place of one about the same at the same step. */
  add(input: Input): void {
    this.list = [...this.list.filter((one) => !sameSubject(one, input)), input];
  }
  forgetAfter(step: number): void {
    this.list = this.list.filter((one) => one.step <= step);
  }
  at(step: number): Input[] {
    return this.list.filter((one) => one.step === step);
  }
  /** The inputs that a run has had after so many steps. */
  upTo(step: number): Input[] {
    return this.list.filter((one) => one.step <= step);
  }
  pullAt(step: number): Pull | null {
    return this.list.findLast((one): one is Extract<Input, { kind: "pull" }> => one.kind === "pull" && one.step <= step)?.pull ?? null;
  }
}
