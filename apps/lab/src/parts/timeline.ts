// Steps forward, back, to either end, at a speed, or scrubbed: of a trace, a simulation, a capture.

import { h } from "./dom.ts";

/** The speeds, of which the first is usual. */
export const speeds = [1, 0.125, 0.25, 0.5, 2, 4];
const speedWords = new Map([[0.125, "⅛ ×"], [0.25, "¼ ×"], [0.5, "½ ×"], [1, "1 ×"], [2, "2 ×"], [4, "4 ×"]]);
export const speedSelect = (): HTMLSelectElement =>
  h("select", { class: "speed", "aria-label": "Speed of play", title: "Speed of play" },
    ...[...speedWords].map(([value, text]) => h("option", { value, selected: value === 1 }, text))) as HTMLSelectElement;

/** A slider through so many steps, and the words beside it. */
export class Scrub {
  readonly slider: HTMLInputElement;
  readonly where: HTMLElement;

  /** `onScrub`: called with the step that was chosen, `onDone` once somebody let it go. `spoken`: whether a screen
   *  reader says each change of the words, which is too much where they change with every picture. */
  constructor(word: string, spoken: boolean, onScrub: (step: number) => void, onDone: () => void = () => {}) {
    this.where = h(spoken ? "output" : "span", { class: "where" });
    this.slider = h("input", { type: "range", min: 0, max: 0, step: 1, "aria-label": `Which ${word}`,
      oninput: () => onScrub(Number(this.slider.value)), onchange: onDone }) as HTMLInputElement;
  }
  show(at: number, from: number, to: number, words: string): void {
    this.slider.min = String(from);
    this.slider.max = String(to);
    this.slider.value = String(at);
    this.where.textContent = words;
  }
}

/** The words and the names of a timeline's parts, where they are others than usual. */
export interface TimelineWords {
  /** What a step is called. */
  word?: string;
  /** What the next step's button says. */
  next?: string;
  /** The names by which the buttons forward and back are found. */
  marks?: [next: string, back: string];
  /** The words beside the slider. */
  where?: (at: number, count: number) => string;
  /** Whether a screen reader says each change of them. */
  spoken?: boolean;
}

export class Timeline {
  readonly element: HTMLElement;
  private count = 1;
  private at = 0;
  private timer: number | undefined;
  /** The speed as a multiple of the usual one. */
  private pace = 1;
  private readonly onStep: (step: number) => void;
  private readonly period: number;
  private readonly scrub: Scrub;
  private readonly back: HTMLButtonElement;
  private readonly words: (at: number, count: number) => string;
  private readonly next: HTMLButtonElement;
  private readonly play: HTMLButtonElement;
  private readonly speeds = speedSelect();

  /** `period`: milliseconds from one step to the next while it plays. `onSpeed`: called when another speed was
   *  chosen. */
  constructor(onStep: (step: number) => void, { word = "step", next = `Next ${word}`, marks = ["data-next", "data-previous"], where = (at, count) => `${at + 1} / ${count}`, spoken = true }: TimelineWords = {},
    period = 900, onSpeed: () => void = () => {}) {
    this.onStep = onStep;
    this.period = period;
    this.words = where;
    const button = (label: string, sign: string, act: () => void, more = {}): HTMLButtonElement =>
      h("button", { type: "button", "aria-label": label, title: label, onclick: act, ...more }, sign) as HTMLButtonElement;
    this.scrub = new Scrub(word, spoken, (step) => this.go(step));
    this.play = button("Play", "▶", () => this.toggle());
    this.next = h("button", { type: "button", class: "accent", [marks[0]]: true, onclick: () => this.go(this.at + 1) }, next) as HTMLButtonElement;
    this.back = button(`Previous ${word}`, "◀", () => this.go(this.at - 1), { [marks[1]]: true });
    this.element = h("div", { class: "timeline", role: "group", "aria-label": "Steps" },
      button(`First ${word}`, "|◀", () => this.go(0)),
      this.back,
      this.play,
      button(`Last ${word}`, "▶|", () => this.go(this.count - 1)),
      this.scrub.slider, this.scrub.where, this.speeds, this.next);
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
    const words = this.words(to, count);
    if (to === this.at && count === this.count && this.scrub.where.textContent === words) return; // as in most frames of a drag
    this.count = count;
    this.at = to;
    this.scrub.show(to, 0, count - 1, words);
    this.back.disabled = to <= 0;
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
