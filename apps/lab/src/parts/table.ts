// The numbers beside a drawing. Rows light up with the part of the drawing under the pointer, and the other way round.

import { digits, h, vector } from "./dom.ts";

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

  show(numbers: Numbers | undefined): void {
    this.element.hidden = !numbers;
    if (!numbers) return this.element.replaceChildren();
    const now = new Map<string, string>();
    const rows = numbers.rows.map((row, i) => {
      const cells = row.cells.map((cell, j) => {
        const text = typeof cell === "number" ? digits(cell) : typeof cell === "string" ? cell : vector(cell);
        const place = `${row.key ?? i}/${j}`;
        now.set(place, text);
        if (j === 0) return h("th", { scope: "row" }, row.choose ? h("button", { type: "button", class: "choose", onclick: row.choose }, text) : text);
        return h("td", { title: typeof cell === "string" ? null : String(cell) }, ...changed(this.before.get(place), text));
      });
      const classes = [row.mark && `is-${row.mark}`].filter(Boolean).join(" ");
      const [mark, says] = row.mark ? marks[row.mark] : ["", ""];
      return h("tr",
        { class: classes || null, "data-key": row.key,
          onpointerenter: () => this.onPoint(row.key ?? null), onpointerleave: () => this.onPoint(null) },
        h("td", { class: "mark" }, h("span", { "aria-hidden": "true" }, mark), h("span", { class: "unseen" }, says)), ...cells);
    });
    this.before = now;
    this.element.replaceChildren(
      h("table", {},
        h("caption", {}, numbers.caption),
        h("thead", {}, h("tr", {}, h("th", { scope: "col", class: "mark" }, h("span", { class: "unseen" }, "mark")), ...numbers.columns.map((c) => h("th", { scope: "col" }, c)))),
        h("tbody", {}, ...rows)));
  }

  light(key: string | null): void {
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
