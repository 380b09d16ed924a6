// What stands beside a drawing. On a phone it is a drawer, closed at first: the drawing is alone until somebody opens it.

import { button, h } from "./dom.ts";

export interface Drawer {
  side: HTMLElement;
  /** Opens and closes it; there is none where both have room. */
  handle: HTMLElement;
}
export function drawer(...content: Node[]): Drawer {
  const side = h("div", { class: "side drawer", id: "drawer" }, ...content);
  const handle = button("Bodies and properties", () => handle.setAttribute("aria-expanded", String(side.classList.toggle("open"))),
    { class: "drawer-handle", "aria-controls": "drawer", "aria-expanded": "false" });
  return { side, handle };
}
