// The controls of a scene's animations: which one, its time, and that it plays.

import { button, h } from "../parts/dom.ts";
import { Scrub } from "../parts/timeline.ts";
import type { Animated, Animation } from "./animation.ts";

/** The number of places of the slider for each second. */
const rate = 60;

export class AnimationBar {
  readonly element: HTMLElement;
  private readonly choice: HTMLSelectElement;
  private readonly toggle: HTMLButtonElement;
  private readonly scrub: Scrub;
  private animations: Animation[] = [];
  private at: Animated = { number: 0, time: 0 };
  private speed = 1;
  private ticking = 0;
  private readonly onTime: (at: Animated) => void;

  /** `onTime` gets the animation and its time while these change, `onDone` is called once they stay. */
  constructor(onTime: (at: Animated) => void, onDone: () => void) {
    this.onTime = onTime;
    this.choice = h("select", { "aria-label": "Animation", "data-animation": true,
      onchange: () => (this.stop(), onTime({ number: Number(this.choice.value), time: 0 }), onDone()) }) as HTMLSelectElement;
    this.scrub = new Scrub("moment of the animation", false, (step) => (this.stop(), onTime({ ...this.at, time: this.timeOf(step) })), onDone);
    this.toggle = button("Play the animation", () => (this.ticking ? (this.stop(), onDone()) : this.start()), { "data-animate": true }) as HTMLButtonElement;
    this.element = h("div", { class: "timeline", role: "group", "aria-label": "Animation", hidden: true }, this.toggle, this.choice, this.scrub.slider, this.scrub.where);
  }
  /** Sets the animations of a scene. */
  set(animations: Animation[]): void {
    this.stop();
    this.animations = animations;
    this.element.hidden = animations.length === 0;
    this.choice.hidden = animations.length < 2;
    this.choice.replaceChildren(...animations.map(({ name }, i) => h("option", { value: i }, name)));
  }
  show(at: Animated | null, speed: number): void {
    this.at = at ?? { number: 0, time: 0 };
    this.speed = speed;
    if (this.animations.length === 0) return;
    const { duration, name } = this.now, { time } = this.at;
    this.choice.value = String(this.at.number);
    this.scrub.show(Math.round(time * rate), 0, Math.ceil(duration * rate), `${this.animations.length > 1 ? "" : `${name}: `}${time.toFixed(2)} / ${duration.toFixed(2)} s`);
  }
  get running(): boolean {
    return this.ticking !== 0;
  }
  stop(): void {
    cancelAnimationFrame(this.ticking);
    this.ticking = 0;
    this.toggle.textContent = "Play the animation";
  }

  private get now(): Animation {
    return this.animations[this.at.number];
  }
  /** The last place of the slider is the end, also where that lies between two places. */
  private timeOf(step: number): number {
    return Math.min(step / rate, this.now.duration);
  }
  /** Plays from the present time, round and round. */
  private start(): void {
    let before = performance.now();
    const each = (now: number): void => {
      this.ticking = requestAnimationFrame(each);
      const time = this.at.time + (Math.max(0, now - before) / 1000) * this.speed, { duration } = this.now;
      before = now;
      this.onTime({ ...this.at, time: duration > 0 ? time % duration : 0 });
    };
    this.ticking = requestAnimationFrame(each);
    this.toggle.textContent = "Pause the animation";
  }
}
