// The steps of the library's search for a pair's distance, drawn by its own trace drawing onto the scene: the axes that
// were tried, or the iterations of GJK and then of EPA, whose Minkowski difference is drawn about A's place.

import type { graze, Trace } from "../graze.ts";
import { onto } from "../parts/answers.ts";
import { button, digits, h } from "../parts/dom.ts";
import type { Drawing } from "../parts/drawing.ts";
import { add, scale } from "../parts/vec.ts";
import type { Vec } from "../question.ts";
import type { AskedPair } from "./pair.ts";
import type { Run } from "./run.ts";

/** A step in words, in the order in which the library counts them; none behind the last. */
function wordsOf({ axes, gjk, epa }: Trace, step: number): string {
  if (step < axes.length) {
    const { name, overlap } = axes[step];
    return `Axis ${name}: ${overlap >= 0 ? "overlap" : "gap"} ${digits(Math.abs(overlap), 5)}`;
  }
  const iteration = gjk[step - axes.length], expansion = epa[step - axes.length - gjk.length];
  if (iteration) return `GJK, iteration ${step - axes.length + 1}: distance of the cores from ${digits(iteration.lower, 5)} to ${digits(iteration.upper, 5)}`;
  return `EPA, expansion ${step - axes.length - gjk.length + 1}: depth from ${digits(expansion.faceDepth, 5)} to ${digits(expansion.foundDepth, 5)}`;
}
const countOf = ({ axes, gjk, epa }: Trace): number => axes.length + gjk.length + epa.length;

export class TraceSteps {
  readonly element = h("div", { class: "actions trace-steps", role: "group", "aria-label": "Steps of the answer", hidden: true });
  private readonly words = h("output", {});
  private readonly forward: HTMLButtonElement;
  private readonly back: HTMLButtonElement;
  private bodies = "";
  /** The step that is drawn; none is before the first. */
  private step = -1;
  private trace: Trace | null = null;

  /** `onStep`: called when another step is to be drawn. */
  constructor(onStep: () => void) {
    const go = (by: number) => (): void => {
      this.step += by;
      this.show(this.trace, this.bodies);
      onStep();
    };
    this.back = button("Step back in its trace", go(-1), { "data-trace-back": true });
    this.forward = button("Next step of its trace", go(1), { "data-trace-next": true });
    this.element.append(this.back, this.forward, this.words);
  }
  /** The selected pair, if any; the step stays while it is the same. */
  take(pair: AskedPair | null): void {
    this.show(pair?.distance.trace ?? null, pair ? pair.bodies.join(" ") : "");
  }
  draw(d: Drawing, run: Run, pair: AskedPair, size: number): void {
    if (this.step < 0 || !this.trace) return;
    const [a, b] = pair.bodies.map((i) => run.place(i).translation), { axes, gjk, epa } = this.trace;
    const isAxis = this.step < axes.length, by: Vec = isAxis ? [0, 0, 0] : a;
    const on = onto(d, { size, center: isAxis ? scale(add(a, b), 0.5) : [0, 0, 0], look: { wide: true }, as: { a: "made", ruledOut: "out" } });
    run.drawStep(pair.bodies, this.step, shifted(on, by));
    const found = (gjk[this.step - axes.length] ?? epa[this.step - axes.length - gjk.length])?.found;
    if (!found) return;
    d.point(inSpace(found.a), "made", { wide: true });
    d.point(inSpace(found.b), "b", { wide: true });
  }
  private show(trace: Trace | null, bodies: string): void {
    const count = trace ? countOf(trace) : 0;
    if (bodies !== this.bodies) this.step = -1;
    this.step = Math.min(this.step, count - 1);
    this.bodies = bodies;
    this.trace = trace;
    this.element.hidden = count === 0;
    this.back.disabled = this.step < 0;
    this.forward.disabled = this.step >= count - 1;
    this.words.textContent = trace && this.step >= 0 ? `${this.step + 1} / ${count}. ${wordsOf(trace, this.step)}` : `${count} steps`;
  }
}

const inSpace = ([x, y, z = 0]: Vec): Vec => [x, y, z];
/** A renderer that draws everything elsewhere. */
function shifted(on: graze.Renderer, by: Vec): graze.Renderer {
  return { ...on,
    point: (at, ...rest) => on.point!(add(at, by), ...rest), line: (from, to, ...rest) => on.line!(add(from, by), add(to, by), ...rest),
    arrow: (from, ...rest) => on.arrow!(add(from, by), ...rest), text: (at, ...rest) => on.text!(add(at, by), ...rest) };
}
