// The buttons beside a lesson's drawing: one of several values, and the bits of a number. They are made once, so that
// the focus and a row that was pushed aside stay where they are when the state changes.

import { h } from "./dom.ts";
import type { State } from "../question.ts";

type Value = number | string | boolean;

export interface Choice {
  key: string;
  label: string;
  options: { value: Value; label: string }[];
  /** The value where the state has none; default: the first. */
  usual?: Value;
}

/** A number of the state whose bits are switched one by one. */
export interface Bits {
  key: string;
  label: string;
  /** The meaning of each bit, the lowest first. */
  names: string[];
}

export class Choices {
  readonly element = h("div", { class: "choices" });
  /** What each button shows of a state. */
  private readonly shows: ((state: State) => void)[] = [];
  private readonly onChoose: (key: string, value: Value) => void;

  constructor(choices: Choice[], bits: Bits[], onChoose: (key: string, value: Value) => void) {
    this.onChoose = onChoose;
    this.element.append(...choices.map((choice) => this.choice(choice)));
    if (bits.length > 0) this.element.append(h("div", { class: "bit-rows" }, ...bits.map((of) => this.bits(of))));
  }
  show(state: State): void {
    for (const show of this.shows) show(state);
  }

  private choice({ key, label, options, usual = options[0].value }: Choice): HTMLElement {
    const row = h("fieldset", {}, h("legend", {}, label));
    for (const option of options) {
      const button = h("button", { type: "button", onclick: () => this.onChoose(key, option.value) }, option.label);
      this.shows.push(({ choice }) => {
        const chosen = (choice?.[key] ?? usual) === option.value;
        button.setAttribute("aria-pressed", String(chosen));
        if (chosen) requestAnimationFrame(() => reveal(row, button)); // once the page is laid out
      });
      row.append(button);
    }
    return row;
  }
  /** A number's bits, the highest first as it is written. */
  private bits({ key, label, names }: Bits): HTMLElement {
    let now = 0;
    const bit = (name: string, i: number): HTMLElement => {
      const button = h("button", { type: "button", "data-bit": `${key}-${i}`, title: name,
        onclick: () => this.onChoose(key, now ^ (1 << i)) });
      this.shows.push(({ choice }) => {
        now = Number(choice?.[key] ?? 0);
        const set = (now >> i) % 2 === 1;
        button.setAttribute("aria-pressed", String(set));
        button.textContent = set ? "1" : "0";
        button.setAttribute("aria-label", `${label}: ${name}, ${button.textContent}`); // the name holds what is seen
      });
      return button;
    };
    return h("fieldset", { class: "bits" }, h("legend", {}, label), ...names.map(bit).reverse());
  }
}

/** Pushes a row that is wider than the page so far that a button of it is seen. */
function reveal(row: HTMLElement, button: HTMLElement): void {
  const outer = row.getBoundingClientRect(), inner = button.getBoundingClientRect();
  if (inner.left < outer.left || inner.right > outer.right) row.scrollLeft += inner.left - outer.left;
}
