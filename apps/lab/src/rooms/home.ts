// The first page: the three rooms and the list of lessons.

import { lessons } from "../lessons/index.ts";
import { h } from "../parts/dom.ts";
import { address } from "../parts/state.ts";
import type { Room } from "./room.ts";

export class Home implements Room {
  readonly element = h("article", { class: "home" },
    h("h1", {}, "The lab"),
    h("p", { class: "intro" },
      "Collision detection that you can see and touch. Every number here is computed by the Graze library in your browser; " +
      "whatever you see can be copied as a question that graze query answers with the same bits."),
    h("p", {}, h("a", { href: address("/scene", {}) }, "Viewer and playground"),
      ": drop a glTF, OBJ, STL, PLY, SVG or capture, drag bodies, see what touches and why, and play it."),
    h("h2", {}, "Lessons"),
    h("ol", { class: "lessons" },
      ...lessons.map((l) =>
        h("li", {},
          h("a", { href: address(`/lesson/${l.id}`, {}) },
            h("span", { class: "number" }, String(l.number)),
            h("span", { class: "title" }, l.title),
            h("span", { class: "asks" }, l.question))))));
  dispose(): void {}
}
