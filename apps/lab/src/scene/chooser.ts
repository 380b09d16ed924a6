// The bodies by name: two lists to choose from without pointing, and a foldable list of all.

import { button, h } from "../parts/dom.ts";
import { fold } from "../parts/fold.ts";
import type { SceneBody } from "./model.ts";

/** The part of a body that the lists show. */
export type Named = Pick<SceneBody, "name" | "moves" | "trigger">;

/** The number of bodies above which the list is no help. */
const mostListed = 300;

export class Chooser {
  /** The whole element: the two to choose, and the list. */
  readonly tree: HTMLElement;
  private readonly element: HTMLElement;
  private readonly selects: HTMLSelectElement[];
  private readonly branches = h("div", { class: "tree" });
  private readonly count = h("span", {}, "Bodies");
  private names = new Map<number, HTMLButtonElement>();
  private selected: number[] = [];
  private readonly onSelect: (selected: number[]) => void;

  constructor(onSelect: (selected: number[]) => void) {
    this.onSelect = onSelect;
    this.selects = [0, 1].map((k) => h("select", { "aria-label": k ? "Another body" : "A body", "data-body": k,
      onchange: () => onSelect([...new Set(this.selects.filter((s) => s.value !== "").map((s) => Number(s.value)))]) }) as HTMLSelectElement);
    this.element = h("div", { class: "choices" }, ...this.selects);
    this.tree = fold("bodies", this.count, this.element, this.branches);
  }
  /** Sets the bodies. */
  set(bodies: Named[]): void {
    for (const [k, select] of this.selects.entries())
      select.replaceChildren(h("option", { value: "" }, k ? "no other body" : "no body"), ...bodies.map((b, i) => h("option", { value: i }, b.name)));
    this.count.textContent = `${bodies.length} bodies`;
    this.names = new Map(bodies.slice(0, mostListed).map(({ name }, i) =>
      [i, button(name, () => this.onSelect(toggled(this.selected, i)), { "aria-pressed": "false" })]));
    const branch = (title: string, is: (body: Named) => boolean): Node | null => {
      const found = [...this.names].filter(([i]) => is(bodies[i]));
      return found.length > 0 ? h("details", { open: true }, h("summary", {}, `${found.length} ${title}`), h("ul", {}, ...found.map(([, name]) => h("li", {}, name)))) : null;
    };
    const branches = [branch("move", (b) => b.moves), branch("stand", (b) => !b.moves && !b.trigger), branch("triggers", (b) => !b.moves && Boolean(b.trigger))];
    this.branches.replaceChildren(...branches.filter((x) => x !== null));
    if (bodies.length > mostListed) this.branches.append(h("p", {}, `The first ${mostListed}.`));
  }
  show(selected: number[]): void {
    this.selected = selected;
    this.selects.forEach((select, k) => (select.value = String(selected[k] ?? "")));
    for (const [i, name] of this.names) name.setAttribute("aria-pressed", String(selected.includes(i)));
  }
}

/** The selection after a click on a body: it is added or removed, and the last two stay. */
export function toggled(selected: number[], body: number | null): number[] {
  if (body === null) return [];
  return selected.includes(body) ? selected.filter((x) => x !== body) : [...selected, body].slice(-2);
}
