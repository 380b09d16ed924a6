// The facts about the selected bodies of a scene or of a frame: about one its properties, about two their relation, and
// the question for it.

import { ask, line } from "../graze.ts";
import { button, digits, h, sentence, vector } from "../parts/dom.ts";
import { featureWords } from "../parts/features.ts";
import { address, copy } from "../parts/state.ts";
import { Table } from "../parts/table.ts";
import type { Question } from "../question.ts";
import { unmet } from "./meeting.ts";
import type { SceneBody, Tie } from "./model.ts";
import { lessonsOf, type AskedPair } from "./pair.ts";
import { propertiesOf, type Partner } from "./properties.ts";
import type { Run } from "./run.ts";
import type { Shot } from "./shots.ts";

/** Bodies, of which none, one or two are selected. */
export interface Selection {
  run: Run;
  bodies: SceneBody[];
  joints?: Tie[];
  selected: number[];
  /** The relation of two selected bodies. */
  pair: AskedPair | null;
  /** The pairs of a body that were found. */
  partners: (body: number) => Partner[];
  /** The poses at which they were found. */
  when: string;
  /** The bodies that sleep; null where nothing is played. */
  asleep: ReadonlySet<number> | null;
}

export class Inquiry {
  readonly info = h("div", { class: "words", "aria-live": "polite" });
  readonly table = new Table();
  readonly element: HTMLElement;
  private readonly asked = h("textarea", { rows: 3, spellcheck: "false", "aria-label": "A question of the protocol" }) as HTMLTextAreaElement;

  /** `onAsk` gets the question that somebody wrote, `onTrouble` the fault in it. */
  constructor(onAsk: (question: Question) => void, onTrouble: (text: string) => void) {
    const askIt = (): void => {
      try {
        onAsk(JSON.parse(this.asked.value) as Question);
      } catch (error) {
        onTrouble((error as Error).message);
      }
    };
    this.element = h("details", {}, h("summary", {}, "As a question"), this.asked,
      h("p", { class: "actions" }, button("Copy", () => copy(this.asked.value).catch((error: Error) => onTrouble(error.message))), button("Ask it", askIt)));
  }

  tell(title: string, words: string, ...more: Node[]): void {
    this.info.replaceChildren(h("h2", {}, title), h("p", {}, words), ...more);
  }
  /** Puts the line of a question where it can be copied. */
  offer(question: Question): void {
    this.asked.value = line(question);
  }
  /** Shows the answer to what was aimed at, and its question. */
  answer({ title, words, question }: Shot): void {
    this.tell(title, words);
    if (question) this.offer(question);
  }
  show(of: Selection | null): void {
    const [first] = of?.selected ?? [];
    if (!of || first === undefined) {
      this.tell("Select a body", "Click one, or a pair of the table, to see why two touch or do not.");
      this.table.show(undefined);
    } else if (!of.pair) {
      this.tell(of.bodies[first].name, "Click another to see what the two have to do with each other.");
      this.table.show(propertiesOf(of.run, of.bodies[first], first, of.partners(first), of.when, of.asleep));
    } else {
      this.explain(of, of.pair);
    }
  }
  private explain(of: Selection, { bodies: [i, j], question, distance }: AskedPair): void {
    const { bodies } = of, answer = ask(question), why = unmet(of, i, j, of.asleep !== null);
    const touch = !answer.overlap ? "They are apart" : why ? "They overlap" : "They touch";
    this.tell(`${bodies[i].name} and ${bodies[j].name}`,
      answer.error ?? distance.error ?? `${touch}: signed distance ${digits(distance.distance, 6)}, normal ${vector(distance.normal, 4)}. ${sentence(distance.trace.reason ?? distance.trace.method)}`,
      ...(why ? [h("p", {}, why)] : []),
      ...lessonsOf(question, distance.trace).map(({ lesson, shows, state }) =>
        h("p", {}, h("a", { href: address(`/lesson/${lesson}`, { s: JSON.stringify(state) }) }, `Step through ${shows}`))));
    this.offer(question);
    this.table.show({ caption: "Points of the pair", columns: ["features", "distance"],
      rows: (answer.manifolds ?? []).flatMap((m) => m.points).map((p, k) => ({ cells: [featureWords(p.feature, question.dimension), p.distance], key: `point ${k}` })) });
  }
}
