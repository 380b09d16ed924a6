// Steps forward, back, to either end, at a speed, or scrubbed: of a trace, a simulation, a capture.

import { h } from "./dom.ts";

/** The speeds, of which the first is usual. */
export const speeds = [1, 0.125, 0.25, 0.5, 2, 4];
const speedWords = new Map([[0.125, "⅛ ×"], [0.25, "¼ ×"], [0.5, "½ ×"], [1, "1 ×"], [2, "2 ×"], [4, "4 ×"]]);
export const speedSelect = (): HTMLSelectElement =>
  h("select", { class: "speed", "aria-label": "Speed of play", title: "Speed of play" },
    ...[...speedWords].map(([value, text]) => h("option", { value, selected: value === 1 }, text))) as HTMLSelectElement;

export class Timeline {
  readonly element: HTMLElement;
  private count = 1;
  private at = 0;
  private timer: number | undefined;
  /** The speed as a multiple of the usual one. */
  private pace = 1;
  private readonly onStep: (step: number) => void;
  private readonly period: number;
  private readonly scrub: HTMLInputElement;
  private readonly next: HTMLButtonElement;
  private readonly play: HTMLButtonElement;
  private readonly speeds = speedSelect();
  private readonly where = h("output", { class: "where" });

  /** `period`: milliseconds from one step to the next while it plays. `onSpeed`: called when another speed was
   *  chosen. */
  constructor(onStep: (step: number) => void, word = "step", period = 900, onSpeed: () => void = () => {}) {
    this.onStep = onStep;
    this.period = period;
    const button = (label: string, sign: string, act: () => void): HTMLButtonElement =>
      h("button", { type: "button", "aria-label": label, title: label, onclick: act }, sign) as HTMLButtonElement;
    this.scrub = h("input", {
      type: "range", min: 0, max: 0, step: 1, "aria-label": `Which ${word}`,
      oninput: () => this.go(Number(this.scrub.value)),
    }) as HTMLInputElement;
    this.play = button("Play", "▶", () => this.toggle());
    this.next = h("button", { type: "button", class: "accent", "data-next": true, onclick: () => this.go(this.at + 1) },
      `Next ${word}`) as HTMLButtonElement;
    this.element = h("div", { class: "timeline", role: "group", "aria-label": "Steps" },
      button(`First ${word}`, "|◀", () => this.go(0)),
      button(`Previous ${word}`, "◀", () => this.go(this.at - 1)),
      this.play,
      button(`Last ${word}`, "▶|", () => this.go(this.count - 1)),
      this.scrub, this.where, this.speeds, this.next);
    this.speeds.addEventListener("change", () => {
      this.speed = Number(this.speeds.value);
      onSpeed();
    });
  }
  get speed(): number {
    return this.pace;
  }
  set speed(pace: number) {
    this.pace = pace;
    this.speeds.value = String(pace);
    if (this.timer !== undefined) this.start();
  }

  show(at: number, count: number): void {
    const to = Math.max(0, Math.min(at, count - 1));
    if (to === this.at && count === this.count && this.where.textContent) return; // as in most frames of a drag
    this.count = count;
    this.at = to;
    this.scrub.max = String(count - 1);
    this.scrub.value = String(this.at);
    this.where.textContent = `${this.at + 1} / ${count}`;
    this.next.disabled = this.at >= count - 1;
    if (this.next.disabled) this.stop();
  }
  go(step: number): void {
    const to = Math.max(0, Math.min(step, this.count - 1));
    if (to !== this.at) this.onStep(to);
  }
  stop(): void {
    window.clearInterval(this.timer);
    this.timer = undefined;
    this.play.textContent = "▶";
    this.play.setAttribute("aria-label", "Play");
  }
  private toggle(): void {
    if (this.timer !== undefined) return this.stop();
    if (this.at >= this.count - 1) this.onStep(0);
    this.play.textContent = "❚❚";
    this.play.setAttribute("aria-label", "Pause");
    this.start();
  }
  /** Plays; steps faster than pictures are drawn are left out. */
  private start(): void {
    window.clearInterval(this.timer);
    const period = Math.max(this.period / this.pace, 1000 / 60), stride = Math.max(1, Math.round(period / (this.period / this.pace)));
    this.timer = window.setInterval(() => this.go(this.at + stride), period);
  }
}
