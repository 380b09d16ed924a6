// Something that follows a drag without slowing it: it takes a small share of the time, and comes late rather than to
// have the picture wait for it.

/** Followers take one part of so many of the time, not counted what the browser needs to lay out and paint them. */
const share = 48;
/** Milliseconds without another call after which a drag is taken to rest. */
const rest = 100;

export class Follower {
  private readonly act: () => void;
  private timer = 0;
  /** The time from which on it may be done again. */
  next = 0;

  constructor(act: () => void) {
    this.act = act;
  }
  /** Does it now. */
  now(): void {
    this.cancel();
    const start = performance.now();
    this.act();
    const end = performance.now();
    this.next = end + share * (end - start);
  }
  /** Does it with the first picture of a drag in which it may be done, so that the page is laid out once for both, or
   *  when the drag rests. */
  soon(): void {
    this.cancel();
    const wait = this.next - performance.now();
    if (wait <= 0) this.now();
    else this.timer = window.setTimeout(() => this.now(), Math.max(wait, rest));
  }
  cancel(): void {
    window.clearTimeout(this.timer);
  }
}
