// The numbers beside a drawing. Rows light up with the part of the drawing under the pointer, and the other way round.

import { digits, h, update, vector } from "./dom.ts";

export interface Row {
  /** Words, and numbers and vectors, which are shown with some of their digits and have all of them in the title. */
  cells: (string | number | number[])[];
  key?: string;
  mark?: "winner" | "out" | "now";
  /** Selects the thing that the row is about: its first cell is then a button. */
  choose?: () => void;
}
export interface Numbers {
  caption: string;
  /** The heading of each column; none is empty. */
  columns: string[];
  rows: Row[];
}

/** What stands before a row that is marked, and what is said to those who do not see it. */
const marks = { winner: ["▸", "decides"], out: ["×", "ruled out"], now: ["•", "this step"] } as const;

export class Table {
  readonly element = h("div", { class: "numbers", tabindex: 0, role: "region", "aria-label": "Numbers of this step" });
  onPoint: (key: string | null) => void = () => {};
  private before = new Map<string, string>();
  private rows: Row[] = [];
  /** The key that lights up, and that of the row under the pointer. */
  private lit: string | null = null;
  private pointed: string | null = null;

  constructor() {
    const rowOf = ({ target }: Event): HTMLTableRowElement | null => (target as Element).closest("tbody tr");
    this.element.addEventListener("pointerover", (event) => this.point(rowOf(event)?.dataset.key ?? null));
    this.element.addEventListener("pointerleave", () => this.point(null));
    this.element.addEventListener("click", (event) => {
      const row = (event.target as Element).closest(".choose") && rowOf(event);
      if (row) this.rows[row.sectionRowIndex].choose!();
    });
  }
  private point(key: string | null): void {
    if (key !== this.pointed) this.onPoint((this.pointed = key));
  }

  show(numbers: Numbers | undefined): void {
    this.element.hidden = !numbers;
    this.rows = numbers?.rows ?? [];
    if (!numbers) {
      this.point(null);
      return this.element.replaceChildren();
    }
    const now = new Map<string, string>();
    const rows = numbers.rows.map((row, i) => {
      const cells = row.cells.map((cell, j) => {
        const text = typeof cell === "number" ? digits(cell) : typeof cell === "string" ? cell : vector(cell);
        const place = `${row.key ?? i}/${j}`;
        now.set(place, text);
        if (j === 0) return h("th", { scope: "row" }, row.choose ? h("button", { type: "button", class: "choose" }, text) : text);
        return h("td", { title: typeof cell === "string" ? null : String(cell) }, ...changed(this.before.get(place), text));
      });
      const classes = [row.mark && `is-${row.mark}`].filter(Boolean).join(" ");
      const [mark, says] = row.mark ? marks[row.mark] : ["", ""];
      return h("tr",
        { class: classes || null, "data-key": row.key },
        h("td", { class: "mark" }, h("span", { "aria-hidden": "true" }, mark), h("span", { class: "unseen" }, says)), ...cells);
    });
    this.before = now;
    update(this.element, [
      h("table", {},
        h("caption", {}, numbers.caption),
        h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "mark" }, h("span", { class: "unseen" }, "mark")), ...numbers.columns.map((c) => h("th", { scope: "col" }, c)))),
        h("tbody", {}, ...rows))]);
    this.light(this.lit);
    // Another row may have come below the pointer, which has not moved.
    if (this.pointed !== null) this.point(this.element.querySelector<HTMLTableRowElement>("tbody tr:hover")?.dataset.key ?? null);
  }

  light(key: string | null): void {
    this.lit = key;
    for (const row of this.element.querySelectorAll("tr[data-key]"))
      row.classList.toggle("lit", key !== null && row.getAttribute("data-key") === key);
  }
}

/** A number with the digits from the first that changed on marked. */
function changed(before: string | undefined, now: string): (Node | string)[] {
  if (before === undefined || before === now) return [now];
  let same = 0;
  while (same < now.length && now[same] === before[same]) same++;
  return same < now.length ? [now.slice(0, same), h("span", { class: "changed" }, now.slice(same))] : [now];
}
