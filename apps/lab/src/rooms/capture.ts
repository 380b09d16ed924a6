// A capture: a run of a world or a simulation, frame by frame, forward, back and scrubbed.

import { digits, h } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { drawGraph } from "../parts/graph.ts";
import { Stage3 } from "../parts/stage3.ts";
import { Table } from "../parts/table.ts";
import { Timeline } from "../parts/timeline.ts";
import { add, scale } from "../parts/vec.ts";
import { moves, type Captured } from "../scene/captured.ts";
import type { Room } from "./room.ts";

const mostListed = 30;

export class CaptureRoom implements Room {
  readonly element: HTMLElement;
  private readonly stage = new Stage3();
  private readonly timeline = new Timeline((frame) => this.show(frame), "frame", 1000 / 60);
  private readonly pairs = new Table();
  private readonly plot = h("div", { class: "plot" });
  private readonly counter = h("p", { class: "counter", "aria-live": "polite" });
  private readonly captured: Captured;
  private frame = 0;

  constructor(name: string, captured: Captured) {
    this.captured = captured;
    const { report, scalar, bodies, frames } = captured;
    const kind = `${report.simulation ? "simulation" : "world"}${report.plane ? " of the plane" : ""} in ${scalar}`;
    const end = report.difference
      ? `From frame ${report.difference.frame} on it comes to something else: call ${report.difference.call}, ${report.difference.what}.`
      : report.cut ? "It ends within a frame, which is left out." : "It comes to the same bits.";
    this.pairs.onPoint = (key) => this.stage.light(key);
    this.stage.crowd.set(bodies.map((body, i) => ({ key: String(i), make: () => body.solid, flat: body.flat })), bodies.map((_, i) => (moves(captured, i) ? "a" : "out")));
    this.stage.look({ center: captured.center, reach: captured.size * 0.6, flat: report.plane });
    this.element = h("article", { class: "lesson" },
      h("header", {}, h("h1", {}, name), h("p", { class: "intro" }, `A ${kind}: ${frames.length} frames, played again. ${end}`)),
      h("div", { class: "board" },
        h("div", { class: "picture" }, this.stage.element, this.timeline.element, this.counter),
        h("div", { class: "side" }, this.plot, this.pairs.element)));
    this.show(0);
  }
  dispose(): void {
    this.timeline.stop();
    this.stage.dispose();
  }
  /** For the tests. */
  get shown(): { frame: number; frames: number; bodies: number; pairs: number } {
    const { frames } = this.captured, { there, pairs } = frames[this.frame];
    return { frame: this.frame, frames: frames.length, bodies: there.size, pairs: pairs.length };
  }

  private show(frame: number): void {
    this.frame = frame;
    const { frames } = this.captured, { poses, there, pairs } = frames[frame];
    this.timeline.show(frame, frames.length);
    this.stage.crowd.move(poses, there);
    this.stage.draw((d: Drawing) => {
      for (const { a, b, points } of pairs)
        for (const { at, normal, distance } of points) {
          d.point(at, distance <= 0 ? "touch" : "axis", { key: `${a} ${b}` });
          d.arrow(at, add(at, scale(normal, this.captured.size / 25)), "axis", { key: `${a} ${b}` });
        }
    }, [], `Frame ${frame + 1} of ${frames.length}: ${there.size} bodies, ${pairs.length} pairs.`);
    const points = pairs.reduce((sum, pair) => sum + pair.points.length, 0);
    this.counter.textContent = `${there.size} bodies · ${pairs.length} pairs · ${points} contacts`;
    this.pairs.show({
      caption: pairs.length > mostListed ? `The first ${mostListed} of ${pairs.length} pairs` : "Pairs in this frame", columns: ["pair", "points", "deepest"],
      rows: pairs.slice(0, mostListed).map(({ a, b, points: all }) => ({
        cells: [`${a} × ${b}`, all.length, all.length > 0 ? Math.min(...all.map((p) => p.distance)) : "inside"], key: `${a} ${b}` })),
    });
    this.plot.replaceChildren(drawGraph({ caption: "deepest penetration", at: frame,
      series: [{ name: digits(frames[frame].deepest, 3), meaning: "touch", values: frames.map((x) => x.deepest) }] }));
  }
}
