// The columns beside a drawing, to its left and to its right. On a phone both are a drawer, closed at first: the
// drawing is alone until somebody opens it.

import { button, h } from "./dom.ts";

export interface Drawer {
  left: HTMLElement;
  side: HTMLElement;
  /** Opens and closes both; it is not there where they have room. */
  handle: HTMLElement;
}
export function drawer(before: Node[], after: Node[]): Drawer {
  const left = h("div", { class: "left drawer", id: "drawer-left" }, ...before), side = h("div", { class: "side drawer", id: "drawer" }, ...after);
  const toggle = (): void => {
    const open = side.classList.toggle("open");
    left.classList.toggle("open", open);
    handle.setAttribute("aria-expanded", String(open));
  };
  const handle = button("Bodies and properties", toggle,
    { class: "drawer-handle", "aria-controls": "drawer-left drawer", "aria-expanded": "false" });
  return { left, side, handle };
}
