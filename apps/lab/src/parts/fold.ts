// A part of a page that can be folded, and stays as somebody left it.

import { h } from "./dom.ts";

function kept(): string[] {
  try {
    const ids = JSON.parse(localStorage.getItem("folded") ?? "[]") as unknown;
    return Array.isArray(ids) ? ids.filter((id) => typeof id === "string") : [];
  } catch {
    return []; // storage is forbidden, or another page's
  }
}
function keep(id: string, open: boolean): void {
  try {
    localStorage.setItem("folded", JSON.stringify([...kept().filter((other) => other !== id), ...(open ? [] : [id])]));
  } catch {
    // The part stays folded as long as the page.
  }
}

/** A part that is open until somebody folds it. Parts of one `id` share that, also on the next visit. */
export function fold(id: string, title: Node | string, ...content: Node[]): HTMLElement {
  const element = h("details", { class: "fold", "data-fold": id, open: !kept().includes(id),
    ontoggle: () => keep(id, element.open) }, h("summary", {}, title), ...content) as HTMLDetailsElement;
  return element;
}
