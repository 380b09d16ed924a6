// The events of a run: pairs that begin to touch, go on, and part, by the step in which they do.

import { h } from "../parts/dom.ts";
import type { Pair } from "./run.ts";

/** An event between two bodies, by their numbers. */
export interface ContactEvent extends Pick<Pair, "a" | "b"> {
  kind: "begin" | "stay" | "end";
  trigger: boolean;
}
/** The events of a step but for those of pairs that go on, which are counted. */
export interface StepEvents {
  changes: ContactEvent[];
  stay: number;
}
/** The events of one step, sorted. */
export function sorted(events: ContactEvent[]): StepEvents {
  const changes = events.filter(({ kind }) => kind !== "stay");
  return { changes, stay: events.length - changes.length };
}

/** The number of the last events that are listed, and that of steps that are looked through for them. */
const mostListed = 12, mostSteps = 600;

const words: Record<ContactEvent["kind"], (one: string, other: string, trigger: boolean) => string> = {
  begin: (one, other, trigger) => (trigger ? `${one} × ${other}: begins, a trigger` : `${one} × ${other}: begins`),
  stay: (one, other) => `${one} × ${other}: stays`,
  end: (one, other, trigger) => (trigger ? `${one} × ${other}: ends, a trigger` : `${one} × ${other}: ends`),
};

/** The last events up to a step, the latest first, as a list. */
export class EventList {
  readonly element = h("div", { class: "events" });
  private readonly word: string;

  /** `word`: "step" or "frame". */
  constructor(word: string) {
    this.word = word;
  }
  show(at: number, of: (step: number) => StepEvents | undefined, name: (body: number) => string): void {
    const lines: string[] = [];
    for (let step = at; step >= 0 && step > at - mostSteps && lines.length < mostListed; step--)
      for (const { kind, trigger, a, b } of of(step)?.changes ?? []) lines.push(`${this.word} ${step}: ${words[kind](name(a), name(b), trigger)}`);
    const stay = of(at)?.stay ?? 0;
    this.element.replaceChildren(
      h("p", {}, `${stay} ${stay === 1 ? "contact goes" : "contacts go"} on in this ${this.word}.`),
      ...(lines.length > 0 ? [h("ul", {}, ...lines.slice(0, mostListed).map((line) => h("li", {}, line)))] : []));
  }
}
