// The formulas of a step, one below the other. One whose text is as before stays as it is, and widths are asked for
// only while nothing is dragged: a browser takes longer to lay out MathML than to draw the picture beside it.

import { h, update } from "./dom.ts";
import { fit, formula } from "./math.ts";

export class Formulas {
  readonly element = h("div", { class: "formulas" });
  private texts: string[] = [];
  /** The formulas that have changed since they were fitted into their place. */
  private readonly changed = new Set<Element>();

  /** Shows formulas; `still` where they stay for a while, and are made to fit. */
  show(texts: string[], still: boolean): void {
    for (const surplus of [...this.element.children].slice(texts.length)) surplus.remove();
    texts.forEach((text, i) => {
      const made = text === this.texts[i] ? undefined : formula(text), there = this.element.children[i];
      if (!made) return;
      if (there) update(there, [...made.childNodes]);
      else this.element.append(made);
      this.changed.add(there ?? made);
    });
    this.texts = [...texts];
    if (!still) return;
    fit([...this.changed].filter((one) => one.isConnected) as HTMLElement[]);
    this.changed.clear();
  }
}
